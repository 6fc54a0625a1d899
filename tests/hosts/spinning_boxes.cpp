// Steps free spinning boxes in an engine of ignition-physics and prints how well each box keeps energy,
// angular momentum and orientation.
//   spinning_boxes bullet|dart [DT [DURATION]]    seconds; default 1/1000, 60
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <ignition/physics/ConstructEmpty.hh>
#include <ignition/physics/ForwardStep.hh>
#include <ignition/physics/FrameSemantics.hh>
#include <ignition/physics/FreeGroup.hh>
#include <ignition/physics/RequestEngine.hh>
#include <ignition/physics/sdf/ConstructLink.hh>
#include <ignition/physics/sdf/ConstructModel.hh>
#include <ignition/physics/sdf/ConstructWorld.hh>
#include <ignition/plugin/Loader.hh>
#include <sdf/Link.hh>
#include <sdf/Model.hh>
#include <sdf/Root.hh>
#include <sdf/World.hh>
#include <stdexcept>
#include <string>
#include <vector>

#include "bullet_bodies.h"
#include "free_motion.h"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Arguments {
  std::string engine;
  double dt_s = 1e-3;
  double duration_s = 60.0;
};

struct Figures {
  double energy_ratio = 1.0;
  double momentum_ratio = 1.0;
  double turn_of_momentum = 0.0;
  double attitude_error = 0.0;
  double worst_attitude_error = 0.0;
};

// A box, its exact motion, and the engine's deviation from it.
class Box {
 public:
  /// Takes the engine's own values of `inertia_B`, and starts the exact motion from the state that the engine
  /// reports, so that the rounding of a single-precision engine's input does not count as an error.
  Box(const Vector3d& inertia_B, const ignition::physics::FrameData3d& start)
      : inertia_B_(inertia_B),
        exact_(inertia_B, start.pose.linear(), start.angularVelocity),
        speed_(start.angularVelocity.norm()),
        L0_(momentum(start)),
        energy0_(energy(start)) {}

  void advance(double duration_s) {
    exact_.advance(duration_s);
    end_s_ += duration_s;
  }

  void measure(const ignition::physics::FrameData3d& now) {
    const Vector3d L = momentum(now);
    figures_.energy_ratio = energy(now) / energy0_;
    figures_.momentum_ratio = L.norm() / L0_.norm();
    figures_.turn_of_momentum = std::atan2(L.cross(L0_).norm(), L.dot(L0_));
    figures_.attitude_error = exact_.angle_to(now.pose.linear());
    figures_.worst_attitude_error = std::max(figures_.worst_attitude_error, figures_.attitude_error);
  }

  /// Above this limit the numbers soon become non-finite; DART then ends the process with an assertion.
  bool has_blown_up() const { return !(figures_.energy_ratio < 100.0); }

  void print(const Arguments& arguments) const {
    std::printf("%s,%.9g,%g,%.4g,%.9f,%.9f,%.3g,%.3g,%.3g\n", arguments.engine.c_str(), arguments.dt_s,
                speed_, end_s_, figures_.energy_ratio, figures_.momentum_ratio, figures_.turn_of_momentum,
                figures_.attitude_error, figures_.worst_attitude_error);
  }

 private:
  Vector3d momentum(const ignition::physics::FrameData3d& data) const {
    const Matrix3d R_WB = data.pose.linear();
    return R_WB * inertia_B_.cwiseProduct(R_WB.transpose() * data.angularVelocity);
  }
  double energy(const ignition::physics::FrameData3d& data) const {
    return 0.5 * data.angularVelocity.dot(momentum(data));
  }

  Vector3d inertia_B_;
  FreeMotion exact_;
  double speed_;
  double end_s_ = 0.0;
  Vector3d L0_;
  double energy0_;
  Figures figures_;
};

Vector3d vector_of(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}

sdf::Root load(const std::string& file) {
  sdf::Root root;
  for (const sdf::Error& error : root.Load(file)) throw std::runtime_error(error.Message());
  return root;
}

// Features that both engines have.
struct CommonFeatures
    : ignition::physics::FeatureList<
          ignition::physics::ConstructEmptyWorldFeature, ignition::physics::FindFreeGroupFeature,
          ignition::physics::ForwardStep, ignition::physics::LinkFrameSemantics,
          ignition::physics::sdf::ConstructSdfLink, ignition::physics::sdf::ConstructSdfModel,
          ignition::physics::sdf::ConstructSdfWorld> {};
struct FeaturesWithVelocity
    : ignition::physics::FeatureList<CommonFeatures, ignition::physics::SetFreeGroupWorldVelocity> {};

// The differences between the engines: how to set a body spinning, and the numbers that the engine rounds.
template <class FeatureList>
struct Engine {
  using Link = ignition::physics::Link3d<FeatureList>;

