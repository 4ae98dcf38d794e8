#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace hsr::cli {

/// A value of JSON that is built up and then written. Members of objects keep their order. It hides nlohmann::json from the
/// verbs, since that takes seconds to compile.
class JsonValue {
 public:
  struct Member;

  JsonValue();  ///< null
  JsonValue(bool x);
  JsonValue(std::int64_t x);
  JsonValue(std::uint64_t x);
  JsonValue(double x);  ///< written as null if it is not finite
  JsonValue(const std::string& x);
  JsonValue(std::string_view x);
  JsonValue(const char* x);
  template <std::integral Integer>
  JsonValue(Integer x)
      : JsonValue(static_cast<std::conditional_t<std::is_signed_v<Integer>, std::int64_t, std::uint64_t>>(x)) {}
  /// An array.
  template <class T>
  JsonValue(const std::vector<T>& list) : JsonValue(array()) {
    for (const T& x : list) push_back(x);
  }
  /// An object, {{"key", value}, ...}.
  JsonValue(std::initializer_list<Member> members);

  static JsonValue array(std::initializer_list<JsonValue> elements = {});

  JsonValue(const JsonValue& other);
  JsonValue(JsonValue&& other) noexcept;
  JsonValue& operator=(JsonValue other) noexcept;
  ~JsonValue();

  /// Appends to an array.
  void push_back(JsonValue element);
  /// Adds a member to an object, or replaces it.
  void set(const std::string& key, JsonValue value);
  /// Of an object or array: nothing is in it.
  bool is_empty() const;
  /// Indented by two; bytes that are no UTF-8 are replaced.
  std::string text() const;

 private:
  std::unique_ptr<nlohmann::ordered_json> value_;  // never null, except when moved from
};

struct JsonValue::Member {
  std::string key;
  mutable JsonValue value;  // mutable: an initializer_list is const, and large values are to be moved out of it
};

}  // namespace hsr::cli
