#include "free_top/gyrostat_step.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "free_top/free_top_step.h"
#include "polhode/rotation_math.h"

namespace polhode::free_top {

namespace {

constexpr std::size_t kTerms = 30;
// Relative to a unit quaternion, below rounding. Two consecutive terms below this end a series.
constexpr double kSmallestTerm = 1e-17;
// Factor by which a part of a step is shortened until it is short enough. Below kShortestPart the series is
// not finite.
constexpr double kShorter = 0.9;
constexpr double kShortestPart = 1e-12;
// Relative to omega^2. Far from an equilibrium, the energy determines the momentum up to rounding. Near an
// equilibrium it does not, and correcting the energy gains nothing.
constexpr double kFlat = 1e-16;

// The turn rho since the start of a substep, rho(s) = sum s^k rho_k, with s from 0 to 1 over `dt`.
class TurnSeries {
 public:
  TurnSeries(const Vector3& inertia_B, const Vector3& L_B, const Vector3& rotor_B, double dt) {
    L_[0] = L_B;
    omega_[0] = (L_B - rotor_B).cwiseQuotient(inertia_B);
    rho_[0] = Quaternion::Identity().coeffs();
    while (!converged_ && size_ < kTerms) add_term(inertia_B, dt);
  }

  bool converged() const { return converged_; }

  // Returns the part of dt after which the omitted terms are below rounding, or 0 if there is none. Uses
  // products only: the math library's pow differs between machines.
  double reach() const {
    double part = 1.0;
    for (std::size_t k = size_ - 2; k < size_; ++k) {
      double term = rho_[k].norm();
      double shorter = 1.0;
      for (std::size_t i = 0; i < k; ++i) shorter *= kShorter;
      double reached = 1.0;
      while (!(term < kSmallestTerm) && reached > kShortestPart) {
        term *= shorter;
        reached *= kShorter;
      }
      part = std::fmin(part, reached > kShortestPart ? reached : 0.0);
    }
    return part;
  }

  Quaternion turn_at(double s) const {
    Eigen::Vector4d sum = rho_[size_ - 1];
    for (std::size_t k = size_ - 1; k > 0; --k) sum = rho_[k - 1] + s * sum;
    return Quaternion(sum);
  }

 private:
  void add_term(const Vector3& inertia_B, double dt) {
    Vector3 L = Vector3::Zero();
    Eigen::Vector4d rho = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < size_; ++i) {
      const Vector3& omega = omega_[size_ - 1 - i];
      L += L_[i].cross(omega);
      rho += (Quaternion(rho_[i]) * Quaternion(0.0, omega.x(), omega.y(), omega.z())).coeffs();
    }
    const double dt_per_k = dt / static_cast<double>(size_);
    L_[size_] = dt_per_k * L;
    omega_[size_] = L_[size_].cwiseQuotient(inertia_B);
    rho_[size_] = 0.5 * dt_per_k * rho;
    const double two_terms = rho_[size_].norm() + rho_[size_ - 1].norm();
    ++size_;
    converged_ = size_ > 2 && two_terms < kSmallestTerm;
  }

