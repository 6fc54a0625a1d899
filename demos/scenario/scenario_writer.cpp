#include "scenario/scenario_writer.h"

namespace polhode::demos {

using Json = nlohmann::ordered_json;

namespace {

Json list(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
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

void write_body(const Body& body, Json& json) {
  if (body.inertia_B) json["inertia"] = list(*body.inertia_B);
  json["mass"] = body.mass;
  json["shape"] = std::visit([](const auto& shape) { return shape_json(shape); }, body.shape);
  json["position"] = list(body.position_W);
  json["orientation"] = {body.q_WB.w(), body.q_WB.x(), body.q_WB.y(), body.q_WB.z()};
  json["angular_velocity"] = list(body.omega_W);
  json["linear_velocity"] = list(body.velocity_W);
  json["impulses"] = Json::array();
  for (const Impulse& impulse : body.impulses) {
    json["impulses"].push_back({{"impulse", list(impulse.impulse_W)}, {"at", list(impulse.at_W)}});
  }
  json["friction"] = body.friction;
  json["restitution"] = body.restitution;
  json["damping"] = {{"linear", body.linear_damping}, {"angular", body.angular_damping}};
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
