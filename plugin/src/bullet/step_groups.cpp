#include "bullet/step_groups.h"

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
  beginning_.add(body);
  if (beginning_.is_full()) begin_block(dt);
}

void StepGroups::begin_block(btScalar dt) {
  const Predictions::Begun begun = predictions_of_untouched_.begin(beginning_, dt);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    ManagedBody& body = *beginning_.bodies[lane];
    if (begun.all) {
      body.begin_untouched(begun.free_to_turn[lane]);
    } else {
      begin_alone(body, dt);
    }
  }
  beginning_.count = 0;
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
  for (std::size_t i = 0; i < beginning_.count; ++i) begin_alone(*beginning_.bodies[i], dt);
  beginning_.count = 0;
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
  BodyBlock& block = group.waiting[index(bullets_turn)].maybe_in_place;
  block.add(body);
  if (block.is_full()) step_waiting(group, bullets_turn);
}

void StepGroups::step_waiting(Group& group, BulletsTurn bullets_turn) {
  BodyBlock& block = group.waiting[index(bullets_turn)].maybe_in_place;
  const BlockLanes in_place = step_untouched(block, bullets_turn, *group.lane_scheme, group.dt);
  if (in_place.all()) {
    note_incidents(block);
  } else {
    sort(group, bullets_turn, in_place);
  }
  block.count = 0;
}

// Those that are not in place are stepped alone, so that they do not keep the others from going together.
void StepGroups::sort(Group& group, BulletsTurn bullets_turn, const BlockLanes& in_place) {
  WaitingBodies& waiting = group.waiting[index(bullets_turn)];
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    ManagedBody& body = *waiting.maybe_in_place.bodies[lane];
    if (!in_place[lane]) {
      step_alone(group, body, bullets_turn);
      continue;
    }
    waiting.in_place.add(body);
    if (waiting.in_place.is_full()) {
      step_untouched(waiting.in_place, bullets_turn, *group.lane_scheme, group.dt);
      note_incidents(waiting.in_place);
      waiting.in_place.count = 0;
    }
  }
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

// Of less than eight bodies each is stepped alone.
void StepGroups::complete(Group& group) {
  for (const BulletsTurn bullets_turn : {BulletsTurn::made, BulletsTurn::left_out}) {
    WaitingBodies& waiting = group.waiting[index(bullets_turn)];
    for (BodyBlock* block : {&waiting.maybe_in_place, &waiting.in_place}) {
      for (std::size_t i = 0; i < block->count; ++i) step_alone(group, *block->bodies[i], bullets_turn);
      block->count = 0;
    }
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
