#pragma once

#include <optional>
#include <vector>

#include "record/drawn_body.h"
#include "viewer/graphics/renderer.h"
#include "viewer/model/arrows.h"
#include "viewer/model/poinsot.h"
#include "viewer/model/simulation.h"

namespace polhode::demos {

/// Draws a simulation.
class Scene {
 public:
  explicit Scene(const Simulation& simulation);

  /// Draws one contender at the step shown.
  void draw(Renderer& renderer, const Simulation& simulation, std::size_t index, bool is_teaching) const;
  /// Returns the arrows drawn with it.
  std::vector<Arrow> arrows(const Simulation& simulation, std::size_t index, bool is_teaching) const;

  /// Returns a ball that initially encloses all moving bodies.
  const Vector3& centre_W() const { return centre_W_; }
  double radius() const { return radius_; }

 private:
  void draw_ground(Renderer& renderer, const Ground& ground) const;
  void draw_pivot(Renderer& renderer, const Snapshot& snapshot) const;
  void draw_poinsot(Renderer& renderer, const Simulation& simulation, std::size_t index) const;
  std::optional<Poinsot> poinsot(const ContenderRun& run) const;

  std::vector<DrawnBody> drawn_;  ///< the recorded body, then the others
  std::optional<PointToPoint> constraint_;
  Vector3 centre_W_;
  double radius_;
  double reach_;  ///< of the recorded body
};

}  // namespace polhode::demos
