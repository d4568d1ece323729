// Values as `print` and interpolation show them.

#include <fmt/format.h>

#include "base/deep_stack.hpp"
#include "base/number.hpp"
#include "lang/builtins.hpp"
#include "lang/object.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

constexpr std::size_t k_stack_to_spare = 256 * 1024;

class Writer {
 public:
  Writer(Meter& meter, Span span) : meter_(meter), span_(span) {}

  void value(const Value& v) {
    switch (v.type()) {
      case Type::nothing: return add("nothing");
      case Type::number: return add(to_text(v.number()));
      case Type::boolean: return add(v.boolean() ? "true" : "false");
      case Type::string: return add(v.text());
      case Type::vector: return vector(v);
      case Type::list: return list(v.items());
      case Type::range: return range(v.range());
      case Type::function: return add("function");
      case Type::pattern: return add("pattern");
      case Type::material: return add("material");
      case Type::object: return object(v);
    }
  }

  std::string take() { return std::move(out_); }

 private:
  void add(std::string_view text) {
    out_ += text;
    const std::size_t steps = (out_.size() - charged_) / 64;
    charged_ += steps * 64;
    meter_.charge(steps, span_);
  }

  void vector(const Value& v) {
    add("<" + to_text(v.component(0)) + ", " + to_text(v.component(1)));
    if (v.dimension() == 3) add(", " + to_text(v.component(2)));
    add(">");
  }

  void list(const std::vector<Value>& items) {
    if (stack_left() < k_stack_to_spare) {
      throw ScriptError(Code::too_deep, span_, "this list is nested too deep to be shown");
    }
    add("[");
    bool first = true;
    for (const Value& item : items) {
      if (!first) add(", ");
      first = false;
      if (item.is(Type::string)) {
        quoted(item.text());
      } else {
        value(item);
      }
    }
    add("]");
  }

  void range(const RangeData& r) { add(to_text(r.first) + (r.closed ? "..=" : "..") + to_text(r.last)); }

  void object(const Value& v) {
    add(type_name(v));
    if (v.object().name.empty()) return;
    add(" ");
    quoted(v.object().name);
  }

  /// As it would be written in a script.
  void quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
      switch (c) {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '{': out += "\\{"; break;
        case '\n': out += "\\n"; break;
        case '\t': out += "\\t"; break;
        default:
          if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            out += fmt::format("\\u{{{:X}}}", static_cast<unsigned>(c));
          } else {
            out += c;
          }
      }
    }
    add(out + "\"");
  }

  Meter& meter_;
  Span span_;
  std::string out_;
  std::size_t charged_ = 0;
};

}  // namespace

std::string display(const Value& value, Meter& meter, Span span) {
  Writer writer(meter, span);
  writer.value(value);
  return writer.take();
}

}  // namespace lancer::lang
