// The geometry of the picture: camera, grid, arrows, curves, Poinsot's ellipsoid.
#include <gtest/gtest.h>

#include <cmath>

#include "demos/viewer/resolved_scenario.h"
#include "viewer/model/arrows.h"
#include "viewer/model/camera.h"
#include "viewer/model/plot_data.h"
#include "viewer/model/poinsot.h"
#include "viewer/model/view_grid.h"

namespace polhode::demos {
namespace {

Simulation tumbling(int steps) {
  Simulation simulation(resolved_scenario("tumble"), find_contenders({"exact", "matrix"}));
  for (int step = 0; step < steps; ++step) simulation.step();
  return simulation;
}

Eigen::Vector2f pixel_of(const OrbitCamera& camera, const Vector3& point_W) {
  Eigen::Vector2f pixel;
  EXPECT_TRUE(project(camera.projection(2.0) * camera.view(), point_W, {200.0f, 100.0f}, pixel));
  return pixel;
}

TEST(OrbitCamera, HasItsTargetInTheMiddleAndUpUpwards) {
  OrbitCamera camera;
  camera.look_at({1, 2, 3}, 2.0);
  const Eigen::Vector2f middle = pixel_of(camera, {1, 2, 3});
  EXPECT_NEAR(middle.x(), 100.0f, 1e-3);
  EXPECT_NEAR(middle.y(), 50.0f, 1e-3);
  EXPECT_LT(pixel_of(camera, {1, 2, 3.5}).y(), 40.0f);
}

TEST(OrbitCamera, KeepsItsDistanceAndStaysShortOfThePoles) {
  OrbitCamera camera;
  camera.look_at(Vector3::Zero(), 1.0);
  const double distance = camera.distance();
  camera.orbit(7.0, 100.0);
  EXPECT_NEAR(camera.position_W().norm(), distance, 1e-12);
  EXPECT_GT(std::hypot(camera.position_W().x(), camera.position_W().y()), 0.01 * distance);
  EXPECT_TRUE(camera.view().allFinite());
  camera.zoom(0.5);
  EXPECT_NEAR(camera.distance(), 0.5 * distance, 1e-12);
  camera.zoom(1e-30);
  EXPECT_GT(camera.distance(), 0.0);
}

TEST(OrbitCamera, ShowsABallWhole) {
  OrbitCamera camera;
  camera.look_at(Vector3::Zero(), 1.0);
  for (const Vector3& point_W : {Vector3(0, 0, 0.99), Vector3(0, 0, -0.99)}) {
    const Eigen::Vector2f pixel = pixel_of(camera, point_W);
    EXPECT_GT(pixel.y(), 0.0f);
    EXPECT_LT(pixel.y(), 100.0f);
  }
  Eigen::Vector2f pixel;
  const Vector3 behind_W = 2.0 * camera.position_W();
  EXPECT_FALSE(project(camera.projection(1.0) * camera.view(), behind_W, {100.0f, 100.0f}, pixel));
}

TEST(ViewGrid, TilesTheArea) {
  const Rectangle area{10, 20, 1290, 636};
  for (std::size_t count = 1; count <= 16; ++count) {
    for (std::size_t index = 0; index < count; ++index) {
      const Rectangle cell = grid_cell(area, index, count);
      EXPECT_TRUE(area.contains(cell.left, cell.top));
      EXPECT_LE(cell.left + cell.width, area.left + area.width + 0.01f);
      EXPECT_LE(cell.top + cell.height, area.top + area.height + 0.01f);
    }
  }
  EXPECT_EQ(grid_cell(area, 8, 9).left, 10 + 860);  // three by three
}

TEST(Arrows, AreTheAxesOmegaAndMomentum) {
  const Simulation simulation = tumbling(10);
  const Sample& sample = simulation.shown(0).sample;
  const std::vector<Arrow> arrows = arrows_of(sample, simulation.run(0).start(), 0.5);
  ASSERT_EQ(arrows.size(), 5u);
  EXPECT_LT(arrows[0].along_W.cross(sample.state.R_WB.col(0)).norm(), 1e-15);
  EXPECT_LT(arrows[3].along_W.normalized().cross(sample.state.omega_W.normalized()).norm(), 1e-15);
  EXPECT_NEAR(arrows[4].along_W.norm(), 1.3 * 0.5, 1e-12);  // |L| is unchanged
}

TEST(Arrows, ShowTheMomentumOfRotorsToo) {
  for (const char* name : {"exact", "bullet:implicit_body"}) {
    Simulation simulation(resolved_scenario("wheel_stops_the_flip"), find_contenders({name}));
    simulation.step();
    const Sample& sample = simulation.shown(0).sample;
    const std::vector<Arrow> arrows = arrows_of(sample, simulation.run(0).start(), 0.5);
    ASSERT_EQ(arrows.size(), 6u) << name;
    EXPECT_STREQ(arrows[5].name, "h");
    EXPECT_LT((arrows[5].along_W.normalized() - sample.state.R_WB.col(0)).norm(), 1e-12) << name;
    const double part = sample.state.rotor_momentum_B.norm() / simulation.run(0).start().state.L_W.norm();
    EXPECT_NEAR(arrows[5].along_W.norm(), part * 1.3 * 0.5, 1e-12) << "on the scale of L";
  }
}

TEST(Plots, HoldEveryQuantityUpToTheShownStep) {
  const Simulation simulation = tumbling(1000);
  std::vector<std::string> titles;
  for (const PlotSubject& subject : plot_subjects()) {
    titles.push_back(subject.title());
    const std::vector<Curve> curves = curves_of(simulation, subject, 100);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_GE(curves[0].size(), 50u);
    EXPECT_LE(curves[0].size(), 102u);
    EXPECT_EQ(curves[0].front().t_s, 0.0);
    EXPECT_EQ(curves[0].back().t_s, simulation.shown_t_s());
  }
  EXPECT_EQ(titles, (std::vector<std::string>{"energy error, no unit", "|L| error, no unit", "turn of L, rad",
                                              "attitude error, rad", "energy, J",
                                              "energy about body axis x, J", "energy about body axis y, J",
                                              "energy about body axis z, J", "det R, no unit"}));
}

TEST(Plots, SplitTheRotationalEnergyAmongTheAxes) {
  const auto sum_J = [](const Simulation& simulation) {
    double sum = 0.0;
    for (const PlotSubject& subject : plot_subjects()) {
      if (subject.quantity->components != 3) continue;
      sum += *subject.quantity->value(simulation.run(0).instant(simulation.shown_step()), subject.component);
    }
    return sum;
  };
  const Simulation tumbling_body = tumbling(50);
  EXPECT_NEAR(sum_J(tumbling_body), tumbling_body.shown(0).sample.state.energy(), 1e-13);
  const Simulation with_rotor(resolved_scenario("wheel_stops_the_flip"), find_contenders({"exact"}));
  EXPECT_NEAR(sum_J(with_rotor), with_rotor.shown(0).sample.state.energy(), 1e-13);
}

TEST(Plots, LetFewOutliersLeaveTheScale) {
  std::vector<Curve> curves;
  for (int i = 0; i < 9; ++i) curves.push_back({{0, 10}, {1, 10 + 0.5 * i}});
  curves.push_back({{0, 10}, {1, 1e11}});
  const Range range = value_range(curves);
  EXPECT_LT(range.highest, 30.0);
  EXPECT_TRUE(leaves(curves.back(), range));
  EXPECT_FALSE(leaves(curves.front(), range));
  EXPECT_TRUE(value_range({}).highest > value_range({}).lowest);
}

TEST(Plots, HaveRoundTicks) {
  EXPECT_EQ(ticks({0.0, 1.0}).size(), 6u);
  for (const Range& range : {Range{0, 3}, Range{-17, 0.5}, Range{1420, 1425}, Range{1 - 1e-9, 1 + 1e-9}}) {
    EXPECT_GE(ticks(range).size(), 2u);
    EXPECT_LE(ticks(range).size(), 7u);
    for (const double tick : ticks(range)) EXPECT_TRUE(range.contains(tick));
  }
}

TEST(Poinsot, EllipsoidTouchesThePlaneWhereOmegaIs) {
  const Simulation simulation = tumbling(200);
  const ContenderRun& exact = simulation.run(0);
  const Poinsot poinsot = poinsot_of(exact.start(), exact.inertia_B(), 1.0).value();
  EXPECT_NEAR(poinsot.half_axes_B.maxCoeff(), 1.0, 1e-15);
  for (const Eigen::Vector3f& point_W : herpolhode_path(exact.history(), poinsot, 200, 1000)) {
    EXPECT_NEAR(point_W.cast<double>().dot(poinsot.normal_W), poinsot.distance, 1e-6);  // in float
  }
  const Quaternion q_WB = simulation.shown(0).sample.state.q_WB;
  const std::vector<Eigen::Vector3f> polhode = polhode_path(exact.history(), poinsot, 200, 50);
  EXPECT_EQ(polhode.size(), 50u);
  for (const Eigen::Vector3f& point_W : polhode) {
    const Vector3 point_B = q_WB.conjugate() * point_W.cast<double>();
    EXPECT_NEAR(point_B.cwiseQuotient(poinsot.half_axes_B).norm(), 1.0, 1e-6);  // in float
  }
}

}  // namespace
}  // namespace polhode::demos
