#include "workprecision/joints/joint_kind.h"

#include <algorithm>
#include <stdexcept>

namespace polhode::demos {

namespace {

JointKind find_joint_kind(const std::string& name) {
  std::string valid;
  for (const JointKind kind : kJointKinds) {
    if (to_string(kind) == name) return kind;
    valid += (valid.empty() ? "" : ", ") + to_string(kind);
  }
  throw std::invalid_argument("--kind: is \"" + name + "\"; valid are " + valid);
}

}  // namespace

std::string to_string(JointKind kind) {
  switch (kind) {
    case JointKind::hinge:
      return "hinge";
    case JointKind::motor:
      return "motor";
    case JointKind::weld:
      return "weld";
    case JointKind::point:
      return "point";
    case JointKind::lock:
      return "lock";
    case JointKind::spring:
      break;
  }
  return "spring";
}

std::vector<JointKind> find_joint_kinds(const std::vector<std::string>& names) {
  std::vector<JointKind> kinds;
  for (const std::string& name : names) {
    const JointKind kind = find_joint_kind(name);
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) {
      throw std::invalid_argument("--kind: \"" + name + "\" is given twice; valid is each once");
    }
    kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace polhode::demos
