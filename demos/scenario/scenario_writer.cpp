#include "scenario/scenario_writer.h"

namespace polhode::demos {

using Json = nlohmann::ordered_json;

namespace {

Json list(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

Json list(const Quaternion& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

Json shape_json(const Sphere& sphere) {
  return {{"type", "sphere"}, {"radius", sphere.radius}};
}

Json shape_json(const Box& box) {
  return {{"type", "box"}, {"half_extents", list(box.half_extents)}};
}

Json shape_json(const Compound& compound) {
  Json parts = Json::array();
  for (const BoxPart& part : compound.parts) {
    parts.push_back({{"half_extents", list(part.half_extents)}, {"at", list(part.at)}, {"mass", part.mass}});
  }
  return {{"type", "compound"}, {"parts", parts}};
}

Json law_json(const GravityGradient& planet) {
  return {{"kind", "gravity_gradient"}, {"mu", planet.mu}, {"centre", list(planet.centre_W)}};
}

Json law_json(const MagneticDipole& magnet) {
  return {{"kind", "magnetic_dipole"}, {"dipole_B", list(magnet.dipole_B)}, {"field", list(magnet.field_W)}};
}

Json law_json(const OrientationSpring& spring) {
  return {{"kind", "spring"}, {"orientation", list(spring.target_WB)}, {"stiffness", spring.stiffness}};
}

Json law_json(const RateDamping& damping) {
  return {{"kind", "rate_damping"}, {"coefficients_B", list(damping.coefficients_B)}};
}

Json law_json(const InternalDamping& damping) {
  return {{"kind", "internal_damping"}, {"moment", damping.moment}, {"coefficient", damping.coefficient}};
}

// A body that nothing drives has none of these keys.
void write_drive(const Drive& drive, Json& json) {
  if (!drive.rotor_momentum_B.isZero(0.0)) json["rotor_momentum"] = list(drive.rotor_momentum_B);
  for (const MotorTorque& torque : drive.motor_torques) {
    json["rotor_torque"].push_back(
        {{"torque_B", list(torque.torque_B)}, {"from", torque.from_s}, {"until", torque.until_s}});
  }
  if (drive.law) {
    json["torque_law"] = std::visit([](const auto& law) { return law_json(law); }, *drive.law);
  }
}

void write_body(const Body& body, Json& json) {
  if (body.inertia_B) json["inertia"] = list(*body.inertia_B);
  json["mass"] = body.mass;
  json["shape"] = std::visit([](const auto& shape) { return shape_json(shape); }, body.shape);
  json["position"] = list(body.position_W);
  json["orientation"] = list(body.q_WB);
  json["angular_velocity"] = list(body.omega_W);
  json["linear_velocity"] = list(body.velocity_W);
  json["impulses"] = Json::array();
  for (const Impulse& impulse : body.impulses) {
    json["impulses"].push_back({{"impulse", list(impulse.impulse_W)}, {"at", list(impulse.at_W)}});
  }
  json["friction"] = body.friction;
  json["restitution"] = body.restitution;
  json["damping"] = {{"linear", body.linear_damping}, {"angular", body.angular_damping}};
  write_drive(body.drive, json);
}

}  // namespace

Json scenario_json(const Scenario& scenario) {
  Json json;
  json["name"] = scenario.name;
  json["description"] = scenario.description;
  write_body(scenario.body, json);
  json["others"] = Json::array();
  for (const Body& other : scenario.others) write_body(other, json["others"].emplace_back(Json::object()));
  json["gravity"] = list(scenario.gravity_W);
  json["torque"] = list(scenario.torque_W);
  if (scenario.constraint) {
    json["constraint"] = {{"type", "point_to_point"}, {"pivot_B", list(scenario.constraint->pivot_B)}};
  }
  if (scenario.ground) {
    json["ground"] = {{"height", scenario.ground->height},
                      {"normal", list(scenario.ground->normal_W)},
                      {"friction", scenario.ground->friction},
                      {"restitution", scenario.ground->restitution}};
  }
  json["solver_iterations"] = scenario.solver_iterations;
  json["dt"] = scenario.dt;
  json["duration"] = scenario.duration;
  return json;
}

}  // namespace polhode::demos
