#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "polhode/rotation_state.h"
#include "scenario/range.h"

namespace polhode::demos {

/// A JSON object that is read key by key. Each read throws a ScenarioError that names file, key and what is
/// valid. The keys that were read are the valid ones, so there is no second list to maintain. A key without a
/// fallback is required.
class CheckedObject {
 public:
  /// Fits the name of any file, even with all of its bytes escaped.
  static constexpr std::size_t kLongestText = 1024;

  /// `where` is the object's own key, empty for the whole file.
  CheckedObject(const nlohmann::json& value, std::string file_name, std::string where = "");

  /// Returns true if the key is there, and makes `key` a valid one.
  bool has(const std::string& key);
  /// Reads one printable line of at most kLongestText bytes.
  std::string text(const std::string& key, const std::optional<std::string>& fallback = std::nullopt);
  double number(const std::string& key, const Range& range, std::optional<double> fallback = std::nullopt);
  int whole_number(const std::string& key, const Range& range, int fallback);
  /// Reads three numbers, each within `range`.
  Vector3 vector(const std::string& key, const Range& range,
                 const std::optional<Vector3>& fallback = std::nullopt);
  /// Reads a vector as `vector` does and normalizes it.
  Vector3 direction(const std::string& key, const Vector3& fallback);
  /// Reads w, x, y, z and normalizes them.
  Quaternion orientation(const std::string& key, const Quaternion& fallback);
  CheckedObject object(const std::string& key);
  /// Reads a list of objects, empty if absent.
  std::vector<CheckedObject> objects(const std::string& key);

  /// Refuses keys that were never read. Call it after the last read.
  void refuse_unknown_keys() const;

  /// @throws ScenarioError with this text about this key
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

 private:
  std::string path_of(const std::string& key) const;
  const nlohmann::json& required(const std::string& key, const std::string& valid);
  double checked_number(const nlohmann::json& value, const std::string& key, const Range& range) const;
  void check_list(const nlohmann::json& value, const std::string& key, std::size_t size,
                  const std::string& valid) const;

  const nlohmann::json* value_;
  std::string file_name_;
  std::string where_;
  std::set<std::string> valid_keys_;
};

}  // namespace polhode::demos
