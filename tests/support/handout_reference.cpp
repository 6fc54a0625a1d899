#include "support/handout_reference.h"

#include <cmath>

namespace polhode::testing::handout {

namespace {

Vector operator*(const Matrix& m, const Vector& v) {
  Vector result{};
  for (int i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return result;
}

Matrix transposed(const Matrix& m) {
  Matrix result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result[i][j] = m[j][i];
  return result;
}

Matrix diagonal(const Vector& v) {
  return {{{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}}};
}

Vector inverse(const Vector& v) {
  return {1 / v[0], 1 / v[1], 1 / v[2]};
}

Matrix skew(const Vector& v) {
  return {{{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}}};
}

Vector cross(const Vector& a, const Vector& b) {
  return skew(a) * b;
}

// Cramer's rule.
Vector solve(const Matrix& m, const Vector& right) {
  Vector result{};
  for (int column = 0; column < 3; ++column) {
    Matrix replaced = m;
    for (int row = 0; row < 3; ++row) replaced[row][column] = right[row];
    result[column] = determinant(replaced) / determinant(m);
  }
  return result;
}

// Returns q + dt/2 [0, omega] q, normalised.
Quaternion turned(const Quaternion& q, const Vector& w, double dt) {
  const Quaternion rate = {-w[0] * q[1] - w[1] * q[2] - w[2] * q[3], w[0] * q[0] + w[1] * q[3] - w[2] * q[2],
                           w[1] * q[0] + w[2] * q[1] - w[0] * q[3], w[2] * q[0] + w[0] * q[2] - w[1] * q[1]};
  Quaternion result{};
  double length2 = 0;
  for (int i = 0; i < 4; ++i) {
    result[i] = q[i] + 0.5 * dt * rate[i];
    length2 += result[i] * result[i];
  }
  for (double& component : result) component /= std::sqrt(length2);
  return result;
}

}  // namespace

double determinant(const Matrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Matrix matrix_of(const Quaternion& q) {
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

void advance_matrix(Body& body, double dt) {
  const Matrix inverse_inertia_W = body.R_WB * diagonal(inverse(body.inertia_B)) * transposed(body.R_WB);
  const Matrix change = skew(inverse_inertia_W * body.L_W) * body.R_WB;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) body.R_WB[i][j] += dt * change[i][j];
}

void advance_quaternion(Body& body, double dt) {
  const Matrix R_WB = matrix_of(body.q_WB);
  const Matrix inverse_inertia_W = R_WB * diagonal(inverse(body.inertia_B)) * transposed(R_WB);
  body.q_WB = turned(body.q_WB, inverse_inertia_W * body.L_W, dt);
}

void advance_semi_implicit_gyroscopic(Body& body, double dt) {
  const Matrix R_WB = matrix_of(body.q_WB);
  const Matrix inertia_W = R_WB * diagonal(body.inertia_B) * transposed(R_WB);
  const Matrix inverse_inertia_W = R_WB * diagonal(inverse(body.inertia_B)) * transposed(R_WB);
  const Vector change = inverse_inertia_W * cross(body.omega_W, inertia_W * body.omega_W);
  for (int i = 0; i < 3; ++i) body.omega_W[i] -= dt * change[i];
  body.q_WB = turned(body.q_WB, body.omega_W, dt);
}

void advance_implicit_gyroscopic(Body& body, double dt) {
  const Matrix R_WB = matrix_of(body.q_WB);
  Vector omega_B = transposed(R_WB) * body.omega_W;
  const Matrix inertia = diagonal(body.inertia_B);
  const Vector L_B = inertia * omega_B;
  const Matrix omega_cross_inertia = skew(omega_B) * inertia;
  const Matrix L_cross = skew(L_B);
  Matrix jacobian = inertia;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) jacobian[i][j] += dt * (omega_cross_inertia[i][j] - L_cross[i][j]);
  Vector residual = cross(omega_B, L_B);
  for (double& component : residual) component *= dt;
  const Vector change_B = solve(jacobian, residual);
  for (int i = 0; i < 3; ++i) omega_B[i] -= change_B[i];
  body.omega_W = R_WB * omega_B;
  body.q_WB = turned(body.q_WB, body.omega_W, dt);
}

double energy(const Body& body) {
  const Vector omega_B = transposed(matrix_of(body.q_WB)) * body.omega_W;
  double twice = 0;
  for (int i = 0; i < 3; ++i) twice += body.inertia_B[i] * omega_B[i] * omega_B[i];
  return 0.5 * twice;
}

}  // namespace polhode::testing::handout
