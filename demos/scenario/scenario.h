#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "polhode/rotation_state.h"
#include "scenario/drive.h"
#include "scenario/range.h"

/// The content of a scenario file, in SI units. scenario_keys.h lists the keys; the members have their
/// defaults. Frames: W is the world, B the body (origin in its centre of mass, axes along its principal
/// axes).
namespace polhode::demos {

struct Sphere {
  static constexpr char kKind[] = "sphere";
  double radius = 0.5;
};

struct Box {
  static constexpr char kKind[] = "box";
  Vector3 half_extents = Vector3::Zero();
};

/// A box that is part of a compound. The compound's frame is moved to its centre of mass and principal axes.
struct BoxPart {
  Vector3 half_extents = Vector3::Zero();
  Vector3 at = Vector3::Zero();
  double mass = 1.0;
};

struct Compound {
  static constexpr char kKind[] = "compound";
  std::vector<BoxPart> parts;
};

using Shape = std::variant<Sphere, Box, Compound>;

/// An impulse (N s) at a point given by its offset from the centre of mass, in world axes.
struct Impulse {
  Vector3 impulse_W = Vector3::Zero();
  Vector3 at_W = Vector3::Zero();
};

/// The fraction of the velocity that is lost in a second.
struct Damping {
  double linear = 0.0;
  double angular = 0.0;
};

struct Body {
  std::optional<Vector3> inertia_B;  ///< principal moments; empty for those of the shape
  double mass = 1.0;
  Shape shape;
  Vector3 position_W = Vector3::Zero();
  Quaternion q_WB = Quaternion::Identity();
  Vector3 omega_W = Vector3::Zero();
  Vector3 velocity_W = Vector3::Zero();
  std::vector<Impulse> impulses;
  double friction = 0.5;
  double restitution = 0.0;
  Damping damping;
  Drive drive;
};

/// The half space normal_W . x <= height.
struct Ground {
  double height = 0.0;
  Vector3 normal_W = Vector3::UnitZ();
  double friction = 0.5;
  double restitution = 0.0;
};

/// Fixes a point of the body to its initial place in the world.
struct PointToPoint {
  static constexpr char kKind[] = "point_to_point";
  Vector3 pivot_B = Vector3::Zero();
};

struct Scenario {
  std::string name;  ///< one printable line, like the description
  std::string description;
  Body body;  ///< the recorded body
  std::vector<Body> others;
  Vector3 gravity_W = Vector3::Zero();
  Vector3 torque_W = Vector3::Zero();      ///< constant, on `body`
  std::optional<PointToPoint> constraint;  ///< of `body`
  std::optional<Ground> ground;
  int solver_iterations = 10;
  double dt = 0.0;
  double duration = 0.0;

  /// Returns true if nothing can touch `body` or exert a torque on it about its centre of mass, and its
  /// rotors, if any, keep their momentum. Gravity exerts no torque.
  bool is_torque_free() const;
  /// Returns true if a body has rotors at any time.
  bool has_rotors() const;
};

/// Limits the number of spheres, boxes and parts of compounds in a world: if all of them overlap, Bullet
/// keeps contacts for every pair.
inline constexpr std::size_t kMostShapes = 200;

/// Bullet ignores steps shorter than its single-precision epsilon, 1.2e-7 s.
inline constexpr Range kDtRange{1e-6, 1e3};
inline constexpr Range kDurationRange{1e-6, 1e11};
inline constexpr double kMostSteps = 1e8;

/// Returns duration / dt, rounded to the nearest whole number of steps.
/// @throws std::invalid_argument if that is less than one step or more than kMostSteps
std::int64_t step_count(double dt, double duration);

}  // namespace polhode::demos
