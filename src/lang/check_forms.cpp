// Forms: the ways to say what an object of a kind is.

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "lang/block_reader.hpp"
#include "lang/check_blocks.hpp"
#include "lang/keywords.hpp"
#include "lang/wording.hpp"

namespace lancer::lang {
namespace {

using ast::Kind;
using Words = std::vector<std::string_view>;

/// One way to say what an object is: so many values without names, attributes that must be there, and
/// attributes that may be there. Transforms, material and shadow go with every form.
struct Form {
  std::size_t positional;
  Words required;
  Words optional;
};

std::vector<Form> forms_of(Kind kind) {
  switch (kind) {
    case Kind::sphere: return {{0, {"center", "radius"}, {}}, {2, {}, {}}};
    case Kind::plane: return {{0, {"point", "normal"}, {}}, {0, {"points"}, {}}, {3, {}, {}}, {2, {}, {}}};
    case Kind::cube: return {{0, {"center", "side"}, {}}, {0, {"points"}, {}}, {3, {}, {}}};
    case Kind::box: return {{0, {"corners"}, {}}, {2, {}, {}}};
    case Kind::facet: return {{0, {"points"}, {"normals"}}, {3, {}, {"normals"}}};
    case Kind::mesh:
      return {{0, {"points", "faces"}, {"smooth", "solid"}}, {0, {"file"}, {"smooth", "solid"}}};
    case Kind::light: return {{0, {"at"}, {"color", "falloff"}}};
    case Kind::sun: return {{0, {"direction"}, {"color"}}};
    case Kind::spot: return {{0, {"at", "look_at"}, {"angle", "softness", "color", "falloff"}}};
    case Kind::view:
      return {{0, {"eye", "look"}, {"up", "fov", "size"}},
              {0, {"eye", "look"}, {"up", "width", "size"}},
              {0, {"eye", "look_at"}, {"up", "fov", "size"}},
              {0, {"eye", "look_at"}, {"up", "width", "size"}},
              {0, {"eye", "corners"}, {"size"}}};
    case Kind::group:
    case Kind::material:
    case Kind::settings: return {};
  }
  return {};
}

bool holds(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Something that a form is made of: an attribute, or (with an empty word) the values without names.
struct Part {
  std::string_view word;
  Span span;
};

bool fits(const Form& form, const Part& part) {
  if (part.word.empty()) return form.positional != 0;
  return holds(form.required, part.word) || holds(form.optional, part.word);
}

class FormCheck {
 public:
  FormCheck(const ast::Block& block, std::vector<Diagnostic>& diagnostics)
      : block_(block), kind_(kind_info(block.block_kind).id), diagnostics_(diagnostics) {}
  void run();

 private:
  void no_positional();
  void mixed(const std::vector<Part>& parts, const Part& culprit, const std::vector<Form>& all);
  bool check_positional(const std::vector<Form>& forms);
  void missing(const std::vector<Form>& forms, const std::vector<Part>& parts);

  const ast::Block& block_;
  std::string_view kind_;
  std::vector<Diagnostic>& diagnostics_;
};

void FormCheck::run() {
  if (!block_.positional.empty() && kind_info(block_.block_kind).max_positional == 0) return no_positional();
  const std::vector<Form> all = forms_of(block_.block_kind);
  if (all.empty()) return;
  std::vector<Part> parts;
  if (!block_.positional.empty())
    parts.push_back({{}, join(block_.positional[0]->span, block_.positional.back()->span)});
  for (const ast::Attribute& a : block_.attributes) {
    const auto has = [&](const Form& f) { return fits(f, {a.id, a.span}); };
    if (std::any_of(all.begin(), all.end(), has)) parts.push_back({a.id, a.span});
  }
  std::vector<Form> left = all;
  for (const Part& part : parts) {
    left.erase(std::remove_if(left.begin(), left.end(), [&](const Form& f) { return !fits(f, part); }),
               left.end());
    if (left.empty()) return mixed(parts, part, all);
  }
  if (check_positional(left)) missing(left, parts);
}

std::string name_of(const Part& part) {
  return part.word.empty() ? std::string("values without names") : quoted(part.word);
}

void FormCheck::mixed(const std::vector<Part>& parts, const Part& culprit, const std::vector<Form>& all) {
  const auto clashes = [&](const Part& other) {
    return std::none_of(all.begin(), all.end(),
                        [&](const Form& f) { return fits(f, culprit) && fits(f, other); });
  };
  const auto found = std::find_if(parts.begin(), parts.end(), clashes);
  const Part& other = found != parts.end() ? *found : parts.front();
  Diagnostic d = error(Code::mixed_forms, culprit.span,
                       fmt::format("a {} has {} or {}, not both", kind_, name_of(other), name_of(culprit)));
  d.labels.push_back(
      {other.span, other.word.empty() ? "these belong to one form" : "this belongs to one form"});
  diagnostics_.push_back(std::move(d));
}

bool FormCheck::check_positional(const std::vector<Form>& forms) {
  const std::size_t count = block_.positional.size();
  std::vector<std::size_t> counts;
  for (const Form& f : forms) counts.push_back(f.positional);
  if (count == 0 || std::find(counts.begin(), counts.end(), count) != counts.end()) return true;
  std::sort(counts.begin(), counts.end());
  const bool is_more = count > counts.back();
  const Span span = is_more ? join(block_.positional[counts.back()]->span, block_.positional.back()->span)
                            : block_.kind_span;
  std::vector<std::string> words;
  for (const std::size_t c : counts) words.push_back(fmt::format("{}", c));
  diagnostics_.push_back(error(
      Code::mixed_forms, span,
      fmt::format("a {} takes {} values without names; this one has {}", kind_, listed(words, "or"), count)));
  return false;
}

/// What each form still lacks; those that no form can do without come first.
void FormCheck::missing(const std::vector<Form>& forms, const std::vector<Part>& parts) {
  std::vector<Words> lacks;
  for (const Form& f : forms) {
    if (block_.positional.empty() && f.positional != 0) continue;
    Words lack;
    for (const std::string_view word : f.required) {
      if (std::none_of(parts.begin(), parts.end(), [&](const Part& p) { return p.word == word; }))
        lack.push_back(word);
    }
    if (lack.empty()) return;
    if (std::find(lacks.begin(), lacks.end(), lack) == lacks.end()) lacks.push_back(lack);
  }
  std::vector<std::string> common, choices;
  for (const std::string_view word : lacks[0]) {
    if (std::all_of(lacks.begin(), lacks.end(), [&](const Words& w) { return holds(w, word); }))
      common.push_back(quoted(word));
  }
  for (const Words& lack : lacks) {
    std::vector<std::string> own;
    for (const std::string_view word : lack) {
      if (std::find(common.begin(), common.end(), quoted(word)) == common.end()) own.push_back(quoted(word));
    }
    if (!own.empty()) choices.push_back(listed(own, "and"));
  }
  std::string needs = listed(common, "and");
  if (!common.empty() && !choices.empty()) needs += ", and ";
  const bool has_pairs =
      std::any_of(lacks.begin(), lacks.end(), [&](const Words& w) { return w.size() > common.size() + 1; });
  needs += listed(choices, has_pairs ? ", or" : "or");
  diagnostics_.push_back(
      error(Code::missing_attribute, block_.kind_span, fmt::format("a {} needs {}", kind_, needs)));
}

void FormCheck::no_positional() {
  std::vector<std::string> words;
  for (const AttributeInfo& a : kind_info(block_.block_kind).attributes) words.push_back(quoted(a.id));
  diagnostics_.push_back(
      error(Code::mixed_forms, block_.positional[0]->span,
            fmt::format("the values of a {} stand behind the names of its attributes", kind_),
            fmt::format("a {} has {}", kind_, listed(words, "and"))));
}

}  // namespace

bool go_together(Kind kind, std::string_view one, std::string_view other) {
  const std::vector<Form> forms = forms_of(kind);
  const auto some = [&](const auto& condition) { return std::any_of(forms.begin(), forms.end(), condition); };
  const auto has = [](const Form& f, std::string_view word) { return fits(f, {word, {}}); };
  // The distance of a plane stands beside its normal, in a form without names.
  if (one == k_plane_distance) return other != "point" && other != "points";
  if (!some([&](const Form& f) { return has(f, one); })) return true;
  if (!some([&](const Form& f) { return has(f, other); })) return true;
  return some([&](const Form& f) { return has(f, one) && has(f, other); });
}

void check_form(const ast::Block& block, std::vector<Diagnostic>& diagnostics) {
  FormCheck(block, diagnostics).run();
}

}  // namespace lancer::lang