  std::string library;
  std::string plugin;
  std::function<void(Link&, const Vector3d& omega_W)> set_spinning;
  std::function<Vector3d(const Vector3d& inertia_B)> inertia;
  std::function<double(double dt_s)> time_step;
};

// The world holds a single box, since a box that diverges ends its world.
template <class World, class FeatureList>
void run_box(World& world, const Engine<FeatureList>& engine, const sdf::Model& description,
             const Arguments& arguments) {
  // Without its link, which is constructed separately: Bullet's plugin cannot look up links later.
  sdf::Model model;
  model.SetName(description.Name());
  const sdf::Link& link_description = *description.LinkByIndex(0);
  const auto link = world.ConstructModel(model)->ConstructLink(link_description);
  engine.set_spinning(
      *link,
      vector_of(link_description.Element()->template Get<ignition::math::Vector3d>("spin:angular_velocity")));
  Box box(engine.inertia(vector_of(link_description.Inertial().MassMatrix().DiagonalMoments())),
          link->FrameDataRelativeToWorld());

  using std::chrono::duration;
  using std::chrono::steady_clock;
  const auto dt = std::chrono::duration_cast<steady_clock::duration>(duration<double>(arguments.dt_s));
  const double time_step = engine.time_step(duration<double>(dt).count());
  ignition::physics::ForwardStep::Input input;
  ignition::physics::ForwardStep::State state;
  ignition::physics::ForwardStep::Output output;
  input.Get<steady_clock::duration>() = dt;
  const long steps = std::lround(arguments.duration_s / arguments.dt_s);
  for (long step = 0; step < steps && !box.has_blown_up(); ++step) {
    world.Step(output, state, input);
    box.advance(time_step);
    box.measure(link->FrameDataRelativeToWorld());
  }
  box.print(arguments);
}

template <class FeatureList>
void run(const Engine<FeatureList>& engine, const Arguments& arguments) {
  ignition::plugin::Loader loader;
  loader.LoadLib(std::string(POLHODE_HOSTS_ENGINES) + "/" + engine.library);
  const auto physics =
      ignition::physics::RequestEngine3d<FeatureList>::From(loader.Instantiate(engine.plugin));
  if (!physics) throw std::runtime_error(engine.library + " cannot be loaded or lacks a feature");

  const sdf::Root root = load(POLHODE_HOSTS_SDF);
  const sdf::World& description = *root.WorldByIndex(0);
  for (std::size_t index = 0; index < description.ModelCount(); ++index) {
    const sdf::Model& model = *description.ModelByIndex(index);
    sdf::World empty;
    empty.SetName(model.Name());
    empty.SetGravity(description.Gravity());
    run_box(*physics->ConstructWorld(empty), engine, model, arguments);
  }
}

Engine<CommonFeatures> bullet() {
  return {"libignition-physics5-bullet-plugin.so.5", "ignition::physics::bullet::Plugin",
          [](auto&, const Vector3d& omega_W) {
            added_bullet_bodies().back()->setAngularVelocity(
                btVector3(btScalar(omega_W.x()), btScalar(omega_W.y()), btScalar(omega_W.z())));
          },
          [](const Vector3d&) {
            const btVector3& inverse = added_bullet_bodies().back()->getInvInertiaDiagLocal();
            return Vector3d(1.0 / inverse.x(), 1.0 / inverse.y(), 1.0 / inverse.z());
          },
          [](double dt_s) { return static_cast<double>(static_cast<btScalar>(dt_s)); }};
}

Engine<FeaturesWithVelocity> dart() {
  return {"libignition-physics5-dartsim-plugin.so.5", "ignition::physics::dartsim::Plugin",
          [](auto& link, const Vector3d& omega_W) { link.FindFreeGroup()->SetWorldAngularVelocity(omega_W); },
          [](const Vector3d& inertia_B) { return inertia_B; }, [](double dt_s) { return dt_s; }};
}

Arguments read(int argc, char** argv) {
  if (argc < 2 || argc > 4) throw std::invalid_argument("usage: spinning_boxes bullet|dart [DT [DURATION]]");
  Arguments arguments;
  arguments.engine = argv[1];
  if (argc > 2) arguments.dt_s = std::stod(argv[2]);
  if (argc > 3) arguments.duration_s = std::stod(argv[3]);
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Arguments arguments = read(argc, argv);
    std::puts(
        "engine,dt_s,spin_rad_s,end_s,energy_ratio,momentum_ratio,turn_of_momentum_rad,attitude_error_rad,"
        "worst_attitude_error_rad");
    if (arguments.engine == "bullet") {
      run(bullet(), arguments);
    } else if (arguments.engine == "dart") {
      run(dart(), arguments);
    } else {
      throw std::invalid_argument("unknown engine " + arguments.engine + ": valid are bullet, dart");
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "spinning_boxes: %s\n", error.what());
    return 2;
  }
}
