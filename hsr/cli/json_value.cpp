#include "hsr/cli/json_value.h"

#include <nlohmann/json.hpp>

namespace hsr::cli {

using Json = nlohmann::ordered_json;

JsonValue::JsonValue() : value_(std::make_unique<Json>()) {}
JsonValue::JsonValue(bool x) : value_(std::make_unique<Json>(x)) {}
JsonValue::JsonValue(std::int64_t x) : value_(std::make_unique<Json>(x)) {}
JsonValue::JsonValue(std::uint64_t x) : value_(std::make_unique<Json>(x)) {}
JsonValue::JsonValue(double x) : value_(std::make_unique<Json>(x)) {}
JsonValue::JsonValue(const std::string& x) : value_(std::make_unique<Json>(x)) {}
JsonValue::JsonValue(std::string_view x) : value_(std::make_unique<Json>(std::string(x))) {}
JsonValue::JsonValue(const char* x) : value_(std::make_unique<Json>(x)) {}

JsonValue::JsonValue(std::initializer_list<Member> members) : value_(std::make_unique<Json>(Json::object())) {
  for (const Member& m : members) set(m.key, std::move(m.value));
}

JsonValue JsonValue::array(std::initializer_list<JsonValue> elements) {
  JsonValue result;
  *result.value_ = Json::array();
  for (const JsonValue& e : elements) result.push_back(e);
  return result;
}

JsonValue::JsonValue(const JsonValue& other) : value_(std::make_unique<Json>(*other.value_)) {}
JsonValue::JsonValue(JsonValue&& other) noexcept = default;
JsonValue& JsonValue::operator=(JsonValue other) noexcept {
  value_ = std::move(other.value_);
  return *this;
}
namespace {

/// Empties a value from its leaves on: what is nested takes memory to be destroyed otherwise, which there may not be.
void empty(nlohmann::ordered_json& value) {
  if (!value.is_structured()) return;
  for (nlohmann::ordered_json& child : value) empty(child);
  value.clear();
}

}  // namespace

JsonValue::~JsonValue() {
  if (value_) empty(*value_);
}

void JsonValue::push_back(JsonValue element) { value_->push_back(std::move(*element.value_)); }

void JsonValue::set(const std::string& key, JsonValue value) { (*value_)[key] = std::move(*value.value_); }

bool JsonValue::is_empty() const { return value_->empty(); }

std::string JsonValue::text() const { return value_->dump(2, ' ', false, Json::error_handler_t::replace); }

}  // namespace hsr::cli
