#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace polhode::demos {

/// The constraint or torque that acts on the bodies of a cell.
enum class JointKind : std::uint8_t {
  hinge,   ///< to the world, through the body's centre
  motor,   ///< the same hinge with a motor, which starts the body from rest
  weld,    ///< of two bodies
  point,   ///< a ball joint to the world, beside the body's centre
  lock,    ///< the body may not turn about one axis of the world
  spring,  ///< applyTorque(-k angle) towards one orientation
};

inline constexpr std::array kJointKinds = {JointKind::hinge, JointKind::motor, JointKind::weld,
                                           JointKind::point, JointKind::lock,  JointKind::spring};

std::string to_string(JointKind kind);

/// Returns the kinds of these names, in this order.
/// @throws std::invalid_argument for an unknown name (the message lists the valid ones) or a repeated one
std::vector<JointKind> find_joint_kinds(const std::vector<std::string>& names);

}  // namespace polhode::demos
