#include "lang/builtins_arguments.hpp"

#include <fmt/format.h>

#include "base/number.hpp"

namespace lancer::lang {

Span CallContext::argument_span(std::size_t index) const {
  return call != nullptr && index < call->arguments.size() ? call->arguments[index]->span : span;
}

std::string found_type(const Value& value) {
  if (value.is(Type::vector)) return fmt::format("a vector of {} numbers", value.dimension());
  return with_article(value);
}

void Arguments::wrong_type(std::size_t i, std::string_view wanted, std::string help) const {
  refuse(Code::wrong_type, i,
         fmt::format("`{}` wants {} here; this is {}", id_, wanted, found_type(values_[i])), std::move(help));
}

double Arguments::number(std::size_t i) const {
  if (!values_[i].is(Type::number)) wrong_type(i, "a number");
  return values_[i].number();
}

double Arguments::positive(std::size_t i, std::string_view what) const {
  const double value = number(i);
  if (value > 0) return value;
  refuse(Code::not_positive, i, fmt::format("{} is positive; this one is {}", what, to_text(value)));
}

const std::string& Arguments::text(std::size_t i) const {
  if (!values_[i].is(Type::string)) {
    wrong_type(i, "a string", values_[i].is(Type::number) ? "`str(v)` makes a string of any value" : "");
  }
  return values_[i].text();
}

const Value& Arguments::vector(std::size_t i) const {
  if (!values_[i].is(Type::vector)) {
    const bool counts = values_[i].is_list_like() || values_[i].is(Type::string);
    wrong_type(i, "a vector", counts && id_ == "length" ? "the number of elements is `len(..)`" : "");
  }
  return values_[i];
}

Vec3 Arguments::vec3(std::size_t i) const {
  if (!values_[i].is(Type::vector) || values_[i].dimension() != 3) wrong_type(i, "a vector of 3 numbers");
  return values_[i].vec3();
}

Vec3 Arguments::direction(std::size_t i, std::string_view what) const {
  const Vec3 v = vec3(i);
  if (max_abs(v) == 0)
    refuse(Code::degenerate, i, fmt::format("{} is not zero; this one is <0, 0, 0>", what));
  return v;
}

Color Arguments::color(std::size_t i) const {
  const Value& v = values_[i];
  if (!v.is(Type::number) && !(v.is(Type::vector) && v.dimension() == 3)) {
    wrong_type(i, "a colour, three numbers or one for a grey,");
  }
  return to_color(v, span(i), "a colour");
}

const Value& Arguments::list(std::size_t i) const {
  if (!values_[i].is_list_like()) wrong_type(i, "a list or a range");
  return values_[i];
}

const Value& Arguments::function(std::size_t i) const {
  if (!values_[i].is(Type::function)) wrong_type(i, "a function", "such as `fn (a) -> a + 1`");
  return values_[i];
}

void Arguments::same_dimension(std::size_t i, std::size_t j) const {
  const int a = vector(i).dimension();
  const int b = vector(j).dimension();
  if (a == b) return;
  refuse(
      Code::wrong_type, j,
      fmt::format("the vectors of `{}` are of the same length; this one has {} numbers, the one before it {}",
                  id_, b, a));
}

}  // namespace lancer::lang
