#pragma once

#include <array>

/// The handout's equations, implemented from the text alone in plain arrays: an oracle that shares no code
/// with the library. Torque-free motion; row-major matrices; quaternions w, x, y, z.
namespace polhode::testing::handout {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;
using Quaternion = std::array<double, 4>;

struct Body {
  Vector inertia_B;
  Matrix R_WB = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Quaternion q_WB = {1, 0, 0, 0};
  Vector omega_W = {0, 0, 0};  // problems 3, 4
  Vector L_W = {0, 0, 0};      // problems 1, 2
};

void advance_matrix(Body& body, double dt);                    // eq. 1-2
void advance_quaternion(Body& body, double dt);                // eq. 3
void advance_semi_implicit_gyroscopic(Body& body, double dt);  // eq. 4-5
void advance_implicit_gyroscopic(Body& body, double dt);       // eq. 6-10

double determinant(const Matrix& matrix);
Matrix matrix_of(const Quaternion& q);
/// Returns the rotational energy of problems 3 and 4, (1/2) omega . I_W omega.
double energy(const Body& body);

}  // namespace polhode::testing::handout
