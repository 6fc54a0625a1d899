// Runs random sequences of application calls on worlds that the library rotates, as RotationWorld and by
// RotationPlugin, and checks the library's guarantees after each step.
//
// The first byte of an input selects the allowed operations: fewer operations allow stricter checks. Set
// POLHODE_FUZZ_TRACE=1 to print the operations of an input.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "fuzz/bytes.h"
#include "fuzz/fail.h"
#include "fuzz/world/comparison.h"
#include "fuzz/world/operation.h"
#include "fuzz/world/side.h"

namespace polhode::fuzz {
namespace {

constexpr std::size_t kMostOperations = 120;
constexpr std::size_t kMostWithinStep = 6;

Limits read_limits(Bytes& bytes) {
  const std::uint8_t byte = bytes.byte();
  Limits limits;
  limits.non_finite = (byte & 1U) != 0;
  limits.detaching = (byte & 2U) != 0;
  limits.continuous_collision = (byte & 4U) != 0;
  limits.contact_callbacks = (byte & 8U) != 0;
  limits.managed = (byte & 48U) != 48U;
  limits.world_kind = static_cast<WorldKind>(byte >> 6U);
  if (limits.world_kind == WorldKind::multi_body && (byte & 48U) == 16U)
    limits.world_kind = WorldKind::soft_multi_body;
  return limits;
}

// The limits of the determinism contract (docs/step.md): non-finite numbers are reset to the library's last
// values, which happens at different times with the two ways. A RotationWorld cannot be detached.
bool is_within_contract(const Limits& limits) {
  return !limits.managed || (!limits.non_finite && !limits.detaching && !limits.continuous_collision &&
                             !limits.contact_callbacks);
}

void run(Bytes& bytes) {
  const Limits limits = read_limits(bytes);
  const bool is_traced = std::getenv("POLHODE_FUZZ_TRACE") != nullptr;
  std::vector<std::unique_ptr<Side>> sides;
  sides.push_back(std::make_unique<Side>(Way::rotation_world, limits));
  sides.push_back(std::make_unique<Side>(Way::plugin, limits));
  if (!limits.managed) sides.push_back(std::make_unique<Side>(Way::plain, limits));
  bool must_agree = is_within_contract(limits);
  std::vector<Operation> script;
  bool next_is_within_step = false;
  Place place = Place::before;
  for (std::size_t i = 0; i < kMostOperations && !bytes.empty(); ++i) {
    Operation operation = read_operation(bytes, limits);
    if (is_traced) std::fprintf(stderr, "%s\n", text(operation).c_str());
    if (operation.kind == Kind::within_step) {
      next_is_within_step = true;
      place = operation.place;
      continue;
    }
    if (operation.kind != Kind::step) {
      const bool touches_body_alone = operation.kind <= Kind::mass;
      const bool is_possible = (operation.kind <= Kind::erase || operation.kind > Kind::step) &&
                               place != Place::contact && place != Place::motion_state;
      if (next_is_within_step && (touches_body_alone || is_possible) && script.size() < kMostWithinStep) {
        operation.place = place;
        script.push_back(operation);
      } else {
        for (const auto& side : sides) side->apply(operation);
      }
      next_is_within_step = false;
      continue;
    }
    for (const auto& side : sides) side->step(operation, script);
    script.clear();
    for (const auto& side : sides) {
      side->check(operation.world);
      if (limits.managed && side->has_left_contract()) must_agree = false;
    }
    // A RotationWorld predicts poses in double, Bullet in its own precision: boxes that touch within rounding
    // may become a pair one step later.
    for (const auto& side : sides) {
      if (side->pairs(operation.world) != sides.front()->pairs(operation.world)) must_agree = false;
    }
    for (std::size_t other = 1; other < sides.size() && must_agree; ++other)
      compare(*sides.front(), *sides[other], operation.world);
  }
}

}  // namespace
}  // namespace polhode::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  polhode::fuzz::Bytes bytes(data, size);
  polhode::fuzz::run(bytes);
  return 0;
}
