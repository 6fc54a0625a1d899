#pragma once

#include "polhode/rotation_limits.h"
#include "scenario/drive_keys.h"
#include "scenario/scenario.h"

/// The keys of a scenario file, each once, in the order in which they are written. A visitor reads them into
/// the object (scenario_reader.cpp), writes them (scenario_writer.cpp), or compares them with
/// docs/scenario_files.md (a test). The reader checks conditions on several keys.
namespace polhode::demos {

inline constexpr Range kMass{1e-9, 1e9};
inline constexpr Range kLength{1e-6, 1e6};
inline constexpr Range kFraction{0.0, 1.0};
inline constexpr Range kFriction{0.0, 1e3};
inline constexpr Range kAngularSpeed{-kMaximumAngularSpeed, kMaximumAngularSpeed};

template <class Visitor>
void visit_keys(Visitor& visitor, Sphere& sphere) {
  visitor.number({"radius", Presence::required, kLength, "m"}, sphere.radius);
}

template <class Visitor>
void visit_keys(Visitor& visitor, Box& box) {
  visitor.vector({"half_extents", Presence::required, kLength, "m"}, box.half_extents);
}

template <class Visitor>
void visit_keys(Visitor& visitor, BoxPart& part) {
  visitor.vector({"half_extents", Presence::required, kLength, "m"}, part.half_extents);
  visitor.vector({"at", Presence::optional, kPlace, "m"}, part.at);
  visitor.number({"mass", Presence::required, kMass, "kg"}, part.mass);
}

template <class Visitor>
void visit_keys(Visitor& visitor, Compound& compound) {
  visitor.list({"parts", Presence::required, {}, "", "; at least one box"}, compound.parts);
}

template <class Visitor>
void visit_keys(Visitor& visitor, Impulse& impulse) {
  visitor.vector({"impulse", Presence::required, kAnySign, "N s"}, impulse.impulse_W);
  visitor.vector({"at", Presence::optional, kPlace, "m: offset from the centre of mass"}, impulse.at_W);
}

template <class Visitor>
void visit_keys(Visitor& visitor, Damping& damping) {
  visitor.number({"linear", Presence::optional, kFraction, "1/s"}, damping.linear);
  visitor.number({"angular", Presence::optional, kFraction, "1/s"}, damping.angular);
}

template <class Visitor>
void visit_keys(Visitor& visitor, Body& body) {
  const Presence inertia = visitor.has("shape") ? Presence::optional : Presence::required;
  visitor.vector({"inertia", inertia, kInertiaRange, "kg m^2: principal moments",
                  "; the triangle inequality need not hold", "the shape's; required without a shape"},
                 body.inertia_B);
  visitor.number(
      {"mass", Presence::optional, kMass, "kg", "; for a compound only the sum of its parts' masses",
       "1; for a compound the sum of its parts' masses"},
      body.mass);
  visitor.choice({"shape", Presence::optional, {}, "", "", "a sphere of 0.5 m"}, "type", "shape",
                 Kinds<Sphere, Box, Compound>{}, body.shape);
  visitor.vector({"position", Presence::optional, kPlace, "m: the centre of mass"}, body.position_W);
  visitor.orientation(
      {"orientation", Presence::optional, kAnyLength, "", ", not all 0; made a unit quaternion"}, body.q_WB);
  visitor.vector({"angular_velocity", Presence::optional, kAngularSpeed, "rad/s"}, body.omega_W);
  visitor.vector({"linear_velocity", Presence::optional, kAnySign, "m/s"}, body.velocity_W);
  visitor.list({"impulses"}, body.impulses);
  visitor.number({"friction", Presence::optional, kFriction}, body.friction);
  visitor.number({"restitution", Presence::optional, kFraction}, body.restitution);
  visitor.object({"damping"}, body.damping);
  visit_keys(visitor, body.drive);
}

template <class Visitor>
void visit_keys(Visitor& visitor, PointToPoint& joint) {
  visitor.vector({"pivot_B", Presence::required, kPlace,
                  "m: the point of the first body, in its own frame, that stays fixed in the world"},
                 joint.pivot_B);
}

template <class Visitor>
void visit_keys(Visitor& visitor, Ground& ground) {
  visitor.number({"height", Presence::optional, kPlace, "m along the normal"}, ground.height);
  visitor.direction({"normal", Presence::optional, kAnyLength, "", ", not all 0; made a unit vector"},
                    ground.normal_W);
  visitor.number({"friction", Presence::optional, kFriction, "", "; Bullet multiplies it by the body's"},
                 ground.friction);
  visitor.number({"restitution", Presence::optional, kFraction, "", "; Bullet multiplies it by the body's"},
                 ground.restitution);
}

template <class Visitor>
void visit_keys(Visitor& visitor, Scenario& scenario) {
  visitor.text({"name", Presence::optional, {}, "", "", "the file's name"}, scenario.name);
  visitor.text({"description"}, scenario.description);
  visit_keys(visitor, scenario.body);
  visitor.list({"others"}, scenario.others);
  visitor.vector({"gravity", Presence::optional, kAnySign, "m/s^2"}, scenario.gravity_W);
  visitor.vector({"torque", Presence::optional, kAnySign, "N m: a constant torque on the first body"},
                 scenario.torque_W);
  visitor.choice({"constraint"}, "type", "constraint", Kinds<PointToPoint>{}, scenario.constraint);
  visitor.object({"ground"}, scenario.ground);
  visitor.whole_number({"solver_iterations", Presence::optional, {1, 1000}}, scenario.solver_iterations);
  visitor.number({"dt", Presence::required, kDtRange, "s", " (Bullet ignores shorter steps)"}, scenario.dt);
  visitor.number({"duration", Presence::required, kDurationRange, "s",
                  "; duration/dt, rounded to whole steps, is 1 to 1e8; less than one step is an error"},
                 scenario.duration);
}

}  // namespace polhode::demos
