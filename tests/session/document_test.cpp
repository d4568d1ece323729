#include "session/document.hpp"

#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "memory_host.hpp"

using namespace lancer;
using session::Document;
using session::Outcome;
using session::Reply;

namespace {

struct Talk {
  test::MemoryHost host;
  Document document{host};

  Reply say(const std::string& entry) { return document.enter(entry, {}); }
  std::string dump() const { return scene::dump(document.session().scene()); }
  std::string error(const Reply& reply) const {
    for (const Diagnostic& d : reply.run.diagnostics) {
      if (d.severity == Severity::error) return d.message;
    }
    return "";
  }
};

/// What the text gives in a document of its own.
std::string dump_of(const std::string& text) {
  Talk fresh;
  fresh.document.change(text, {});
  return fresh.dump();
}

}  // namespace

TEST_CASE("document: entries add up to a text", "[document]") {
  Talk t;
  CHECK(t.say("let r = 2").is_changed);
  CHECK(t.say("// a ball\nsphere \"ball\" { <0, 0, 0>, r }").is_changed);
  CHECK(t.document.text() == "let r = 2\n// a ball\nsphere \"ball\" { <0, 0, 0>, r }\n");
  CHECK(t.document.session().scene().spheres[0].radius == 2);
}

TEST_CASE("document: an expression shows its value and adds nothing", "[document]") {
  Talk t;
  t.say("let r = 2");
  const Reply reply = t.say("<r, r * 2, 0>");
  CHECK(reply.printed == "<2, 4, 0>\n");
  CHECK(reply.run.outcome == Outcome::fine);
  CHECK_FALSE(reply.is_changed);
  CHECK(t.say("\"text\"").printed == "text\n");
  CHECK(t.document.text() == "let r = 2\n");
}

TEST_CASE("document: a mistake anywhere in an entry leaves all as it was", "[document]") {
  Talk t;
  t.say("sphere \"a\" { <0, 0, 0>, 1 }");
  const std::string before = t.dump();
  for (const char* entry :
       {"sphere { <0, 0, 0>, 1 } sphere { <0, 0, 0>, -1 }", "let b = 1 c", "remove \"a\" let d = 1 / 0",
        "sphere { <0, 0, 0>, 1 } )", "let e = 1 / 0", "assert(false)"}) {
    INFO(entry);
    const Reply reply = t.say(entry);
    CHECK(reply.run.outcome == Outcome::script_wrong);
    CHECK_FALSE(reply.is_incomplete);
    CHECK(t.dump() == before);
    CHECK(t.document.text() == "sphere \"a\" { <0, 0, 0>, 1 }\n");
    CHECK(t.document.history().size() == 1);
  }
  CHECK(t.error(t.say("b")) == "nothing is called `b` here");
}

TEST_CASE("document: what is given again is built anew", "[document]") {
  Talk t;
  CHECK(t.say("let r = 1  // small").is_changed);
  t.say("fn made() { sphere \"a\" { <0, 0, 0>, r } }");
  t.say("made()");
  t.say("let r = 3");
  CHECK(t.document.session().scene().spheres[0].radius == 3);
  CHECK(t.document.text() == "let r = 3  // small\nfn made() { sphere \"a\" { <0, 0, 0>, r } }\nmade()\n");
  t.say("fn made() { sphere \"a\" { <1, 0, 0>, r } }");
  CHECK(t.document.session().scene().spheres[0].center == Vec3{1, 0, 0});
}

TEST_CASE("document: a named object given again replaces the old one", "[document]") {
  Talk t;
  t.say("sphere \"a\" { <0, 0, 0>, 1 }");
  t.say("sphere \"b\" { <0, 0, 0>, 1 }");
  t.say("cube \"a\" { center <0, 0, 0> side 1 }");
  CHECK(t.document.session().scene().shapes.size() == 2);
  CHECK(t.document.text().starts_with("cube \"a\""));
  t.say("for i in 0..3 { sphere \"bead {i}\" { <i, 0, 0>, 1 } }");
  t.say("sphere \"bead 1\" { <9, 9, 9>, 2 }");
  CHECK(t.document.session().scene().shapes.size() == 5);
  CHECK(t.document.text().ends_with("remove \"bead 1\"\nsphere \"bead 1\" { <9, 9, 9>, 2 }\n"));
}

