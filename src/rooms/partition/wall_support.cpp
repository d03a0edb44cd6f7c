// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_support.hpp"

#include <cmath>

namespace roomatlas {
namespace {

constexpr double kSupportStepM = 0.05;
constexpr int kNearSteps = 10;    // 0.5 m
constexpr int kMiddleSteps = 30;  // 1.5 m
constexpr int kFarSteps = 50;     // 2.5 m
constexpr int kBandSteps = 2;     // an obstacle this far off the line is on it
constexpr int kFloorSteps = 8;    // a wall has floor on a side this near

}  // namespace

WallSupport wall_support(const OpenFloor& floor, const Point2& jamb, const Point2& along) {
  const Point2 side(-along.y(), along.x());
  const auto looks_like_wall = [&](const Point2& at) {
    bool obstacle = false;
    bool open = false;
    for (int k = -kFloorSteps; k <= kFloorSteps; ++k) {
      const Point2 beside = at + k * kSupportStepM * side;
      open = open || floor.is_open(beside);
      obstacle = obstacle || (std::abs(k) <= kBandSteps && floor.is_wall(beside));
    }
    return obstacle && open;
  };
  WallSupport support;
  for (int k = 1; k <= kFarSteps; ++k) {
    if (!looks_like_wall(jamb + k * kSupportStepM * along)) continue;
    if (k <= kNearSteps) support.near += 1.0 / kNearSteps;
    if (k <= kMiddleSteps) support.middle += 1.0 / kMiddleSteps;
    support.far += 1.0 / kFarSteps;
  }
  return support;
}

}  // namespace roomatlas
