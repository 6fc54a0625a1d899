#include "scenario/checked_object.h"

#include <cmath>
#include <limits>
#include <utility>

#include "scenario/json_file.h"
#include "scenario/printable_text.h"

namespace polhode::demos {

namespace {

constexpr std::size_t kLongestKey = 100;  // in a message

// Returns the value as it stands in the file, shortened for a message.
std::string excerpt(const nlohmann::json& value) {
  constexpr std::size_t kLongest = 40;
  const std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

std::string element(const std::string& key, std::size_t index) {
  return key + "[" + std::to_string(index) + "]";
}

// Keeps a vector or quaternion whose length is 1 to rounding: normalizing it again could change the last bit,
// so that a file would not read back as it was written.
template <class T>
T with_unit_length(const T& value) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  return std::abs(value.squaredNorm() - 1.0) <= kRounding ? value : T(value.normalized());
}

}  // namespace

CheckedObject::CheckedObject(const nlohmann::json& value, std::string file_name, std::string where)
    : value_(&value), file_name_(std::move(file_name)), where_(std::move(where)) {
  if (value.is_object()) return;
  const std::string subject = where_.empty() ? "the file" : "\"" + where_ + "\"";
  throw ScenarioError(file_name_ + ": " + subject + ": must be an object {...}, is " + excerpt(value));
}

bool CheckedObject::has(const std::string& key) {
  valid_keys_.insert(key);
  return value_->contains(key);
}

std::string CheckedObject::text(const std::string& key, const std::optional<std::string>& fallback) {
  if (fallback && !has(key)) return *fallback;
  const nlohmann::json& value = required(key, "a text");
  if (!value.is_string()) fail(key, "must be a text, is " + excerpt(value));
  const std::string text = value.get<std::string>();
  if (text.size() > kLongestText) {
    fail(key, "must be a text of at most " + std::to_string(kLongestText) + " bytes, has " +
                  std::to_string(text.size()));
  }
  const std::string_view unprintable = first_unprintable(text);
  if (!unprintable.empty()) {
    fail(key, "must be one line without control characters or directional formatting, has \"" +
                  printable(unprintable) + "\" in it");
  }
  return text;
}

double CheckedObject::number(const std::string& key, const Range& range, std::optional<double> fallback) {
  if (fallback && !has(key)) return *fallback;
  return checked_number(required(key, range_text(range)), key, range);
}

int CheckedObject::whole_number(const std::string& key, const Range& range, int fallback) {
  const double value = number(key, range, fallback);
  if (value != std::floor(value)) fail(key, "must be a whole number, is " + excerpt(value_->at(key)));
  return static_cast<int>(value);
}

Vector3 CheckedObject::vector(const std::string& key, const Range& range,
                              const std::optional<Vector3>& fallback) {
  if (fallback && !has(key)) return *fallback;
  const std::string valid = "a list of 3 numbers, each " + range_text(range);
  const nlohmann::json& list = required(key, valid);
  check_list(list, key, 3, valid);
  Vector3 vector;
  for (int i = 0; i < 3; ++i) vector[i] = checked_number(list[i], element(key, i), range);
  return vector;
}

Vector3 CheckedObject::direction(const std::string& key, const Vector3& fallback) {
  const Vector3 vector = this->vector(key, kAnyLength, fallback);
  // Dividing by a much smaller length would overflow.
  if (vector.norm() < 1e-12) fail(key, "must have a direction, is " + excerpt(value_->at(key)));
  return with_unit_length(vector);
}

Quaternion CheckedObject::orientation(const std::string& key, const Quaternion& fallback) {
  if (!has(key)) return fallback;
  const std::string valid = "a list of 4 numbers w, x, y, z, each " + range_text(kAnyLength);
  const nlohmann::json& list = required(key, valid);
  check_list(list, key, 4, valid);
  double wxyz[4];
  for (std::size_t i = 0; i < 4; ++i) wxyz[i] = checked_number(list[i], element(key, i), kAnyLength);
  const Quaternion q_WB(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  if (q_WB.norm() < 1e-12) fail(key, "must not be the zero quaternion; [1, 0, 0, 0] is no rotation");
  return with_unit_length(q_WB);
}

CheckedObject CheckedObject::object(const std::string& key) {
  return CheckedObject(required(key, "an object {...}"), file_name_, path_of(key));
}

std::vector<CheckedObject> CheckedObject::objects(const std::string& key) {
  std::vector<CheckedObject> list;
  if (!has(key)) return list;
  const nlohmann::json& values = value_->at(key);
  if (!values.is_array()) fail(key, "must be a list of objects [{...}, ...], is " + excerpt(values));
  for (std::size_t i = 0; i < values.size(); ++i) {
    list.emplace_back(values[i], file_name_, path_of(element(key, i)));
  }
  return list;
}

void CheckedObject::refuse_unknown_keys() const {
  for (const auto& item : value_->items()) {
    if (valid_keys_.count(item.key()) != 0) continue;
    std::string valid;
    for (const std::string& key : valid_keys_) valid += (valid.empty() ? "" : ", ") + key;
    fail(item.key(), "unknown key; valid are " + valid);
  }
}

void CheckedObject::fail(const std::string& key, const std::string& what) const {
  throw ScenarioError(file_name_ + ": \"" + shortened(path_of(key), kLongestKey) + "\": " + what);
}

std::string CheckedObject::path_of(const std::string& key) const {
  return where_.empty() ? key : where_ + "." + key;
}

const nlohmann::json& CheckedObject::required(const std::string& key, const std::string& valid) {
  if (!has(key)) fail(key, "the key is missing; it must be " + valid);
  return value_->at(key);
}

double CheckedObject::checked_number(const nlohmann::json& value, const std::string& key,
                                     const Range& range) const {
  if (!value.is_number() || !range.contains(value.get<double>())) {
    fail(key, "must be " + range_text(range) + ", is " + excerpt(value));
  }
  return value.get<double>();
}

void CheckedObject::check_list(const nlohmann::json& value, const std::string& key, std::size_t size,
                               const std::string& valid) const {
  if (!value.is_array() || value.size() != size) fail(key, "must be " + valid + ", is " + excerpt(value));
}

}  // namespace polhode::demos
