// Damaged or unsuitable snapshots are refused with the reason and change nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/world_bits.h"

namespace polhode::testing {
namespace {

using ::testing::HasSubstr;

constexpr btScalar kStep = btScalar(1.0 / 60.0);
// Offsets of fields in the header, and its length.
constexpr std::size_t kVersionAt = 8;
constexpr std::size_t kKindAt = 12;
constexpr std::size_t kPrecisionAt = 13;
constexpr std::size_t kHeaderBytes = 22;
constexpr std::size_t kChecksumBytes = 8;

// Adds a valid checksum, as an attacker who knows the format would.
Snapshot sealed(Snapshot snapshot) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  const std::size_t end = snapshot.size() - kChecksumBytes;
  for (std::size_t i = 0; i < end;) {
    std::uint64_t word = 0;
    for (int shift = 0; shift < 64 && i < end; shift += 8)
      word |= static_cast<std::uint64_t>(snapshot[i++]) << shift;
    sum = (sum ^ word) * 0x100000001b3U;
    sum ^= sum >> 32;
  }
  for (std::size_t i = 0; i < kChecksumBytes; ++i)
    snapshot[end + i] = static_cast<std::byte>(sum >> (8 * i) & 0xff);
  return snapshot;
}

Snapshot with_byte(Snapshot snapshot, std::size_t at, unsigned value) {
  snapshot[at] = static_cast<std::byte>(value);
  return snapshot;
}

template <class Restore>
std::string refusal(const Restore& restore) {
  try {
    restore();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "restored";
}

template <class Way>
class HostileSnapshot : public ::testing::Test {
 protected:
  HostileSnapshot() {
    add_chain(way, 2);
    way.add_floor();
    box = &way.add_box(btVector3(1, 1, 1), 1, btTransform(btQuaternion::getIdentity(), btVector3(9, 9, 1)));
    box->setAngularVelocity(btVector3(0, 0, 3));
    way.step(kStep, 20);
    of_body = way.rotation().save(*box);
    of_world = way.rotation().save_world();
    way.step(kStep, 5);
    digest = digest_of(way.world(), way.rotation());
  }
  std::string refusal_of_body(const Snapshot& snapshot) {
    return refusal([&] { way.rotation().restore(*box, snapshot); });
  }
  std::string refusal_of_world(const Snapshot& snapshot) {
    return refusal([&] { way.rotation().restore_world(snapshot); });
  }
  void expect_unchanged() { EXPECT_EQ(digest_of(way.world(), way.rotation()), digest); }

  Way way;
  btRigidBody* box = nullptr;
  Snapshot of_body;
  Snapshot of_world;
  std::uint64_t digest = 0;
};
TYPED_TEST_SUITE(HostileSnapshot, BothWays, WayName);

TYPED_TEST(HostileSnapshot, CutAnywhereIsRefused) {
  for (std::size_t size = 0; size < this->of_body.size(); ++size) {
    const Snapshot cut(this->of_body.begin(), this->of_body.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THAT(this->refusal_of_body(cut), HasSubstr("bytes")) << size;
  }
  for (std::size_t size = 0; size < this->of_world.size(); ++size) {
    const Snapshot cut(this->of_world.begin(), this->of_world.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THAT(this->refusal_of_world(cut), HasSubstr("bytes")) << size;
  }
  Snapshot longer = this->of_body;
  longer.push_back(std::byte{0});
  EXPECT_THAT(this->refusal_of_body(longer), HasSubstr("truncated or extended"));
  this->expect_unchanged();
}

TYPED_TEST(HostileSnapshot, WithAnyByteChangedIsRefused) {
  for (const unsigned flipped : {0x01U, 0x80U, 0xffU}) {
    for (std::size_t i = 0; i < this->of_body.size(); ++i) {
      Snapshot damaged = this->of_body;
      damaged[i] ^= static_cast<std::byte>(flipped);
      EXPECT_NE(this->refusal_of_body(damaged), "restored") << i;
    }
    for (std::size_t i = 0; i < this->of_world.size(); ++i) {
      Snapshot damaged = this->of_world;
      damaged[i] ^= static_cast<std::byte>(flipped);
      EXPECT_NE(this->refusal_of_world(damaged), "restored") << i;
    }
  }
  this->expect_unchanged();
}

// An attacker can recompute the checksum. Whatever the bytes are, restoring must be memory-safe and the next
// step must end.
TYPED_TEST(HostileSnapshot, WithAnyByteForgedIsRefusedOrRestored) {
  int restored = 0;
  for (std::size_t i = kHeaderBytes; i < this->of_world.size() - kChecksumBytes; ++i) {
    Snapshot forged = this->of_world;
    forged[i] ^= std::byte{0x41};
    if (this->refusal_of_world(sealed(forged)) != "restored") continue;
    ++restored;
    if (i % 7 == 0) this->way.step(kStep);
  }
  EXPECT_GT(restored, 0);
  this->way.rotation().restore_world(this->of_world);
  EXPECT_EQ(this->way.rotation().save_world(), this->of_world);
}

TYPED_TEST(HostileSnapshot, OfAnotherVersionIsRefused) {
  for (const unsigned version : {0U, 2U, 255U}) {
    const std::string message = this->refusal_of_body(sealed(with_byte(this->of_body, kVersionAt, version)));
    EXPECT_THAT(message,
                HasSubstr("format version is " + std::to_string(version) + "; this library reads version 1"));
  }
  this->expect_unchanged();
}

TYPED_TEST(HostileSnapshot, OfTheOtherPrecisionIsRefused) {
  const unsigned other = sizeof(btScalar) == 4 ? 8 : 4;
  EXPECT_THAT(this->refusal_of_body(sealed(with_byte(this->of_body, kPrecisionAt, other))),
              HasSubstr("numbers have " + std::to_string(other) + " bytes; here they have"));
  this->expect_unchanged();
}

TYPED_TEST(HostileSnapshot, OfAnotherKindIsRefused) {
  EXPECT_THAT(this->refusal_of_body(this->of_world), HasSubstr("it is of a world; one body is required"));
  EXPECT_THAT(this->refusal_of_world(this->of_body), HasSubstr("it is of one body; a world is required"));
  EXPECT_NE(this->refusal_of_world(sealed(with_byte(this->of_body, kKindAt, 2))), "restored");
  EXPECT_THAT(this->refusal_of_body(with_byte(this->of_body, 0, 'X')), HasSubstr("PLHDSNAP"));
  this->expect_unchanged();
}

TYPED_TEST(HostileSnapshot, WithANumberThatIsNotFiniteIsRefused) {
  // Overwrites each possible position of a number in the record.
  const btScalar bad[] = {std::numeric_limits<btScalar>::quiet_NaN(),
                          std::numeric_limits<btScalar>::infinity()};
  int refused = 0;
  for (const btScalar number : bad) {
    for (std::size_t i = kHeaderBytes; i + sizeof number + kChecksumBytes <= this->of_body.size(); ++i) {
      Snapshot forged = this->of_body;
      std::memcpy(&forged[i], &number, sizeof number);
      refused += this->refusal_of_body(sealed(forged)).find("not finite") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GT(refused, 100);
  // The pose is the first field of a body, after its two types.
  Snapshot forged = this->of_body;
  std::memcpy(&forged[kHeaderBytes + 8], &bad[0], sizeof bad[0]);
  EXPECT_THAT(this->refusal_of_body(sealed(forged)), HasSubstr("a number that is not finite"));
  this->way.rotation().restore(*this->box, this->of_body);
}

TYPED_TEST(HostileSnapshot, OfANonFiniteBodyIsRefused) {
  this->box->setLinearVelocity(btVector3(std::numeric_limits<btScalar>::quiet_NaN(), 0, 0));
  EXPECT_THROW(this->way.rotation().save(*this->box), std::invalid_argument);
  EXPECT_THROW(this->way.rotation().save_world(), std::invalid_argument);
}

TYPED_TEST(HostileSnapshot, OfAnotherBodyIsRefused) {
  btRigidBody& heavier =
      this->way.add_box(btVector3(1, 1, 1), 2, btTransform(btQuaternion::getIdentity(), btVector3(-9, 9, 1)));
  const btVector3 velocity(1, 2, 3);
  heavier.setLinearVelocity(velocity);
  EXPECT_THAT(refusal([&] { this->way.rotation().restore(heavier, this->of_body); }),
              HasSubstr("this body has inverse mass 0.5"));
  btRigidBody& ball = this->way.add(1, btVector3(1, 1, 1), btTransform::getIdentity(),
                                    this->way.template shape<btSphereShape>(btScalar(1)));
  EXPECT_THAT(refusal([&] { this->way.rotation().restore(ball, this->of_body); }), HasSubstr("another type"));
  EXPECT_EQ(heavier.getLinearVelocity(), velocity);
  this->way.world().removeRigidBody(&heavier);
  EXPECT_THAT(refusal([&] { this->way.rotation().restore(heavier, this->of_body); }),
              HasSubstr("not in the world"));
}

TYPED_TEST(HostileSnapshot, OfAnotherWorldIsRefused) {
  RotationControl& rotation = this->way.rotation();
  this->box->setMassProps(2, btVector3(1, 1, 1));
  EXPECT_THAT(this->refusal_of_world(this->of_world), HasSubstr("object 3 has inverse mass 0.5"));
  WorldOrder order = order_of(this->way.world());
  order.objects[0] = order.objects[1];
  EXPECT_THAT(refusal([&] { rotation.restore_world(this->of_world, order); }), HasSubstr("exactly once"));
  this->way.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0));
  EXPECT_THAT(this->refusal_of_world(this->of_world), HasSubstr("of a world with 4 bodies"));
}

class UnknownScheme final : public RotationScheme {
 public:
  explicit UnknownScheme(const char* name) : name_(name) {}
  SchemeDescription description() const noexcept override {
    SchemeDescription description;
    description.name = name_;
    return description;
  }
  void step(const StepInput& /*input*/, RotationState& /*state*/) const noexcept override {}

 private:
  const char* name_;
};

TYPED_TEST(HostileSnapshot, OfAnUnknownSchemeWantsTheBodyToHaveIt) {
  RotationControl& rotation = this->way.rotation();
  rotation.set_scheme(*this->box, std::make_shared<UnknownScheme>("mine"));
  this->way.step(kStep);
  const Snapshot snapshot = rotation.save(*this->box);
  rotation.restore(*this->box, snapshot);
  rotation.set_scheme(*this->box, "exact");
  EXPECT_THAT(this->refusal_of_body(snapshot),
              HasSubstr("the scheme \"mine\", which is unknown: register it"));
  // Another scheme object of the same name is accepted.
  rotation.set_scheme(*this->box, std::make_shared<UnknownScheme>("mine"));
  EXPECT_EQ(this->refusal_of_body(snapshot), "restored");
}

TYPED_TEST(HostileSnapshot, WithinAStepIsRefused) {
  static RotationControl* rotation = nullptr;
  static int refused = 0;
  rotation = &this->way.rotation();
  refused = 0;
  static const Snapshot* to_restore = nullptr;
  to_restore = &this->of_world;
  struct Watching : btSequentialImpulseConstraintSolver {
    void allSolved(const btContactSolverInfo& info, btIDebugDraw* drawer) override {
      btSequentialImpulseConstraintSolver::allSolved(info, drawer);
      const auto count_refusal = [](const auto& call) {
        try {
          call();
        } catch (const std::logic_error& error) {
          refused += std::string(error.what()).find("within a step") != std::string::npos ? 1 : 0;
        }
      };
      count_refusal([] { rotation->save_world(); });
      count_refusal([] { rotation->restore_world(*to_restore); });
    }
  } watching;
  btConstraintSolver* const own = this->way.world().getConstraintSolver();
  this->way.world().setConstraintSolver(&watching);
  this->way.step(kStep);
  this->way.world().setConstraintSolver(own);
  EXPECT_EQ(refused, 2);
}

}  // namespace
}  // namespace polhode::testing
