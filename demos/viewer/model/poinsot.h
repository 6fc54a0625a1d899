#pragma once

#include <Eigen/Core>
#include <vector>

#include "viewer/model/contender_run.h"

/// Poinsot's construction of free motion: the inertia ellipsoid, fixed in the body, rolls on a plane fixed in
/// the world; omega ends at the point of contact, which draws the polhode on the ellipsoid and the herpolhode
/// on the plane. If a contender conserves neither energy nor L, they visibly separate.
namespace polhode::demos {

struct Poinsot {
  /// The half axes of omega_B . I_B omega_B = 2 E at the start, in metres of the drawing.
  Vector3 half_axes_B;
  /// Metres of the drawing per rad/s.
  double scale;
  /// The invariable plane's normal, along the initial L, and its distance from the centre of mass, m.
  Vector3 normal_W;
  double distance;
};

/// Returns the construction scaled to this size in the drawing, m; nothing if the body does not turn at the
/// start.
std::optional<Poinsot> poinsot_of(const Sample& start, const Vector3& inertia_B, double size);

/// Returns the path of omega up to this step, in the body's present axes or in the world's, as offsets from
/// the centre of mass. Covers at most the last `most` steps.
std::vector<Eigen::Vector3f> polhode_path(const History& history, const Poinsot& poinsot, std::int64_t step,
                                          std::int64_t most);
std::vector<Eigen::Vector3f> herpolhode_path(const History& history, const Poinsot& poinsot,
                                             std::int64_t step, std::int64_t most);

}  // namespace polhode::demos
