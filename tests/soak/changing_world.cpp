#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "polhode/bullet/rotation_plugin.h"
#include "soak/soak_run.h"
#include "soak/watched_body.h"
#include "support/motion.h"
#include "support/scene.h"
#include "support/uniform.h"

namespace polhode::testing {

namespace {

constexpr std::size_t kBodies = 1000;
constexpr std::size_t kWatched = 200;           // the first bodies: free, `exact`, never changed
constexpr std::size_t kPiled = 100;             // the last bodies: in pairs on platforms
constexpr std::uint64_t kReattachEvery = 2000;  // steps
// Containers keep the capacity of their largest size.
constexpr std::int64_t kHeapSlack = 64 * 1024;  // bytes; measured 20 KiB

// Schemes that never diverge at these spins.
constexpr const char* kSchemes[] = {"exact",          "quaternion",        "implicit_gyroscopic", "bullet",
                                    "axis_splitting", "implicit_midpoint", "moser_veselov",       "rk4"};

/// A place in the world, its present body, and the data that the library should report about the body.
struct Place {
  std::unique_ptr<btRigidBody> body;
  bool is_released = false;
  std::string scheme;
  std::uint64_t steps = 0;  ///< since the scheme was set or the plugin attached
  std::optional<WatchedBody> watched;
};

class ChangingWorld {
 public:
  explicit ChangingWorld(std::int64_t steps)
      : run_("changing world", steps, kHeapSlack), plugin_(scene_.world()) {
    for (std::size_t i = 0; i < kPiled / 2; ++i) {
      scene_.add(0, vector(0, 0, 0), btTransform(btQuaternion::getIdentity(), origin_of(2 * i, -1)),
                 platform_shape_);
    }
    for (std::size_t i = 0; i < kBodies; ++i) put_body_in(i);
  }
  ~ChangingWorld() {
    for (const Place& place : places_) scene_.world().removeRigidBody(place.body.get());
  }
  ChangingWorld(const ChangingWorld&) = delete;
  ChangingWorld& operator=(const ChangingWorld&) = delete;

  bool soak() {
    for (std::int64_t step = 1; step <= run_.steps(); ++step) {
      if (chance(0.3)) change_something();
      if (chance(1.0 / kReattachEvery)) reattach();
      scene_.step(btScalar(1.0 / 60));
      for (Place& place : places_) ++place.steps;
      if (run_.is_checkpoint(step)) check(step);
    }
    return run_.passed();
  }

