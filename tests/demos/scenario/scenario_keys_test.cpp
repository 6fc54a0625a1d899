// docs/scenario_files.md lists the keys of a scenario file as the code defines them.
#include "scenario/scenario_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "demos/support_files.h"
#include "scenario/number_text.h"

namespace polhode::demos {
namespace {

std::string text_of(double value) {
  return std::regex_replace(number_text(value), std::regex("e([+-])0*"),
                            value < 1.0 && value > -1.0 ? "e-" : "e");
}

std::string text_of(const Vector3& v) {
  return text_of(v.x()) + ", " + text_of(v.y()) + ", " + text_of(v.z());
}

std::string text_of(const Range& range) {
  return text_of(range.lowest) + " to " + text_of(range.highest);
}

/// Visits the keys of an object, and of its nested objects, to write a row of Markdown for each.
class KeyDocumentation {
 public:
  KeyDocumentation(std::string object, std::vector<std::string>& rows)
      : object_(std::move(object)), rows_(rows) {}

  bool has(const char* /*key*/) const { return true; }

  void text(const Key& key, const std::string& value) {
    add(key, "text", value.empty() ? "empty" : value, "one line");
  }
  void number(const Key& key, double value) { add(key, "number", text_of(value), text_of(key.range)); }
  void whole_number(const Key& key, int value) {
    add(key, "whole number", text_of(value), text_of(key.range));
  }
  void vector(const Key& key, const Vector3& value) {
    add(key, "3 numbers", text_of(value), "each " + text_of(key.range));
  }
  void vector(const Key& key, const std::optional<Vector3>& /*none*/) {
    vector(key, Vector3(Vector3::Zero()));
  }
  void direction(const Key& key, const Vector3& value) { vector(key, value); }
  void orientation(const Key& key, const Quaternion& value) {
    add(key, "4 numbers", text_of(value.w()) + ", " + text_of(Vector3(value.vec())),
        "each " + text_of(key.range));
  }

  template <class Object>
  void object(const Key& key, Object& value) {
    add(key, "object", "see below", "see below");
    KeyDocumentation inner(path_of(key), rows_);
    visit_keys(inner, value);
  }
  template <class Object>
  void object(const Key& key, std::optional<Object>& /*none*/) {
    add(key, "object", "none", "see below");
    document<Object>(path_of(key));
  }
  template <class Object>
  void list(const Key& key, std::vector<Object>& /*none*/) {
    add(key, "list of objects", "none", "see below");
    if (!std::is_same_v<Object, Body>) document<Object>(path_of(key));
  }
  template <class... Alternatives, class Chosen>
  void choice(const Key& key, const char* tag, const char* /*noun*/, Kinds<Alternatives...> /*kinds*/,
              Chosen& /*chosen*/) {
    add(key, "object", "none", "see below");
    (document<Alternatives>(path_of(key) + ", `" + tag + "` \"" + Alternatives::kKind + "\""), ...);
  }

 private:
  template <class Object>
  void document(const std::string& object) {
    KeyDocumentation inner(object, rows_);
    Object value;
    visit_keys(inner, value);
  }

  std::string path_of(const Key& key) const {
    return object_ + (object_.empty() ? "`" : " `") + key.name + "`";
  }

  void add(const Key& key, const std::string& type, const std::string& default_value,
           const std::string& valid) {
    const std::string default_text = key.default_text != nullptr          ? key.default_text
                                     : key.presence == Presence::required ? "required"
                                                                          : default_value;
    rows_.push_back((object_.empty() ? "" : "| " + object_ + " ") + "| `" + key.name + "` | " + type +
                    (*key.unit == '\0' ? "" : ", ") + key.unit + " | " + default_text + " | " + valid +
                    key.remark + " |\n");
  }

  std::string object_;
  std::vector<std::string>& rows_;
};

TEST(ScenarioKeys, AreDocumentedWithTypeUnitDefaultAndRange) {
  std::vector<std::string> rows;
  KeyDocumentation documentation("", rows);
  Scenario scenario;
  visit_keys(documentation, scenario);

  const std::string page = read_file(POLHODE_SCENARIO_FILES_PAGE);
  for (const std::string& row : rows) EXPECT_THAT(page, testing::HasSubstr("\n" + row));
  const std::regex any_row("\n\\| `");
  EXPECT_EQ(std::distance(std::sregex_iterator(page.begin(), page.end(), any_row), std::sregex_iterator()),
            static_cast<std::ptrdiff_t>(rows.size()));
}

}  // namespace
}  // namespace polhode::demos
