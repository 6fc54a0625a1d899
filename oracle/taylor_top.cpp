#include "oracle/taylor_top.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace polhode::oracle {

namespace {

using Number = boost::multiprecision::cpp_bin_float_50;
using Numbers3 = std::array<Number, 3>;
using Numbers4 = std::array<Number, 4>;  // w, x, y, z

constexpr int kOrder = 36;

template <std::size_t size>
Number length(const std::array<Number, size>& v) {
  Number sum = 0;
  for (const Number& component : v) sum += component * component;
  return sqrt(sum);
}

Numbers4 product(const Numbers4& a, const Numbers4& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Numbers4 conjugate(const Numbers4& q) {
  return {q[0], -q[1], -q[2], -q[3]};
}

Numbers4 numbers(const Quaternion& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

template <std::size_t size>
std::array<Number, size> value_after(const std::array<std::array<Number, size>, kOrder + 1>& series,
                                     const Number& h) {
  std::array<Number, size> value = series[kOrder];
  for (int n = kOrder - 1; n >= 0; --n) {
    for (std::size_t i = 0; i < size; ++i) value[i] = value[i] * h + series[n][i];
  }
  return value;
}

}  // namespace

struct TaylorTop::State {
  void expand();
  double longest_step() const;
  // Moves to time h after the expansion.
  void move_to(const Number& h);
  Numbers4 L_W() const { return product(product(q_WB, {0, L_B[0], L_B[1], L_B[2]}), conjugate(q_WB)); }

  Numbers3 inertia_B, L_B, rotor_B;
  Numbers4 q_WB, start_L_W;
  // Coefficients of t^n.
  std::array<Numbers3, kOrder + 1> L_series, omega_series;
  std::array<Numbers4, kOrder + 1> q_series;
  Number since_expansion = 0, reach = 0;  // s; reach: range of the expansion
};

// The expansion stays valid over as many calls of advance as its range allows, since it costs as much as a
// hundred evaluations.
void TaylorTop::State::expand() {
  L_series[0] = L_B;
  q_series[0] = q_WB;
  for (int n = 0; n <= kOrder; ++n) {
    for (int i = 0; i < 3; ++i) {
      omega_series[n][i] = (n == 0 ? Number(L_B[i] - rotor_B[i]) : L_series[n][i]) / inertia_B[i];
    }
    if (n == kOrder) break;
    Numbers3 L_rate{};
    Numbers4 q_rate{};
    for (int k = 0; k <= n; ++k) {
      const Numbers3 &L = L_series[k], &omega = omega_series[n - k];
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        L_rate[i] += L[j] * omega[l] - L[l] * omega[j];
      }
      const Numbers4 turned = product(q_series[k], {0, omega[0], omega[1], omega[2]});
      for (int i = 0; i < 4; ++i) q_rate[i] += turned[i] / 2;
    }
    for (int i = 0; i < 3; ++i) L_series[n + 1][i] = L_rate[i] / (n + 1);
    for (int i = 0; i < 4; ++i) q_series[n + 1][i] = q_rate[i] / (n + 1);
  }
  since_expansion = 0;
  reach = longest_step();
}

void TaylorTop::State::move_to(const Number& h) {
  L_B = value_after(L_series, h);
  q_WB = value_after(q_series, h);
  since_expansion = h;
}

// From the last two coefficients (Jorba & Zou 2005); two, because one of them may vanish.
double TaylorTop::State::longest_step() const {
  const auto step_for = [](const Number& coefficient, int n) {
    return coefficient == 0 ? 1e300 : static_cast<double>(pow(Number(1e-40) / coefficient, Number(1) / n));
  };
  const Number L_length = length(L_B);
  double h = 1e300;
  for (const int n : {kOrder - 1, kOrder}) {
    h = std::min(h, step_for(length(q_series[n]), n));
    if (L_length != 0) h = std::min(h, step_for(Number(length(L_series[n]) / L_length), n));
  }
  return h;
}

TaylorTop::TaylorTop(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& L_W,
                     const Vector3& rotor_B)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.q_WB = numbers(q_WB);
  const Number q_length = length(state.q_WB);
  for (Number& component : state.q_WB) component /= q_length;
  state.start_L_W = {0, L_W.x(), L_W.y(), L_W.z()};
  const Numbers4 L_B = product(product(conjugate(state.q_WB), state.start_L_W), state.q_WB);
  for (int i = 0; i < 3; ++i) {
    state.inertia_B[i] = inertia_B[i];
    state.L_B[i] = L_B[i + 1];
    state.rotor_B[i] = rotor_B[i];
  }
  state.expand();
}

TaylorTop::~TaylorTop() = default;

void TaylorTop::advance(double t_s) {
  Number target = state_->since_expansion + t_s;
  while (target > state_->reach) {
    target -= state_->reach;
    state_->move_to(state_->reach);
    state_->expand();
  }
  state_->move_to(target);
}

Quaternion TaylorTop::q_WB() const {
  const Numbers4& q = state_->q_WB;
  return {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]),
          static_cast<double>(q[3])};
}

Vector3 TaylorTop::L_B() const {
  const Numbers3& L_B = state_->L_B;
  return {static_cast<double>(L_B[0]), static_cast<double>(L_B[1]), static_cast<double>(L_B[2])};
}

double TaylorTop::attitude_error(const Quaternion& q_WB) const {
  const Numbers4 difference = product(conjugate(state_->q_WB), numbers(q_WB));
  const Number sine = length(Numbers3{difference[1], difference[2], difference[3]});
  return 2.0 * std::atan2(static_cast<double>(sine), std::abs(static_cast<double>(difference[0])));
}

double TaylorTop::drift() const {
  Numbers4 change = state_->L_W();
  for (int i = 0; i < 4; ++i) change[i] -= state_->start_L_W[i];
  const Number L_length = length(state_->start_L_W);
  const Number of_L = L_length == 0 ? length(change) : Number(length(change) / L_length);
  return static_cast<double>(std::max(of_L, Number(abs(length(state_->q_WB) - 1))));
}

}  // namespace polhode::oracle