 private:
  double uniform(double low, double high) { return testing::uniform(random_, low, high); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  btVector3 random_vector(double low, double high) {
    const double x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
    return vector(x, y, z);
  }
  std::size_t any_place() { return static_cast<std::size_t>(uniform(kWatched, kBodies)); }

  static bool is_piled(std::size_t i) { return i >= kBodies - kPiled; }
  static btVector3 origin_of(std::size_t i, double height) {
    const std::size_t column = i % 40;
    const std::size_t row = i / 40;
    return vector(10.0 * static_cast<double>(column), 10.0 * static_cast<double>(row), height);
  }

  void put_body_in(std::size_t i) {
    Place& place = places_[i];
    const bool piled = is_piled(i);
    const btVector3 inertia_B = piled ? vector(0.1, 0.12, 0.15) : random_vector(0.8, 1.6);
    const btVector3 omega_W = random_vector(-3, 3);
    place.body = std::make_unique<btRigidBody>(btScalar(1), nullptr, &shape_, inertia_B);
    btRigidBody& body = *place.body;
    const std::size_t number = i - (kBodies - kPiled);
    body.setWorldTransform(
        btTransform(btQuaternion::getIdentity(),
                    piled ? origin_of(number / 2 * 2, number % 2 == 0 ? 0.5 : 1.6) : origin_of(i, 100)));
    body.setInterpolationWorldTransform(body.getWorldTransform());
    body.setActivationState(DISABLE_DEACTIVATION);
    scene_.world().addRigidBody(&body);
    if (piled) body.setGravity(vector(0, 0, -9.81));
    body.setAngularVelocity(piled ? vector(0, 0, 0) : omega_W);
    place.is_released = false;
    place.scheme = "exact";  // the default scheme
    place.steps = 0;
  }

  void replace(std::size_t i) {
    scene_.world().removeRigidBody(places_[i].body.get());
    if (chance(0.5)) places_[i].body.reset();  // the new body may get the address of the old one
    put_body_in(i);
  }

  void choose_scheme(std::size_t i) {
    Place& place = places_[i];
    place.scheme = kSchemes[static_cast<std::size_t>(uniform(0, std::size(kSchemes)))];
    plugin_.rotation().set_scheme(*place.body, place.scheme);
    place.is_released = false;
    place.steps = 0;
  }

  void release(std::size_t i) {
    plugin_.rotation().release(*places_[i].body);
    places_[i].is_released = true;
  }

  void use_default(std::size_t i) {
    Place& place = places_[i];
    plugin_.rotation().use_default_scheme(*place.body);
    place.is_released = false;
    place.scheme = "exact";
    place.steps = 0;
  }

  void change_something() {
    const std::size_t i = any_place();
    const double what = uniform(0, 6);
    if (what < 2) {
      replace(i);
    } else if (what < 4) {
      choose_scheme(i);
    } else if (what < 4.5) {
      release(i);
    } else if (what < 5) {
      use_default(i);
    } else {
      // Halves a spin that kicks have made too fast for some schemes.
      places_[i].body->setAngularVelocity(places_[i].body->getAngularVelocity() * btScalar(0.5));
      places_[i].body->applyTorqueImpulse(random_vector(-0.5, 0.5));
    }
  }

  // Detaches the plugin for a few steps, or none, during which bodies come and go.
  void reattach() {
    plugin_.detach();
    run_.require(plugin_.rotation().managed_bodies() == 0, 0, "managed bodies while detached");
    const int steps = static_cast<int>(uniform(0, 4));
    for (int step = 0; step < steps; ++step) {
      change_something();
      scene_.step(btScalar(1.0 / 60));
    }
    plugin_.attach();
    for (Place& place : places_) {
      place.steps = 0;
      place.watched.reset();
    }
  }

  void check(std::int64_t step) {
    const RotationControl& rotation = plugin_.rotation();
    std::size_t expected = 0;
    for (std::size_t i = 0; i < kBodies; ++i) {
      Place& place = places_[i];
      run_.require(rotation.manages(*place.body) == !place.is_released, step, "manages");
      if (place.is_released) continue;
      ++expected;
      const BodyRotation now = rotation.rotation_of(*place.body);
      run_.require(now.scheme == place.scheme, step,
                   "scheme " + std::string(now.scheme) + ", not " + place.scheme);
      run_.require(now.steps == place.steps, step,
                   "steps " + std::to_string(now.steps) + ", not " + std::to_string(place.steps));
      if (i >= kWatched) continue;
      if (place.watched.has_value()) {
        place.watched->add_drift(now, drift_);
      } else {
        place.watched.emplace(now);
      }
    }
    run_.require(rotation.managed_bodies() == expected, step, "managed bodies");
    run_.require(rotation.incidents() == 0, step, "incidents " + std::to_string(rotation.incidents()));
    run_.check(step, drift_, rotation.managed_bodies());
  }

  SoakRun run_;
  std::mt19937 random_{1};
  Scene<> scene_;
  btBoxShape shape_{vector(0.5, 0.5, 0.5)};
  btBoxShape platform_shape_{vector(3, 3, 1)};
  RotationPlugin plugin_;
  std::vector<Place> places_{kBodies};
  Drift drift_;
};

}  // namespace

bool soak_changing_world(std::int64_t steps) {
  return ChangingWorld(steps).soak();
}

}  // namespace polhode::testing
