// modify and remove: what was added so far, by its names.

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "lang/change_object.hpp"
#include "lang/evaluator.hpp"
#include "lang/glob.hpp"
#include "lang/keywords.hpp"

namespace lancer::lang {
namespace {

/// So many names are looked through for the one that was meant.
constexpr std::size_t k_most_names = 1000;

/// Goes through a collection, groups included, and puts what a change makes in place of what matches. Values
/// that hold the same objects keep them: groups on the way to a change are copied. Groups may nest deeper
/// than the stack: a list of open ones stands in for recursion.
class Rewriter {
 public:
  Rewriter(std::string_view pattern, const std::function<Ref<Object>(const Object&)>& change,
           bool changes_members, Meter& meter, Span where)
      : pattern_(pattern), change_(change), changes_members_(changes_members), meter_(meter), where_(where) {}

  std::vector<Ref<Object>> run(const std::vector<Ref<Object>>& objects) {
    open_.push_back({nullptr, &objects, 0, {}, false});
    for (;;) {
      Open& innermost = open_.back();
      if (innermost.next < innermost.members->size()) {
        visit((*innermost.members)[innermost.next++]);
      } else if (innermost.group == nullptr) {
        return std::move(innermost.out);
      } else {
        close();
      }
    }
  }

  bool found() const { return found_; }
  std::vector<std::string_view> names() const { return {names_.begin(), names_.end()}; }

 private:
  /// A group of which the members from `next` on are still to be looked at; the collection has no `group`.
  struct Open {
    const Object* group;
    const std::vector<Ref<Object>>* members;
    std::size_t next;
    std::vector<Ref<Object>> out;
    bool is_changed;
  };

  bool matches(const Object& object) {
    meter_.charge(1 + object.name.size() / 64, where_);
    if (object.name.empty()) return false;
    if (names_.size() < k_most_names) names_.insert(object.name);
    return matches_glob(pattern_, object.name);
  }

  void visit(const Ref<Object>& object) {
    if (const auto known = known_.find(object.get()); known != known_.end())
      return put(object.get(), known->second);
    const bool is_group = object->kind == ast::Kind::group;
    const bool is_match = (!is_group || !changes_members_) && matches(*object);
    if (is_group && !is_match) {
      open_.push_back({object.get(), &object->members, 0, {}, false});
      open_.back().out.reserve(object->members.size());
      return;
    }
    settle(object.get(), is_match ? changed(*object) : object);
  }

  void close() {
    Open done = std::move(open_.back());
    open_.pop_back();
    Ref<Object> group(const_cast<Object*>(done.group));
    if (done.is_changed) group = with_members(*done.group, std::move(done.out));
    settle(done.group, changes_members_ && matches(*done.group) ? changed(*group) : group);
  }

  static Ref<Object> with_members(const Object& group, std::vector<Ref<Object>> members) {
    constexpr std::uint64_t k_most = std::numeric_limits<std::uint64_t>::max();
    Ref<Object> out(new Object(group));
    out->count = 1;
    for (const Ref<Object>& m : members)
      out->count = m->count > k_most - out->count ? k_most : out->count + m->count;
    out->members = std::move(members);
    return out;
  }

  Ref<Object> changed(const Object& object) {
    found_ = true;
    return change_(object);
  }

  /// What becomes of an object; one that is there more than once is looked at once.
  void settle(const Object* object, Ref<Object> result) {
    if (object->references > 1) known_.emplace(object, result);
    put(object, std::move(result));
  }

  void put(const Object* object, Ref<Object> result) {
    Open& around = open_.back();
    around.is_changed = around.is_changed || result.get() != object;
    if (result) around.out.push_back(std::move(result));
  }

  std::string_view pattern_;
  const std::function<Ref<Object>(const Object&)>& change_;
  bool changes_members_;  // of a group that matches itself, too
  Meter& meter_;
  Span where_;
  std::vector<Open> open_;
  std::unordered_map<const Object*, Ref<Object>> known_;
  std::unordered_set<std::string_view> names_;
  bool found_ = false;
};

Diagnostic nothing_matches(Span where, std::string_view pattern, const std::vector<std::string_view>& names) {
  std::string help;
  if (const std::string_view near = nearest(pattern, names); !near.empty() && !is_glob(pattern))
    help = fmt::format("did you mean \"{}\"?", near);
  return warning(Code::no_match, where,
                 is_glob(pattern) ? fmt::format("no name matches \"{}\" here", pattern)
                                  : fmt::format("nothing is named \"{}\" here", pattern),
                 std::move(help));
}

}  // namespace

void Evaluator::change_added(const ast::Stmt& statement, const ast::String& pattern, const Change& change) {
  const std::string text = text_of(pattern);
  const bool changes_members = statement.kind == ast::StmtKind::modify;
  Rewriter rewriter(text, change, changes_members, meter_, pattern.span);
  std::vector<Ref<Object>> out = rewriter.run(collection_->objects);
  if (!rewriter.found()) {
    if (warned_.insert(&statement).second)
      out_.diagnostics.push_back(nothing_matches(pattern.span, text, rewriter.names()));
    return;
  }
  collection_->objects = std::move(out);
  collection_->count = 0;
  for (const Ref<Object>& object : collection_->objects) collection_->count += object->count;
}

void Evaluator::execute_modify(const ast::Modify& s) {
  std::vector<AttributeValues> values;
  for (const ast::Attribute& a : s.attributes) values.push_back(evaluate_attribute(a));
  change_added(s, *s.pattern, [&](const Object& object) {
    try {
      return change_object(object, values, s.pattern->span, meter_, out_.diagnostics);
    } catch (ScriptError& problem) {
      problem.diagnostic.labels.push_back(
          {object.source, fmt::format("this {} is to be changed", kind_info(object.kind).id)});
      throw;
    }
  });
}

void Evaluator::execute_remove(const ast::Remove& s) {
  change_added(s, *s.pattern, [](const Object&) { return Ref<Object>(); });
}

}  // namespace lancer::lang
