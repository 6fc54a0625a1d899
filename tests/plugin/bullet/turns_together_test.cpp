// What is turned for several bodies at once has the bits of Bullet's own compiled code, whatever is turned.
#include "bullet/turns_together.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace polhode::testing {
namespace {

enum class Basis { rotation, half_turn, nearly_rotation, any_matrix, not_finite };

// Bases, velocities and times for each branch of Bullet's, seeded.
class RandomTurns {
 public:
  explicit RandomTurns(unsigned start_seed) : generator_(start_seed) {}

  Basis kind() { return static_cast<Basis>(std::discrete_distribution<int>({40, 40, 10, 9, 1})(generator_)); }

  btMatrix3x3 basis(Basis kind) {
    switch (kind) {
      case Basis::rotation:
        return btMatrix3x3(btQuaternion(normal(), normal(), normal(), normal()));
      case Basis::half_turn:  // or nearly: any of the diagonal's numbers is the greatest
        return btMatrix3x3(btQuaternion(normal(), normal(), normal(), btScalar(0.1) * normal()));
      case Basis::nearly_rotation:
        return sum(basis(Basis::rotation), any_matrix(btScalar(0.01)));
      case Basis::any_matrix:
        return any_matrix(log_uniform(1e-25, 1e25));
      case Basis::not_finite:
        break;
    }
    using Limits = std::numeric_limits<btScalar>;
    btMatrix3x3 result = basis(Basis::rotation);
    result[whole(3)][whole(3)] = whole(2) == 0 ? Limits::infinity() : Limits::quiet_NaN();
    return result;
  }

  btVector3 omega_W() {
    if (whole(20) == 0) return {0, 0, 0};
    const btScalar speed = whole(20) == 0 ? log_uniform(1e-37, 1e37) : log_uniform(1e-10, 1e4);
    return btVector3(normal(), normal(), normal()) * speed;
  }

  btScalar dt() {
    const btScalar result = log_uniform(1e-4, 1.0);
    return whole(50) == 0 ? -result : whole(50) == 0 ? btScalar(0.0) : result;
  }

  // From 0 to below `end`.
  int whole(int end) { return std::uniform_int_distribution<int>(0, end - 1)(generator_); }

 private:
  btScalar normal() { return static_cast<btScalar>(normal_(generator_)); }
  btScalar log_uniform(double low, double high) {
    return static_cast<btScalar>(
        std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(generator_)));
  }
  btMatrix3x3 any_matrix(btScalar size) {
    btMatrix3x3 result;
    for (int row = 0; row < 3; ++row) result[row] = btVector3(normal(), normal(), normal()) * size;
    return result;
  }
  static btMatrix3x3 sum(btMatrix3x3 a, const btMatrix3x3& b) { return a += b; }

  std::mt19937 generator_;
  std::normal_distribution<double> normal_;
};

// Bodies of Bullet's, turned by Bullet and by us.
class Bodies {
 public:
  explicit Bodies(std::size_t count) {
    while (bodies_.size() < count) {
      bodies_.push_back(std::make_unique<btRigidBody>(btScalar(1), nullptr, nullptr, btVector3(1, 1, 1)));
    }
  }

  void choose(RandomTurns& random) {
    kinds_.clear();
    for (const auto& body : bodies_) {
      kinds_.push_back(random.kind());
      body->setWorldTransform(btTransform(random.basis(kinds_.back())));
      body->setAngularVelocity(random.omega_W());
    }
  }

  void turn_by_bullet(btScalar dt) {
    expected_.clear();
    for (const auto& body : bodies_) {
      btTransform result;
      body->predictIntegratedTransform(dt, result);
      expected_.push_back(result.getBasis());
    }
  }

  // The first of them, into where Bullet interpolates from.
  void turn_together(std::size_t count, btScalar dt) {
    std::vector<BasisTurn> turns;
    for (const auto& body : bodies_) body->getInterpolationWorldTransform() = untouched_;
    for (std::size_t i = 0; i < count; ++i) {
      btRigidBody& body = *bodies_[i];
      turns.push_back({&body.getWorldTransform().getBasis(), &body.getAngularVelocity(),
                       &body.getInterpolationWorldTransform().getBasis()});
    }
    turn_like_bullet(turns.data(), count, dt, replay_);
  }

