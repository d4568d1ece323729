#include "lang/check_blocks.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "lang/keywords.hpp"
#include "lang/wording.hpp"

namespace lancer::lang {
namespace {

using ast::Kind;

/// The kinds that have an attribute of that name.
std::string owners_of(std::string_view id) {
  std::vector<std::string> owners;
  for (const KindInfo& k : all_kinds()) {
    if (find_attribute(k.kind, id) != nullptr) owners.push_back(quoted(k.id));
  }
  return owners.empty() ? std::string()
                        : fmt::format("`{}` is an attribute of {}", id, listed(owners, "and"));
}

std::string a_kind(const KindInfo& kind) {
  return kind.kind == Kind::settings ? std::string("`settings`") : fmt::format("a {}", kind.id);
}

std::string all_attributes(const KindInfo& kind) {
  std::vector<std::string> words;
  for (const AttributeInfo& a : kind.attributes) words.push_back(quoted(a.id));
  return fmt::format("{} has {}", a_kind(kind), listed(words, "and"));
}

/// Whether the hint tells of an attribute of this kind: "the eye of a view is `eye`" helps in a view only.
bool speaks_of(std::string_view hint, const KindInfo& kind) {
  return std::any_of(kind.attributes.begin(), kind.attributes.end(), [&](const AttributeInfo& a) {
    return hint.find("`" + std::string(a.id)) != std::string_view::npos;
  });
}

std::string attribute_help(const KindInfo& kind, std::string_view id) {
  const std::string_view hint = foreign_hint(id);
  if (!hint.empty() && speaks_of(hint, kind)) return std::string(hint);
  std::vector<std::string_view> words;
  for (const AttributeInfo& a : kind.attributes) words.push_back(a.id);
  if (const std::string_view near = nearest(id, words); !near.empty())
    return fmt::format("did you mean `{}`?", near);
  if (std::string owners = owners_of(id); !owners.empty()) return owners;
  return hint.empty() ? all_attributes(kind) : std::string(hint);
}

void unknown_attribute(const KindInfo& kind, const ast::Attribute& a, std::vector<Diagnostic>& diagnostics) {
  diagnostics.push_back(error(Code::unknown_attribute, a.span,
                              fmt::format("{} has no attribute `{}`", a_kind(kind), a.id),
                              attribute_help(kind, a.id)));
}

class BlockCheck {
 public:
  BlockCheck(const ast::Block& block, std::vector<Diagnostic>& diagnostics)
      : block_(block), kind_(kind_info(block.block_kind)), diagnostics_(diagnostics) {}

  /// Whether all attributes are known ones.
  bool run() {
    for (const ast::Attribute& a : block_.attributes) check_attribute(a);
    for (const ast::Stmt* s : block_.statements) {
      if (s->kind == ast::StmtKind::attribute) check_attribute(ast::as<ast::AttributeStmt>(*s).attribute);
    }
    return all_known_;
  }

 private:
  void check_attribute(const ast::Attribute& a);
  void check_count(const ast::Attribute& a, const AttributeInfo& info);

  const ast::Block& block_;
  const KindInfo& kind_;
  std::vector<Diagnostic>& diagnostics_;
  std::vector<const ast::Attribute*> seen_;
  bool all_known_ = true;
};

/// `color` and `diffuse` of a material are one attribute.
std::string_view meaning(Kind kind, std::string_view id) {
  return kind == Kind::material && id == "color" ? "diffuse" : id;
}

void repeated(const ast::Attribute& first, const ast::Attribute& second,
              std::vector<Diagnostic>& diagnostics) {
  const std::string message = first.id == second.id
                                  ? fmt::format("`{}` is given twice", second.id)
                                  : fmt::format("`{}` and `{}` are the same attribute", first.id, second.id);
  Diagnostic d = error(Code::repeated_attribute, second.span, message);
  d.labels.push_back({first.span, "first given here"});
  diagnostics.push_back(std::move(d));
}

void BlockCheck::check_attribute(const ast::Attribute& a) {
  const AttributeInfo* info = find_attribute(kind_.kind, a.id);
  if (info == nullptr) {
    all_known_ = false;
    return unknown_attribute(kind_, a, diagnostics_);
  }
  const auto is_same = [&](const ast::Attribute* other) {
    return meaning(kind_.kind, other->id) == meaning(kind_.kind, a.id);
  };
  const auto first = std::find_if(seen_.begin(), seen_.end(), is_same);
  if (first == seen_.end()) {
    seen_.push_back(&a);
  } else if (!info->is_transform) {
    return repeated(**first, a, diagnostics_);
  }
  check_count(a, *info);
}

void BlockCheck::check_count(const ast::Attribute& a, const AttributeInfo& info) {
  const std::size_t count = a.values.size();
  if (count >= info.min_values && count <= info.max_values) return;
  const std::string wanted = info.min_values == info.max_values
                                 ? count_of(info.min_values, "value")
                                 : fmt::format("{} or {} values", info.min_values, info.max_values);
  const Span extra =
      count > info.max_values ? join(a.values[info.max_values]->span, a.values.back()->span) : a.span;
  diagnostics_.push_back(
      error(Code::mixed_forms, extra,
            fmt::format("`{}` takes {}; here {} {}", a.id, wanted, count == 1 ? "is" : "are", count)));
}

}  // namespace

void check_block(const ast::Block& block, bool doubtful, std::vector<Diagnostic>& diagnostics) {
  // What is unknown may be what would be missing: then no more is said.
  if (BlockCheck(block, diagnostics).run() && !doubtful) check_form(block, diagnostics);
}

void check_settings(const ast::Settings& settings, std::vector<Diagnostic>& diagnostics) {
  ast::Block block{};
  block.block_kind = Kind::settings;
  block.kind_span = settings.kind_span;
  block.attributes = settings.attributes;
  check_block(block, false, diagnostics);
}

void check_modify(const ast::Modify& modify, std::vector<Diagnostic>& diagnostics) {
  std::vector<const ast::Attribute*> seen;
  for (const ast::Attribute& a : modify.attributes) {
    const AttributeInfo* info = find_attribute(a.id);
    const auto is_same = [&](const ast::Attribute* other) { return other->id == a.id; };
    const auto first = std::find_if(seen.begin(), seen.end(), is_same);
    if (info == nullptr) {
      diagnostics.push_back(error(Code::unknown_attribute, a.span,
                                  fmt::format("no object has an attribute `{}`", a.id),
                                  std::string(foreign_hint(a.id))));
    } else if (first == seen.end()) {
      seen.push_back(&a);
    } else if (!info->is_transform) {
      repeated(**first, a, diagnostics);
    }
  }
}

}  // namespace lancer::lang