  std::array<Vector3, kTerms> L_;
  std::array<Vector3, kTerms> omega_;
  std::array<Eigen::Vector4d, kTerms> rho_;  // Eigen's order: x, y, z, w
  std::size_t size_ = 1;
  bool converged_ = false;
};

Quaternion turned(const StepInput& input, const Vector3& L_W, const Vector3& rotor_B, Quaternion q_WB) {
  double left = input.dt;
  for (int substep = 0; substep < kMostGyrostatSubsteps; ++substep) {
    const TurnSeries series(input.inertia_B, q_WB.conjugate() * L_W, rotor_B, left);
    const double part = series.converged() ? 1.0 : series.reach();
    if (!(part > 0.0)) break;
    q_WB = (q_WB * series.turn_at(part)).normalized();
    if (part == 1.0) return q_WB;
    left *= 1.0 - part;
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, nan, nan};
}

struct Momentum {
  Vector3 L_B;
  Vector3 omega_B;
  double energy;
};

Momentum momentum_at(const Quaternion& q_WB, const Vector3& inertia_B, const Vector3& L_W,
                     const Vector3& rotor_B) {
  const Vector3 L_B = q_WB.conjugate() * L_W;
  const Vector3 omega_B = (L_B - rotor_B).cwiseQuotient(inertia_B);
  return {L_B, omega_B, 0.5 * omega_B.dot(L_B - rotor_B)};
}

// Returns q_WB after the smallest turn that moves L_B, at constant length, to the given energy. First order
// is enough to correct rounding. dT = omega . dL, and dL can only be normal to L.
Quaternion held_at(double energy, const Quaternion& q_WB, const Vector3& inertia_B, const Vector3& L_W,
                   const Vector3& rotor_B) {
  const Momentum now = momentum_at(q_WB, inertia_B, L_W, rotor_B);
  const double L2 = now.L_B.squaredNorm();
  const double omega2 = now.omega_B.squaredNorm();
  if (!(L2 > kAtRest * kAtRest && omega2 > 0.0)) return q_WB;
  const Vector3 slope_B = now.omega_B - now.L_B * (now.omega_B.dot(now.L_B) / L2);
  const Vector3 change_B = slope_B * ((energy - now.energy) / (slope_B.squaredNorm() + kFlat * omega2));
  const Vector3 half_turn_B = change_B.cross(now.L_B) * (0.5 / L2);
  return (q_WB * Quaternion(1.0, half_turn_B.x(), half_turn_B.y(), half_turn_B.z())).normalized();
}

}  // namespace

void turn_gyrostat(const StepInput& input, const Vector3& L_W, RotationState& state, KeptEnergy* kept) {
  const Vector3& rotor_B = state.rotor_momentum_B;
  Quaternion q_WB = turned(input, L_W, rotor_B, state.q_WB);
  if (kept != nullptr) {
    if (kept->L_W != L_W || kept->rotor_B != rotor_B) {
      *kept = {L_W, rotor_B, momentum_at(state.q_WB, input.inertia_B, L_W, rotor_B).energy};
    }
    q_WB = held_at(kept->energy, q_WB, input.inertia_B, L_W, rotor_B);
  }
  set_orientation(state, q_WB);
}

namespace {

// Stored in place of FreeTopStep::dt: no step has this length.
constexpr double kNoStep = -std::numeric_limits<double>::max();
constexpr std::size_t kPlaceOfDt = 4;
constexpr std::array<std::size_t, 7> kPlaces = {1, 2, 3, 5, 6, 7, 8};
static_assert(offsetof(FreeTopStep<double>, dt) == kPlaceOfDt * sizeof(double));

template <class Self, class Function>
void for_each_number(Self& kept, const Function& function) {
  for (std::size_t i = 0; i < 3; ++i) function(kept.L_W[static_cast<int>(i)], kPlaces[i]);
  for (std::size_t i = 0; i < 3; ++i) function(kept.rotor_B[static_cast<int>(i)], kPlaces[3 + i]);
  function(kept.energy, kPlaces[6]);
}

}  // namespace

KeptEnergy get_kept_energy(std::size_t lane, const WideMemoryRow* memory) {
  KeptEnergy kept{Vector3::Constant(std::numeric_limits<double>::quiet_NaN()), Vector3::Zero(), 0.0};
  if (memory[kPlaceOfDt][lane] != kNoStep) return kept;
  for_each_number(kept, [&](double& number, std::size_t row) { number = memory[row][lane]; });
  return kept;
}

void set_kept_energy(std::size_t lane, const KeptEnergy& kept, WideMemoryRow* memory) {
  memory[kPlaceOfDt].set(lane, kNoStep);
  for_each_number(kept, [&](const double& number, std::size_t row) { memory[row].set(lane, number); });
}

}  // namespace polhode::free_top
