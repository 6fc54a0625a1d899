#pragma once

#include <Eigen/Core>
#include <vector>

#include "viewer/model/contender_run.h"

/// Poinsot's picture of free motion: the inertia ellipsoid, fixed in the body, rolls on a plane that is fixed
/// in the world; omega is where they touch. The touching point draws the polhode on the ellipsoid and the
/// herpolhode on the plane. Of a contender that keeps neither energy nor L they part, which shows.
namespace polhode::demos {

struct Poinsot {
  /// The half axes of omega_B . I_B omega_B = 2 E at the start, m as drawn.
  Vector3 half_axes_B;
  /// Metres as drawn per rad/s.
  double scale;
  /// The invariable plane's normal, along L at the start, and its distance from the centre of mass, m.
  Vector3 normal_W;
  double distance;
};

/// Returns the construction scaled to that size as drawn, m; nothing if the body does not turn at the start.
std::optional<Poinsot> poinsot_of(const Sample& start, const Vector3& inertia_B, double size);

/// The path of omega up to that step: in the body's axes (as they are turned then), or in the world's, as
/// offsets from the centre of mass. Not more than the last `most` steps.
std::vector<Eigen::Vector3f> polhode_path(const History& history, const Poinsot& poinsot, std::int64_t step,
                                          std::int64_t most);
std::vector<Eigen::Vector3f> herpolhode_path(const History& history, const Poinsot& poinsot,
                                             std::int64_t step, std::int64_t most);

}  // namespace polhode::demos
