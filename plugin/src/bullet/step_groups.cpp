#include "bullet/step_groups.h"

#include "bullet/untouched_step.h"
#include "lanes/mean_angular_velocity.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

std::size_t index(BulletsTurn bullets_turn) {
  return static_cast<std::size_t>(bullets_turn);
}

}  // namespace

void StepGroups::begin(ManagedBody& body, btScalar dt) {
  if (!turns_in_lanes_ || !body.may_be_untouched()) {
    begin_alone(body, dt);
    return;
  }
  beginning_.add(
      body, [&](const BodyBlock& block) { return begin_together(block, dt); },
      [&](ManagedBody& touched) { begin_alone(touched, dt); });
}

BlockLanes StepGroups::begin_together(const BodyBlock& block, btScalar dt) {
  const UntouchedPredictions::Begun begun = predictions_of_untouched_.begin(block, dt);
  if (!begun.is_begun.all()) return begun.is_begun;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    block.bodies[lane]->begin_untouched(begun.free_to_turn[lane]);
  }
  return begun.is_begun;
}

void StepGroups::begin_alone(ManagedBody& body, btScalar dt) {
  body.begin_step();
  if (body.has_incident()) note_incident();
  predictions_[prediction_count_] = body.predict(dt);
  ++prediction_count_;
  if (prediction_count_ == kPredictions) turn_predictions(dt);
}

void StepGroups::turn_predictions(btScalar dt) {
  turn_like_bullet(predictions_.data(), prediction_count_, dt, replay_);
  prediction_count_ = 0;
}

void StepGroups::complete_predictions(btScalar dt) {
  predictions_of_untouched_.complete(dt);
  beginning_.complete([&](ManagedBody& body) { begin_alone(body, dt); });
  turn_predictions(dt);
}

void StepGroups::step(ManagedBody& body, btScalar dt, BulletsTurn bullets_turn) {
  Group& group = group_of(*body.scheme());
  group.dt = dt;
  const bool in_lanes = group.lane_scheme != nullptr && turns_in_lanes_ && body.may_be_in_place(bullets_turn);
  if (!in_lanes) {
    step_alone(group, body, bullets_turn);
    return;
  }
  group.waiting[index(bullets_turn)].add(
      body, [&](const BodyBlock& block) { return step_together(group, block, bullets_turn); },
      [&](ManagedBody& touched) { step_alone(group, touched, bullets_turn); });
}

BlockLanes StepGroups::step_together(const Group& group, const BodyBlock& block, BulletsTurn bullets_turn) {
  const BlockLanes in_place = step_untouched(block, bullets_turn, *group.lane_scheme, group.dt);
  if (in_place.all()) note_incidents(block);
  return in_place;
}

void StepGroups::note_incidents(const BodyBlock& block) {
  for (const ManagedBody* body : block.bodies) {
    if (body->has_incident()) note_incident();
  }
}

void StepGroups::step_alone(Group& group, ManagedBody& body, BulletsTurn bullets_turn) {
  const bool is_pending = body.prepare_step(group.dt, bullets_turn, group.steps[group.count]);
  if (body.has_incident()) note_incident();
  if (!is_pending) return;
  group.bodies[group.count] = &body;
  ++group.count;
  if (group.count == kBodies) complete_pending(group);
}

void StepGroups::complete_all() {
  for (Group& group : groups_) complete(group);
}

StepGroups::Group& StepGroups::group_of(const RotationScheme& scheme) {
  for (Group& group : groups_) {
    if (group.scheme == &scheme) return group;
  }
  Group& group = groups_[next_to_reuse_];
  next_to_reuse_ = (next_to_reuse_ + 1) % kGroups;
  complete(group);
  group.scheme = &scheme;
  group.lane_scheme = dynamic_cast<const LaneScheme*>(&scheme);
  return group;
}

void StepGroups::complete(Group& group) {
  for (const BulletsTurn bullets_turn : {BulletsTurn::made, BulletsTurn::left_out}) {
    group.waiting[index(bullets_turn)].complete(
        [&](ManagedBody& body) { step_alone(group, body, bullets_turn); });
  }
  complete_pending(group);
}

// Each stage is a loop of its own: a processor waits long for a vector whose numbers were stored one by one
// just before.
void StepGroups::complete_pending(Group& group) {
  if (group.count == 0) return;
  start(group);
  take_steps(group);
  find_mean_velocities(group);
  write(group);
  group.count = 0;
}

void StepGroups::start(Group& group) {
  std::array<BasisTurn, kBodies> turns;
  std::size_t turn_count = 0;
  for (std::size_t i = 0; i < group.count; ++i) {
    PendingStep& step = group.steps[i];
    if (step.bullets_turn == BulletsTurn::left_out || step.turned_fraction < 1.0) continue;
    turns[turn_count] = {&step.basis, &step.solved_W, &step.basis};
    ++turn_count;
  }
  turn_like_bullet(turns.data(), turn_count, group.dt, replay_);
  for (std::size_t i = 0; i < group.count; ++i)
    group.bodies[i]->start_step(group.dt, replay_, group.steps[i]);
}

void StepGroups::take_steps(Group& group) {
  std::array<BodyStep, kBodies> free;
  std::array<SchemeMemory, kBodies> fresh;
  std::size_t free_count = 0;
  for (std::size_t i = 0; i < group.count; ++i) {
    ManagedBody& body = *group.bodies[i];
    PendingStep& step = group.steps[i];
    if (body.is_held()) {
      body.step_held(step);
    } else {
      free[free_count] = {&step.input, &step.state, &body.memory_of_scheme(fresh[i])};
      ++free_count;
    }
  }
  group.scheme->step_bodies(free.data(), free_count);
}

void StepGroups::find_mean_velocities(Group& group) {
  std::array<OrientationPair, kBodies> orientations;
  for (std::size_t i = 0; i < group.count; ++i) {
    orientations[i] = {&group.steps[i].start_q_WB, &group.steps[i].state.q_WB};
  }
  std::array<Vector3, kBodies> mean_omega_W;
  mean_angular_velocities_W(orientations.data(), group.count, group.dt, mean_omega_W.data());
  for (std::size_t i = 0; i < group.count; ++i) group.steps[i].mean_omega_W = mean_omega_W[i];
}

void StepGroups::write(Group& group) {
  std::array<bool, kBodies> is_accepted;
  for (std::size_t i = 0; i < group.count; ++i) {
    is_accepted[i] = group.bodies[i]->accept_step(group.steps[i]);
    if (!is_accepted[i]) note_incident();
  }
  for (std::size_t i = 0; i < group.count; ++i) {
    if (is_accepted[i]) group.bodies[i]->write_step(group.steps[i]);
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
