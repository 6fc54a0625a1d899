#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenario/checked_object.h"
#include "scenario/key.h"
#include "scenario/scenario.h"

namespace polhode::demos {

/// @name Conditions on several keys of an object, checked after reading them
/// @{
template <class Object>
void check(CheckedObject& /*object*/, const Object& /*value*/) {}
void check(CheckedObject& object, const Compound& compound);
void check(CheckedObject& object, const MotorTorque& torque);
void check(CheckedObject& object, Body& body);
void check(CheckedObject& object, Scenario& scenario);
/// @}

template <class Object>
void read_keys(CheckedObject file, Object& value);

/// Visits the keys of an object to read them.
/// @throws ScenarioError
class KeyReader {
 public:
  explicit KeyReader(CheckedObject& file) : file_(file) {}

  bool has(const char* key) { return file_.has(key); }

  void text(const Key& key, std::string& value) { value = file_.text(key.name, fallback(key, value)); }
  void number(const Key& key, double& value) {
    value = file_.number(key.name, key.range, fallback(key, value));
  }
  void whole_number(const Key& key, int& value) { value = file_.whole_number(key.name, key.range, value); }
  void vector(const Key& key, Vector3& value) {
    value = file_.vector(key.name, key.range, fallback(key, value));
  }
  void vector(const Key& key, std::optional<Vector3>& value) {
    if (file_.has(key.name) || key.presence == Presence::required) value = file_.vector(key.name, key.range);
  }
  void direction(const Key& key, Vector3& value) { value = file_.direction(key.name, value); }
  void orientation(const Key& key, Quaternion& value) { value = file_.orientation(key.name, value); }

  template <class Object>
  void object(const Key& key, Object& value) {
    if (file_.has(key.name)) read_keys(file_.object(key.name), value);
  }
  template <class Object>
  void object(const Key& key, std::optional<Object>& value) {
    if (file_.has(key.name)) read_keys(file_.object(key.name), value.emplace());
  }
  template <class Object>
  void list(const Key& key, std::vector<Object>& values) {
    for (const CheckedObject& element : file_.objects(key.name)) read_keys(element, values.emplace_back());
  }

  /// The key `tag` of the object, which messages call `noun`, names one of the kinds.
  template <class... Alternatives, class Chosen>
  void choice(const Key& key, const char* tag, const std::string& noun, Kinds<Alternatives...> /*kinds*/,
              Chosen& chosen) {
    if (!file_.has(key.name)) return;
    CheckedObject object = file_.object(key.name);
    const std::string kind = object.text(tag);
    if ((read_if<Alternatives>(kind, object, chosen) || ...)) return;
    std::string valid;
    ((valid += (valid.empty() ? "" : ", ") + std::string(Alternatives::kKind)), ...);
    object.fail(tag, "unknown " + noun + " \"" + kind + "\"; valid " +
                         (sizeof...(Alternatives) == 1 ? "is " : "are ") + valid);
  }

 private:
  template <class Value>
  static std::optional<Value> fallback(const Key& key, const Value& value) {
    return key.presence == Presence::required ? std::nullopt : std::optional<Value>(value);
  }

  template <class Alternative, class Chosen>
  static bool read_if(const std::string& kind, const CheckedObject& object, Chosen& chosen) {
    if (kind != Alternative::kKind) return false;
    Alternative value;
    read_keys(object, value);
    chosen = std::move(value);
    return true;
  }

  CheckedObject& file_;
};

/// Reads all keys of the object in the file and refuses others.
/// @throws ScenarioError
template <class Object>
void read_keys(CheckedObject file, Object& value) {
  KeyReader reader(file);
  visit_keys(reader, value);
  check(file, value);
  file.refuse_unknown_keys();
}

}  // namespace polhode::demos
