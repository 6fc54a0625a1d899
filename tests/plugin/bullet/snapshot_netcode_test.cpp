// A network game with rollback, with both peers in one process. Each peer steps its own world immediately,
// with its own input and a guess of the other's. When the other's input arrives, a few frames late, the peer
// rolls back and steps again. Both end with the same bits, though they exchange only inputs.
#include <gtest/gtest.h>

#include <map>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/world_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kFrame = btScalar(1.0 / 60.0);
constexpr int kFrames = 240;
constexpr int kPlayers = 2;

/// A player's input in a frame, applied to the player's own box: a force along x, N, and a torque about z, N
/// m.
struct Input {
  btScalar push = 0;
  btScalar spin = 0;

  bool operator==(const Input& other) const { return push == other.push && spin == other.spin; }
};

// Returns an input that changes at frames unknown to the other player.
Input chosen_by(int player, int frame) {
  const int mood = (frame / 17 + 2 * player) % 3;
  return {btScalar(mood == 1 ? 12 : -4), btScalar(mood == 2 ? 30 : 5)};
}

template <class Way>
class Peer {
 public:
  explicit Peer(int player) : player_(player) {
    set_gravity(way_);
    way_.add_floor().setFriction(btScalar(0.5));
    for (int i = 0; i < 12; ++i) {
      const btTransform pose(btQuaternion(1, 2, btScalar(i), 4).normalized(),
                             vector(0.3 * (i % 3), 0.2 * (i % 4), 0.6 + 0.7 * i));
      way_.add_box(vector(0.4, 0.3, 0.2), 1, pose).forceActivationState(ACTIVE_TAG);
    }
    way_.template join<btPoint2PointConstraint>(*way_.bodies()[5], *way_.bodies()[6], vector(0.5, 0, 0),
                                                vector(-0.5, 0, 0));
  }

  Snapshot start() { return way_.rotation().save_world(); }
  void join(const Snapshot& start) { way_.rotation().restore_world(start); }

  /// Plays a frame with the inputs known so far and returns the player's own input for sending.
  Input play() {
    inputs_[player_][frame_] = chosen_by(player_, frame_);
    step();
    return inputs_[player_][frame_ - 1];
  }

  /// Receives the other player's input of a frame that has been played with a guess.
  void receive(int frame, const Input& input) {
    const int other = 1 - player_;
    const bool was_guessed = guess(other, frame) == input;
    inputs_[other][frame] = input;
    if (was_guessed || frame >= frame_) return;
    const int now = frame_;
    way_.rotation().restore_world(saved_.at(frame));
    for (frame_ = frame; frame_ < now;) step();
    ++rollbacks_;
  }

  std::uint64_t digest() { return digest_of(way_.world(), way_.rotation()); }
  Snapshot saved() { return way_.rotation().save_world(); }
  int rollbacks() const { return rollbacks_; }

 private:
  // Returns the known input, or the last known one.
  Input guess(int player, int frame) {
    const auto after = inputs_[player].upper_bound(frame);
    return after == inputs_[player].begin() ? Input() : std::prev(after)->second;
  }

  void step() {
    saved_[frame_] = way_.rotation().save_world();
    for (int player = 0; player < kPlayers; ++player) {
      const Input input = guess(player, frame_);
      btRigidBody& box = *way_.bodies()[1U + static_cast<std::size_t>(player)];
      box.activate();
      box.applyCentralForce(btVector3(input.push, 0, 0));
      box.applyTorque(btVector3(0, 0, input.spin));
    }
    way_.step(kFrame);
    ++frame_;
  }

  Way way_;
  int player_;
  int frame_ = 0;
  int rollbacks_ = 0;
  std::map<int, Input> inputs_[kPlayers];
  std::map<int, Snapshot> saved_;
};

template <class Way>
class NetworkGame : public ::testing::Test {};
TYPED_TEST_SUITE(NetworkGame, BothWays, WayName);

TYPED_TEST(NetworkGame, WithRollbackEndsInTheSameBitsOnBothEnds) {
  constexpr int kDelay = 6;
  Peer<TypeParam> host(0);
  Peer<TypeParam> guest(1);
  // The guest starts from the host's snapshot: Bullet balances its trees by memory addresses, which differ
  // between the two.
  const Snapshot start = host.start();
  guest.join(start);

  std::map<int, Input> to_guest;
  std::map<int, Input> to_host;
  for (int frame = 0; frame < kFrames + kDelay; ++frame) {
    if (frame < kFrames) {
      to_guest[frame] = host.play();
      to_host[frame] = guest.play();
    }
    if (frame < kDelay) continue;
    guest.receive(frame - kDelay, to_guest[frame - kDelay]);
    host.receive(frame - kDelay, to_host[frame - kDelay]);
  }
  EXPECT_EQ(host.digest(), guest.digest());
  EXPECT_EQ(host.saved(), guest.saved());
  EXPECT_GT(host.rollbacks(), 5);   // measured 14
  EXPECT_GT(guest.rollbacks(), 5);  // measured 14

  // Plays as if all inputs had arrived in time.
  Peer<TypeParam> replay(0);
  replay.join(start);
  for (int frame = 0; frame < kFrames; ++frame) {
    replay.receive(frame, to_host[frame]);
    replay.play();
  }
  EXPECT_EQ(replay.saved(), host.saved());
}

}  // namespace
}  // namespace polhode::testing
