#include "lang/value.hpp"

#include "lang/keywords.hpp"
#include "lang/object.hpp"

namespace lancer::lang {
namespace {

/// How deep destructors may nest before the rest waits for its turn.
constexpr int k_nested_disposals = 100;

struct Disposal {
  int depth = 0;
  std::vector<Shared*> waiting;
};

}  // namespace

void dispose(Shared* unheld) noexcept {
  thread_local Disposal disposal;
  if (disposal.depth >= k_nested_disposals) {
    disposal.waiting.push_back(unheld);
    return;
  }
  ++disposal.depth;
  delete unheld;
  while (disposal.depth == 1 && !disposal.waiting.empty()) {
    Shared* next = disposal.waiting.back();
    disposal.waiting.pop_back();
    delete next;
  }
  --disposal.depth;
}

void Box::unlink() {
  if (previous != nullptr) previous->next = next;
  if (next != nullptr) next->previous = previous;
  previous = next = nullptr;
}

std::uint64_t RangeData::size() const {
  const double count = last - first + (closed ? 1 : 0);
  return count > 0 ? static_cast<std::uint64_t>(count) : 0;
}

Value::Value(std::string text) : type_(Type::string), shared_(new StringData(std::move(text))) {}
Value::Value(std::vector<Value> items) : type_(Type::list), shared_(new ListData(std::move(items))) {}
Value::Value(Ref<FunctionData> function) : type_(Type::function), shared_(Ref<Shared>(function.get())) {}
Value::Value(Ref<PatternData> pattern) : type_(Type::pattern), shared_(Ref<Shared>(pattern.get())) {}
Value::Value(Ref<MaterialData> material) : type_(Type::material), shared_(Ref<Shared>(material.get())) {}
Value::Value(Ref<Object> object) : type_(Type::object), shared_(Ref<Shared>(object.get())) {}
Value::Value(Ref<Box> box) : shared_(Ref<Shared>(box.get())) {}

const std::string& Value::text() const { return static_cast<StringData*>(shared_.get())->text; }
const std::vector<Value>& Value::items() const { return static_cast<ListData*>(shared_.get())->items; }
FunctionData& Value::function() const { return *static_cast<FunctionData*>(shared_.get()); }
PatternData& Value::pattern() const { return *static_cast<PatternData*>(shared_.get()); }
MaterialData& Value::material() const { return *static_cast<MaterialData*>(shared_.get()); }
Object& Value::object() const { return *static_cast<Object*>(shared_.get()); }
Box& Value::box() const { return *static_cast<Box*>(shared_.get()); }

std::size_t Value::length() const { return type_ == Type::range ? range().size() : items().size(); }
Value Value::item(std::size_t index) const {
  return type_ == Type::range ? Value(range()[index]) : items()[index];
}

std::string_view type_name(const Value& value) {
  switch (value.type()) {
    case Type::nothing: return "nothing";
    case Type::number: return "number";
    case Type::boolean: return "boolean";
    case Type::string: return "string";
    case Type::vector: return "vector";
    case Type::list: return "list";
    case Type::range: return "range";
    case Type::function: return "function";
    case Type::pattern: return "pattern";
    case Type::material: return "material";
    case Type::object: return kind_info(value.object().kind).id;
  }
  return "";
}

std::string with_article(const Value& value) { return "a " + std::string(type_name(value)); }

}  // namespace lancer::lang
