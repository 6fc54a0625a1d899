#include "record/contender.h"

#include <algorithm>
#include <stdexcept>

namespace polhode::demos {

namespace {

std::vector<Contender> bullet_modes() {
  return {{"bullet:none", "Bullet alone, no gyroscopic term", BulletMode::none},
          {"bullet:explicit", "Bullet alone, explicit gyroscopic torque, capped", BulletMode::explicit_force},
          {"bullet:implicit_world", "Bullet alone, implicit gyroscopic term in the world frame",
           BulletMode::implicit_world},
          {"bullet:implicit_body", "Bullet alone, implicit gyroscopic term in the body frame: its default",
           BulletMode::implicit_body}};
}

Contender bullet_multibody() {
  return {"bullet:multibody", "Bullet alone, each body a btMultiBody without links: PyBullet's default",
          BulletMultibody{}};
}

std::string names_of(const std::vector<Contender>& contenders) {
  std::string names;
  for (const Contender& contender : contenders) names += (names.empty() ? "" : ", ") + contender.name;
  return names;
}

const Contender& find_contender(const std::vector<Contender>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Contender& contender) { return contender.name == name; });
  if (found != all.end()) return *found;
  throw std::invalid_argument("unknown contender \"" + name + "\"; valid are " + names_of(all));
}

}  // namespace

std::vector<Contender> all_contenders() {
  std::vector<Contender> all;
  for (const SchemePointer& scheme : all_schemes()) {
    const SchemeDescription description = scheme->description();
    all.push_back({std::string(description.name), std::string(description.summary), scheme});
  }
  for (const Contender& mode : bullet_modes()) all.push_back(mode);
  all.push_back(bullet_multibody());
  return all;
}

std::vector<Contender> default_contenders() {
  std::vector<std::string> names = {"exact", "matrix", "quaternion", "semi_implicit_gyroscopic",
                                    "implicit_gyroscopic"};
  const std::vector<SchemePointer> all = all_schemes();
  for (std::size_t i = built_in_schemes().size(); i < all.size(); ++i)
    names.emplace_back(all[i]->description().name);
  for (const Contender& mode : bullet_modes()) names.push_back(mode.name);
  return find_contenders(names);
}

std::vector<Contender> find_contenders(const std::vector<std::string>& names) {
  const std::vector<Contender> all = all_contenders();
  std::vector<Contender> chosen;
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(names.begin(), name, *name) != name) {
      throw std::invalid_argument("contender \"" + *name + "\" is given twice; valid is each once");
    }
    chosen.push_back(find_contender(all, *name));
  }
  return chosen;
}

bool takes_rotors(const Contender& contender) {
  if (const SchemePointer* scheme = std::get_if<SchemePointer>(&contender.method)) {
    return (*scheme)->description().takes_rotors;
  }
  return std::holds_alternative<BulletMode>(contender.method);
}

void require_can_run(const Contender& contender, const Scenario& scenario) {
  if (!scenario.has_rotors() || takes_rotors(contender)) return;
  throw std::invalid_argument("contender \"" + contender.name +
                              "\" takes no rotors, and the scenario has some; valid are " +
                              names_of(those_that_can_run(all_contenders(), scenario).contenders));
}

ChosenContenders those_that_can_run(const std::vector<Contender>& contenders, const Scenario& scenario) {
  ChosenContenders chosen;
  std::vector<Contender> left_out;
  for (const Contender& contender : contenders) {
    const bool can_run = !scenario.has_rotors() || takes_rotors(contender);
    (can_run ? chosen.contenders : left_out).push_back(contender);
  }
  if (!left_out.empty()) chosen.note = "left out, since they take no rotors: " + names_of(left_out);
  return chosen;
}

ChosenContenders chosen_contenders(const std::vector<std::string>& names, const Scenario& scenario) {
  if (names.empty()) return those_that_can_run(default_contenders(), scenario);
  const std::vector<Contender> contenders = find_contenders(names);
  for (const Contender& contender : contenders) require_can_run(contender, scenario);
  return {contenders, ""};
}

}  // namespace polhode::demos
