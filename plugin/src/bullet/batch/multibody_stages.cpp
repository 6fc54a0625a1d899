#include "bullet/batch/multibody_stages.h"

#include "bullet/batch/stages.h"
#include "bullet/body/multibody_proxy.h"
#include "bullet/internals/prefetch.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Calls function(proxy, lane) for the given lanes that have a body.
template <class Function>
void for_proxies(const Batch& batch, LaneBits lanes, const Function& function) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (lanes[lane] && batch.bodies[lane] != nullptr) function(MultibodyProxy::of(*batch.bodies[lane]), lane);
  }
}

// Handles diverged multibodies, and those that woke up within the step.
void sanitize_multibodies_left_to_bullet(Batch& batch, const LaneBits& lanes) {
  for_proxies(batch, lanes, [](MultibodyProxy& proxy, std::size_t) {
    if (!proxy.is_multibody_finite()) proxy.read();
  });
  sanitize_left_to_bullet(batch, lanes);
  for_proxies(batch, lanes, [](MultibodyProxy& proxy, std::size_t) { proxy.take_out_non_finite(); });
}

}  // namespace

void prefetch_multibodies(const Batch& batch) {
  prefetch(&batch, &batch + 1);
  for_proxies(batch, ~LaneBits(), [](const MultibodyProxy& proxy, std::size_t) { proxy.prefetch(); });
}

void before_solve_of_multibodies(Batch& batch, const StepContext& context) noexcept {
  for_proxies(batch, ~LaneBits(), [](MultibodyProxy& proxy, std::size_t) { proxy.read(); });
  before_solve(batch, context);
  for_proxies(batch, batch.in_solve, [&batch](MultibodyProxy& proxy, std::size_t lane) {
    proxy.give_to_solver(batch.constrained[lane]);
  });
  for_proxies(batch, batch.diverged, [](MultibodyProxy& proxy, std::size_t) { proxy.take_out_non_finite(); });
}

void after_integration_of_multibodies(Batch& batch, const StepContext& context) noexcept {
  const LaneBits lanes = batch.in_solve;
  for_proxies(batch, lanes,
              [&context](MultibodyProxy& proxy, std::size_t) { proxy.read_solved(context.dt); });
  after_solve(batch, lanes, PoseIntegratedBy::library, context);
  for_proxies(batch, lanes, [&batch](MultibodyProxy& proxy, std::size_t lane) {
    if (moves(proxy.body())) proxy.write(batch.state(lane).q_WB);
  });
  sanitize_multibodies_left_to_bullet(batch, ~lanes);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
