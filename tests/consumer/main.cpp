// SPDX-License-Identifier: GPL-3.0-or-later
// Draws one room, and finds where the robot is in it by two measurements with Ceres.
#include <iostream>
#include <roomatlas/roomatlas.hpp>

int main() {
  using namespace roomatlas;
  FloorPlan plan;
  plan.title = "consumer";
  const Ring square{{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
  plan.rooms.push_back({1, "1", RoomKind::room, {{square, {}}}, signed_area(square), {2.0, 1.5}});
  write_png("plan.png", draw_plan(plan, {}, {}), 96.0);
  write_file("plan.geojson", to_geojson(plan));
  const double area_m2 = read_plan("plan.geojson").rooms.at(0).area_m2;

  PoseGraph graph;
  graph.ids = {1, 2};
  graph.edges = {{0, 1, EdgeKind::odometry, {1.0, 0.0, 0.0}}, {0, 1, EdgeKind::loop, {3.0, 0, 0}}};
  const OptimizeResult found = optimize(graph, {.solver = PoseGraphSolver::ceres});
  std::cout << area_m2 << " m2, " << found.poses.at(1).x_m << " m\n";
  return found.converged ? 0 : 1;
}
