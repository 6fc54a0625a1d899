#include "scenario/scenario_writer.h"

#include "scenario/scenario_keys.h"

namespace polhode::demos {

using Json = nlohmann::ordered_json;

namespace {

template <class Object>
Json object_json(Object& value);

/// Visits the keys of an object to write them.
class KeyWriter {
 public:
  explicit KeyWriter(Json& json) : json_(json) {}

  bool has(const char* /*key*/) const { return true; }

  void text(const Key& key, const std::string& value) { json_[key.name] = value; }
  void number(const Key& key, double value) { json_[key.name] = value; }
  void whole_number(const Key& key, int value) { json_[key.name] = value; }
  void vector(const Key& key, const Vector3& value) {
    if (key.presence == Presence::if_set && value.isZero(0.0)) return;
    json_[key.name] = {value.x(), value.y(), value.z()};
  }
  void vector(const Key& key, const std::optional<Vector3>& value) {
    if (value) vector(key, *value);
  }
  void direction(const Key& key, const Vector3& value) { vector(key, value); }
  void orientation(const Key& key, const Quaternion& value) {
    json_[key.name] = {value.w(), value.x(), value.y(), value.z()};
  }

  template <class Object>
  void object(const Key& key, Object& value) {
    json_[key.name] = object_json(value);
  }
  template <class Object>
  void object(const Key& key, std::optional<Object>& value) {
    if (value) object(key, *value);
  }
  template <class Object>
  void list(const Key& key, std::vector<Object>& values) {
    if (key.presence == Presence::if_set && values.empty()) return;
    Json& list = json_[key.name] = Json::array();
    for (Object& value : values) list.push_back(object_json(value));
  }

  template <class AllKinds, class... Alternatives>
  void choice(const Key& key, const char* tag, const char* noun, AllKinds kinds,
              std::variant<Alternatives...>& chosen) {
    std::visit([&](auto& alternative) { choice(key, tag, noun, kinds, alternative); }, chosen);
  }
  template <class AllKinds, class Chosen>
  void choice(const Key& key, const char* tag, const char* noun, AllKinds kinds,
              std::optional<Chosen>& chosen) {
    if (chosen) choice(key, tag, noun, kinds, *chosen);
  }
  template <class AllKinds, class Alternative>
  void choice(const Key& key, const char* tag, const char* /*noun*/, AllKinds /*kinds*/,
              Alternative& chosen) {
    Json& json = json_[key.name] = {{tag, Alternative::kKind}};
    json.update(object_json(chosen));
  }

 private:
  Json& json_;
};

template <class Object>
Json object_json(Object& value) {
  Json json = Json::object();
  KeyWriter writer(json);
  visit_keys(writer, value);
  return json;
}

}  // namespace

Json scenario_json(Scenario scenario) {
  return object_json(scenario);
}

}  // namespace polhode::demos
