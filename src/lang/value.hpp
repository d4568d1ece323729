#pragma once
// What an expression can be: a number, boolean, string, vector, list, range, function, pattern, material or
// object. Values are immutable; the large ones are shared by reference counts, which are not atomic: one
// evaluation runs on one thread.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/color.hpp"
#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace lancer::ast {
struct Function;
}

namespace lancer::lang {

/// The base of shared data, counted by Ref.
struct Shared {
  Shared() = default;
  Shared(const Shared&) {}  // a copy starts with a count of its own
  Shared& operator=(const Shared&) { return *this; }
  virtual ~Shared() = default;
  mutable std::uint32_t references = 0;
};

/// Deletes what no Ref holds any more, and what only that held, without recursion however deeply it is
/// nested.
void dispose(Shared* unheld) noexcept;

template <class T>
class Ref {
 public:
  Ref() = default;
  Ref(std::nullptr_t) {}
  explicit Ref(T* target) : target_(target) { retain(); }
  Ref(const Ref& other) : target_(other.target_) { retain(); }
  Ref(Ref&& other) noexcept : target_(std::exchange(other.target_, nullptr)) {}
  Ref& operator=(Ref other) noexcept {
    std::swap(target_, other.target_);
    return *this;
  }
  ~Ref() {
    if (target_ != nullptr && --target_->references == 0) dispose(target_);
  }

  T* get() const { return target_; }
  T& operator*() const { return *target_; }
  T* operator->() const { return target_; }
  explicit operator bool() const { return target_ != nullptr; }
  friend bool operator==(const Ref& a, const Ref& b) { return a.target_ == b.target_; }

 private:
  void retain() const {
    if (target_ != nullptr) ++target_->references;
  }
  T* target_ = nullptr;
};

template <class T, class... Args>
Ref<T> make_ref(Args&&... args) {
  return Ref<T>(new T{std::forward<Args>(args)...});
}

enum class Type : std::uint8_t {
  nothing,  // a slot whose `let` has not run, or that refers to a Box; what a call gives that adds and
            // returns nothing
  number,
  boolean,
  string,
  vector,
  list,
  range,
  function,
  pattern,
  material,
  object,
};

struct StringData;
struct ListData;
struct FunctionData;
struct PatternData;
struct MaterialData;
struct Object;
struct Box;

/// Whole bounds within +-2^53; empty when they run backwards.
struct RangeData {
  double first = 0, last = 0;
  bool closed = false;
  std::uint64_t size() const;
  double operator[](std::uint64_t index) const { return first + static_cast<double>(index); }
};

class Value {
 public:
  Value() = default;
  Value(double number) : type_(Type::number) { data_[0] = number; }
  Value(bool truth) : type_(Type::boolean), small_(truth) {}
  Value(const char*) = delete;
  explicit Value(std::string text);
  Value(Vec3 v) : type_(Type::vector), small_(3), data_{v.x, v.y, v.z} {}
  Value(Color c) : type_(Type::vector), small_(3), data_{c.r, c.g, c.b} {}
  Value(double x, double y) : type_(Type::vector), small_(2), data_{x, y, 0} {}
  explicit Value(std::vector<Value> items);
  Value(RangeData range) : type_(Type::range), small_(range.closed), data_{range.first, range.last, 0} {}
  Value(Ref<FunctionData> function);
  Value(Ref<PatternData> pattern);
  Value(Ref<MaterialData> material);
  Value(Ref<Object> object);
  explicit Value(Ref<Box> box);

  Type type() const { return type_; }
  bool is(Type type) const { return type_ == type; }

  // Each of these asks for a value of that type.
  double number() const { return data_[0]; }
  bool boolean() const { return small_ != 0; }
  int dimension() const { return small_; }  // of a vector: 2 or 3
  double component(int i) const { return data_[static_cast<std::size_t>(i)]; }
  Vec3 vec3() const { return {data_[0], data_[1], data_[2]}; }  // z = 0 for two components
  RangeData range() const { return {data_[0], data_[1], small_ != 0}; }
  const std::string& text() const;
  const std::vector<Value>& items() const;
  FunctionData& function() const;
  PatternData& pattern() const;
  MaterialData& material() const;
  Object& object() const;
  Box& box() const;  // of the slot of a variable that a closure captures
  template <class T>
  Ref<T> ref() const {
    return Ref<T>(static_cast<T*>(shared_.get()));
  }

  bool is_list_like() const { return type_ == Type::list || type_ == Type::range; }
  /// Of a list or range.
  std::size_t length() const;
  Value item(std::size_t index) const;

 private:
  Type type_ = Type::nothing;
  std::uint8_t small_ = 0;  // a boolean, the dimension of a vector, whether a range is closed
  std::array<double, 3> data_{};
  Ref<Shared> shared_;
};

struct StringData : Shared {
  explicit StringData(std::string s) : text(std::move(s)) {}
  std::string text;
};

struct ListData : Shared {
  explicit ListData(std::vector<Value> v) : items(std::move(v)) {}
  std::vector<Value> items;
};

/// A variable that a closure shares with the scope it came from. The evaluator knows every live box, so that
/// functions that hold themselves are freed at its end.
struct Box : Shared {
  Box() = default;
  Box(const Box&) = delete;
  Box& operator=(const Box&) = delete;
  ~Box() override { unlink(); }
  void unlink();

  Value value;
  Box* previous = nullptr;  // in the evaluator's list
  Box* next = nullptr;
};

/// A closure, or a built-in function.
struct FunctionData : Shared {
  const ast::Function* code = nullptr;  // null for a built-in
  std::vector<Ref<Box>> captures;
  std::uint32_t builtin = 0;
};

struct PatternData : Shared {
  scene::Pattern pattern;
};

/// An attribute as it was written: what a member reads. One value, or a list of several.
struct Written {
  std::string_view id;  // from the keyword table
  Value value;
};

struct MaterialData : Shared {
  /// A coefficient: a colour, or a pattern where `pattern` is set.
  struct Coefficient {
    Color color;
    Ref<PatternData> pattern;
  };
  Coefficient ambient{grey(0.8), {}}, diffuse{grey(0.8), {}}, specular, reflection, transmission;
  double shininess = 32;
  double ior = 1;
  bool fresnel = false;
  bool ambient_written = false;  // here or in a `from`
  std::vector<Written> written;  // those of `from` included
};

/// "number", "list", ..., and for an object its kind: what type_of says.
std::string_view type_name(const Value& value);
/// "a number", "a list", "a sphere": for messages.
std::string with_article(const Value& value);

}  // namespace lancer::lang
