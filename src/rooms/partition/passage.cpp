// SPDX-License-Identifier: GPL-3.0-or-later
#include "passage.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kFromM = 0.5;          // nearer lies the wall itself
constexpr double kToM = 2.5;            // farther lies what is behind the next room
constexpr double kBetweenM = 0.1;       // lines along which the width is measured
constexpr double kCorridorShare = 0.1;  // more on both sides: a corridor goes on
constexpr double kRiseM = 3.0;          // a hall shows within
constexpr double kMostRise = 1.2;
constexpr double kStepM = 0.05;    // along such a line
constexpr double kInLineM = 0.12;  // a wall this far off a jamb's line goes on from it

/// How far the floor reaches from a point, up to `most_m`.
double reach_m(const OpenFloor& floor, const Point2& from, const Point2& along, double most_m) {
  double off_m = kStepM;
  while (off_m < most_m && floor.is_open(from + off_m * along)) off_m += kStepM;
  return off_m - kStepM / 2.0;
}

double passage_on(const OpenFloor& floor, const Segment2& jambs, const Point2& across) {
  const Point2 middle = (jambs.a + jambs.b) / 2.0;
  const double half_m = (jambs.b - jambs.a).norm() / 2.0;
  const Point2 along = (jambs.b - jambs.a).normalized();
  double in_line_a = 0.0;
  double in_line_b = 0.0;
  double lines = 0.0;
  for (double off_m = kBetweenM; off_m < kToM; off_m += kBetweenM) {
    const Point2 at = middle + off_m * across;
    if (!floor.is_open(at)) break;
    if (off_m < kFromM - kBetweenM / 2.0) continue;
    const double in_line_m = kInLineM + floor.wall_noise_m;
    const double most_m = half_m + in_line_m + 2.0 * kStepM;
    ++lines;
    if (std::abs(reach_m(floor, at, -along, most_m) - half_m) < in_line_m) ++in_line_a;
    if (std::abs(reach_m(floor, at, along, most_m) - half_m) < in_line_m) ++in_line_b;
  }
  return lines > 0.0 ? std::min(in_line_a, in_line_b) / lines : 0.0;
}

double rise_on(const OpenFloor& floor, const Segment2& jambs, const Point2& across) {
  const Point2 middle = (jambs.a + jambs.b) / 2.0;
  const double half_m = (jambs.b - jambs.a).norm() / 2.0;
  double most_m = half_m;
  for (double off_m = kBetweenM; off_m < kRiseM; off_m += kBetweenM) {
    const Cell cell = floor.frame.cell_of(middle + off_m * across);
    if (!floor.open.at(cell)) break;
    most_m = std::max(most_m, double{floor.clearance_m[cell]});
  }
  return std::min(std::log(most_m / half_m), kMostRise);
}

}  // namespace

bool is_across_corridor(const Passage& passage) { return passage.less >= kCorridorShare; }

Passage passage_at(const OpenFloor& floor, const Segment2& jambs) {
  const Point2 way = jambs.b - jambs.a;
  if (way.norm() < floor.frame.cell_m) return {};
  const Point2 across = Point2(-way.y(), way.x()).normalized();
  const double left = passage_on(floor, jambs, across);
  const double right = passage_on(floor, jambs, -across);
  return {std::min(left, right), std::max(left, right),
          rise_on(floor, jambs, left < right ? across : Point2(-across))};
}

}  // namespace roomatlas