  void turn_in_place(btScalar dt) {
    std::vector<BasisTurn> turns;
    for (const auto& body : bodies_) {
      btMatrix3x3& basis = body->getWorldTransform().getBasis();
      turns.push_back({&basis, &body->getAngularVelocity(), &basis});
    }
    turn_like_bullet(turns.data(), turns.size(), dt, replay_);
  }

  std::size_t size() const { return bodies_.size(); }
  Basis kind(std::size_t i) const { return kinds_[i]; }
  const btMatrix3x3& start(std::size_t i) const { return bodies_[i]->getWorldTransform().getBasis(); }
  btScalar angle(std::size_t i, btScalar dt) const { return bodies_[i]->getAngularVelocity().length() * dt; }

  bool turned_together_as_by_bullet(std::size_t i) const {
    return same_bits(bodies_[i]->getInterpolationWorldTransform().getBasis(), expected_[i]);
  }
  bool is_untouched(std::size_t i) const {
    return same_bits(bodies_[i]->getInterpolationWorldTransform().getBasis(), untouched_.getBasis());
  }
  bool turned_in_place_as_by_bullet(std::size_t i) const { return same_bits(start(i), expected_[i]); }
  bool kept_its_basis(std::size_t i) const { return same_bits(start(i), expected_[i]); }

 private:
  static bool same_bits(const btMatrix3x3& a, const btMatrix3x3& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
  }

  const btTransform untouched_ = btTransform(btQuaternion(1, 2, 3, 4));

  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<Basis> kinds_;
  std::vector<btMatrix3x3> expected_;
  BulletReplay replay_;
};

// The number of the four that Bullet takes the root for, 3 being the scalar part.
int greatest_of(const btMatrix3x3& m) {
  if (m[0].x() + m[1].y() + m[2].z() > btScalar(0.0)) return 3;
  if (m[0].x() < m[1].y()) return m[1].y() < m[2].z() ? 2 : 1;
  return m[0].x() < m[2].z() ? 2 : 0;
}

TEST(TurnsTogether, AreTakenInLanes) {
  EXPECT_TRUE(turns_in_lanes())
      << "this Bullet has other bits; turns are taken by its own code, body by body";
}

TEST(TurnsTogether, HaveTheBitsOfBullet) {
  RandomTurns random(41);
  Bodies bodies(100);
  std::vector<int> seen_greatest(4);
  int cut = 0, small = 0, kept = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const btScalar dt = random.dt();
    bodies.choose(random);
    bodies.turn_by_bullet(dt);
    bodies.turn_together(bodies.size(), dt);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      ASSERT_TRUE(bodies.turned_together_as_by_bullet(i))
          << "trial " << trial << ", body " << i << ", basis of kind " << static_cast<int>(bodies.kind(i));
      ++seen_greatest[static_cast<std::size_t>(greatest_of(bodies.start(i)))];
      cut += bodies.angle(i, dt) > SIMD_HALF_PI ? 1 : 0;
      small += bodies.angle(i, btScalar(1.0)) < btScalar(0.001) ? 1 : 0;
      kept += bodies.kept_its_basis(i) ? 1 : 0;
    }
  }
  for (const int seen : seen_greatest) EXPECT_GT(seen, 5000);
  EXPECT_GT(cut, 5000);
  EXPECT_GT(small, 5000);
  EXPECT_GT(kept, 1000);
}

TEST(TurnsTogether, DoNotDependOnCompany) {
  RandomTurns random(42);
  Bodies bodies(75);
  for (std::size_t count = 0; count <= bodies.size(); ++count) {
    bodies.choose(random);
    bodies.turn_by_bullet(btScalar(1.0 / 60.0));
    bodies.turn_together(count, btScalar(1.0 / 60.0));
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_TRUE(bodies.turned_together_as_by_bullet(i)) << i << " of " << count;
    for (std::size_t i = count; i < bodies.size(); ++i)
      ASSERT_TRUE(bodies.is_untouched(i)) << i << " of " << count;
  }
}

TEST(TurnsTogether, MayBeMadeInPlace) {
  RandomTurns random(43);
  Bodies bodies(43);
  for (int trial = 0; trial < 100; ++trial) {
    const btScalar dt = random.dt();
    bodies.choose(random);
    bodies.turn_by_bullet(dt);
    bodies.turn_in_place(dt);
    for (std::size_t i = 0; i < bodies.size(); ++i) ASSERT_TRUE(bodies.turned_in_place_as_by_bullet(i)) << i;
  }
}

}  // namespace
}  // namespace polhode::testing
