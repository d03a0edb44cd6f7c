// SPDX-License-Identifier: GPL-3.0-or-later
#include "sliding_doors.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas {
namespace {

constexpr double kSpeedM_per_s = 1.0;
constexpr double kRobotNearM = 2.5;  // from the door's middle: time to open before it is there
constexpr double kShutShare = 0.5;   // of the times that a leaf moves, it shuts wholly
constexpr double kOpenShare = 0.3;   // ... opens wholly; else it stops somewhere

}  // namespace

SlidingDoors::SlidingDoors(const FloorPlan& world, const SimulationOptions& options)
    : period_s_(1.0 / options.rate_hz), random_(options.seed, "sliding doors") {
  if (options.moving_doors_share <= 0.0) return;
  for (const PlanDoor& door : world.doors) {
    const bool slides = random_.uniform() < options.moving_doors_share;
    const bool from_b = random_.uniform() < 0.5;
    if (!slides || door.leaf) continue;
    Leaf leaf{door.jambs, 0.0, 0.0, 0.0};
    if (from_b) std::swap(leaf.line.a, leaf.line.b);
    leaves_.push_back(leaf);
  }
}

double SlidingDoors::between(double low, double high) {
  return low + (high - low) * random_.uniform();
}

void SlidingDoors::step(const Point2& robot) {
  for (Leaf& leaf : leaves_) {
    const double width_m = (leaf.line.b - leaf.line.a).norm();
    leaf.pause_s -= period_s_;
    if (leaf.pause_s <= 0.0) {
      const double draw = random_.uniform();
      const double somewhere_m = width_m * random_.uniform();
      leaf.pause_s = between(10.0, 90.0);
      leaf.wanted_m = draw < kShutShare                ? width_m
                      : draw < kShutShare + kOpenShare ? 0.0
                                                       : somewhere_m;
    }
    const Point2 middle = (leaf.line.a + leaf.line.b) / 2.0;
    const bool makes_way = (robot - middle).norm() < kRobotNearM;
    const double wanted_m = makes_way ? 0.0 : leaf.wanted_m;
    const double most_m = kSpeedM_per_s * period_s_;
    leaf.shut_m += std::clamp(wanted_m - leaf.shut_m, -most_m, most_m);
  }
}

std::vector<Segment2> SlidingDoors::edges() const {
  std::vector<Segment2> edges;
  for (const Leaf& leaf : leaves_) {
    if (leaf.shut_m <= 0.0) continue;
    const Point2 along = (leaf.line.b - leaf.line.a).normalized();
    edges.push_back({leaf.line.a, leaf.line.a + leaf.shut_m * along});
  }
  return edges;
}

}  // namespace roomatlas