TEST_CASE("document: only what is new is printed", "[document]") {
  Talk t;
  CHECK(t.say("print(1)").printed == "1\n");
  CHECK(t.say("print(2)").printed == "2\n");
  CHECK(t.say("1 + 2").printed == "3\n");
}

TEST_CASE("document: comments of what replaces something are kept", "[document]") {
  Talk t;
  t.say("let a = 1 let b = 2");
  t.say("// why\nlet a = 3  // so\nlet c = a");
  CHECK(t.document.text() == "let a = 3 let b = 2\n// why\n  // so\nlet c = a\n");
}

TEST_CASE("document: an entry that ends too early asks for more", "[document]") {
  Talk t;
  CHECK(t.say("for i in 0..3 {").is_incomplete);
  CHECK(t.document.text().empty());
  CHECK_FALSE(t.say("for i in 0..3 { sphere { <i, 0, 0>, 1 } }").is_incomplete);
}

TEST_CASE("document: a new entry after an undo forgets what was undone", "[document]") {
  Talk t;
  t.say("let a = 1");
  t.say("let b = 2");
  Reply reply;
  CHECK(t.document.undo(1, {}, reply) == 1);
  t.say("let c = 3");
  CHECK(t.document.redo(1, {}, reply) == 0);
  CHECK(t.document.history() == std::vector<std::string>{"let a = 1", "let c = 3"});
  CHECK(t.document.undo(9, {}, reply) == 2);
  CHECK(t.document.text().empty());
  CHECK(t.document.undo(1, {}, reply) == 0);
}

TEST_CASE("document: any sequence of entries, undos and redos leads where the text alone leads",
          "[document]") {
  const std::vector<std::string> entries{"let r = 1",
                                         "let r = 2",
                                         "fn f(n) { for i in 0..n { sphere \"s {i}\" { <i, 0, 0>, r } } }",
                                         "f(3)",
                                         "fn f(n) = sphere \"t\" { <n, 0, 0>, r }",
                                         "sphere \"s 1\" { <5, 5, 5>, 1 }",
                                         "modify \"s *\" { translate <0, 1, 0>  material { diffuse red } }",
                                         "remove \"s 0\"",
                                         "light \"key\" { at <1, 2, 3> }",
                                         "settings { ambient 0.2 }",
                                         "group \"g\" { f(2)  scale 2 }",
                                         "r = r + 1",
                                         "sphere { <0, 0, 0>, -1 }",
                                         "nothing_of_the_kind",
                                         "let broken = ",
                                         "r * 2"};
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    Talk t;
    std::vector<std::string> texts{""}, dumps{t.dump()};  // of the states; what an editor would have
    std::size_t at = 0;
    for (int step = 0; step < 25; ++step) {
      const auto choice = random() % 10;
      Reply reply;
      if (choice < 2) {
        const std::size_t count = 1 + random() % 3;
        const std::size_t moved = t.document.undo(count, {}, reply);
        REQUIRE(moved == std::min(count, at));
        at -= moved;
      } else if (choice < 4) {
        const std::size_t moved = t.document.redo(1, {}, reply);
        REQUIRE(moved == std::min<std::size_t>(1, texts.size() - 1 - at));
        at += moved;
      } else if (t.say(entries[random() % entries.size()]).is_changed) {
        texts.resize(++at);
        dumps.resize(at);
        texts.push_back(t.document.text());
        dumps.push_back(t.dump());
      }
      INFO("seed " << seed << ", step " << step);
      REQUIRE(t.document.text() == texts[at]);
      REQUIRE(t.dump() == dumps[at]);
      REQUIRE(t.dump() == dump_of(t.document.text()));
    }
  }
}
