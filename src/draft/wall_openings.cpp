// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_openings.hpp"

#include <algorithm>
#include <cmath>

#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kLineStep_m = 0.05;
constexpr double kStandingBand_m = 0.15;              // off a line, what stands is on it
const double kLeastCosine = std::cos(radians(20.0));  // of an opening and its wall
constexpr double kOffFace_m = 0.3;                    // of an opening from the face of its wall
constexpr double kWallNear_m = 0.8;                   // beyond a jamb the wall is heard ...
constexpr double kWallPiece_m = 0.3;                  // ... for so long
constexpr double kFar_m = 2.0;                        // beyond a jamb it is asked about ...
constexpr double kStandingShare = 0.75;               // ... and so much of it stands
constexpr double kAtWall_m = 0.15;      // nearer to a wall that crosses there is no stub
constexpr double kPastEnd_m = 0.15;     // a wall's end
constexpr double kHeardEarly_m = 0.05;  // a jamb, by the width of the cone
const double kAcrossCosine = std::cos(radians(40.0));  // of an opening and a corridor's width
constexpr double kObstacles_m = 1.3;      // a wall of obstacles alone, on each side ...
constexpr double kBothObstacles_m = 3.5;  // ... and on both
constexpr double kFarObstacles_m = 4.0;
constexpr double kObstacleGap_m = 0.25;
constexpr double kFit_m = 1.2;      // of them on each side give the line ...
constexpr double kFitBand_m = 0.3;  // ... where they are so near to it
constexpr double kJamb_m = 0.1;     // an opening's end counts
constexpr double kFewestSeen = 4.0;

/// Whether a jamb may end a stub that stands on a wall.
bool may_end_stub(const WallFace& wall, const Point2& jamb) {
  const double off_m = jamb.dot(wall.normal()) - wall.offset_m;
  return off_m >= kAtWall_m && off_m <= kLongestStub_m + kHeardEarly_m &&
         goes_on_at(wall, jamb, kPastEnd_m);
}

}  // namespace

WallOpenings::WallOpenings(const Walls& walls, const std::vector<bool>& is_wall,
                           const Occupancy& bare, const BuildingGrid& heard)
    : walls_(walls), is_wall_(is_wall), bare_(bare), heard_(heard) {}

bool WallOpenings::is_in_wall(const Segment2& jambs) const {
  for (std::size_t i = 0; i < walls_.faces.size(); ++i) {
    if (is_wall_[i] && is_on_line_of(walls_.faces[i], jambs)) return true;
  }
  return is_across_corridor(jambs) || is_among_obstacles(jambs);
}

bool WallOpenings::is_on_line_of(const WallFace& face, const Segment2& jambs) const {
  const Point2 middle = (jambs.a + jambs.b) / 2.0;
  const Point2 way = (jambs.b - jambs.a).normalized();
  if (std::abs(face.along().dot(way)) < kLeastCosine) return false;
  if (std::abs(middle.dot(face.normal()) - face.offset_m) > kOffFace_m) return false;
  const double middle_m = middle.dot(face.along());
  const double near_m = (jambs.b - jambs.a).norm() / 2.0 + kWallNear_m;
  if (std::none_of(face.seen.begin(), face.seen.end(), [&](const Interval& one) {
        return one.length_m() > kWallPiece_m && one.high_m > middle_m - near_m &&
               one.low_m < middle_m + near_m;
      })) {
    return false;
  }
  const double a_m = jambs.a.dot(face.along());
  const double b_m = jambs.b.dot(face.along());
  const Beside high = beside(face, std::max(a_m, b_m), 1.0);
  const Beside low = beside(face, std::min(a_m, b_m), -1.0);
  if (high == Beside::floor || low == Beside::floor) return false;
  // A box beside a wall leaves a gap too: one stub and the wall itself are no door.
  return high == Beside::wall || low == Beside::wall ||
         (high == Beside::stub && low == Beside::stub);
}

/// What is beyond a jamb, up to a wall that crosses there.
WallOpenings::Beside WallOpenings::beside(const WallFace& face, double jamb_m, double sign) const {
  const double end_m = to_crossing_m(face, jamb_m, sign);
  if (end_m <= kAtWall_m) return Beside::crossing;
  if (end_m <= kLongestStub_m) return Beside::stub;
  int solid = 0;
  int all = 0;
  for (double on_m = kLineStep_m; on_m < end_m; on_m += kLineStep_m) {
    ++all;
    if (is_solid(face, jamb_m + sign * on_m)) ++solid;
  }
  return solid >= kStandingShare * all ? Beside::wall : Beside::floor;
}

double WallOpenings::to_crossing_m(const WallFace& face, double jamb_m, double sign) const {
  double next_m = kFar_m;
  for (std::size_t i = 0; i < walls_.faces.size(); ++i) {
    if (!is_wall_[i]) continue;
    const WallFace& wall = walls_.faces[i];
    const auto beyond_m = crossing_m(face, jamb_m, sign, wall, kLeastCosine);
    if (!beyond_m || *beyond_m < -kPastEnd_m || *beyond_m > next_m) continue;
    if (goes_on_at(wall, face.at(jamb_m + sign * *beyond_m), kPastEnd_m)) next_m = *beyond_m;
  }
  return next_m;
}

bool WallOpenings::is_solid(const WallFace& face, double along_m) const {
  for (double off_m = -kStandingBand_m; off_m <= kStandingBand_m; off_m += kLineStep_m) {
    const Point2 at = face.at(along_m) + off_m * face.normal();
    if (!bare_.free.at(bare_.frame.cell_of(at))) return true;
  }
  return false;
}

/// Whether stubs too short to be heard end at both jambs, on walls that look at each other.
bool WallOpenings::is_across_corridor(const Segment2& jambs) const {
  const Point2 way = (jambs.b - jambs.a).normalized();
  for (std::size_t i = 0; i < walls_.faces.size(); ++i) {
    const WallFace& one = walls_.faces[i];
    if (!is_wall_[i] || way.dot(one.normal()) <= kAcrossCosine) continue;
    if (!may_end_stub(one, jambs.a)) continue;
    for (std::size_t j = 0; j < walls_.faces.size(); ++j) {
      const WallFace& other = walls_.faces[j];
      if (!is_wall_[j] || one.normal().dot(other.normal()) > -kLeastCosine) continue;
      if (may_end_stub(other, jambs.b)) return true;
    }
  }
  return false;
}

bool WallOpenings::is_among_obstacles(const Segment2& jambs) const {
  const Segment2 line = on_line_of_obstacles(jambs);
  const Point2 way = (line.b - line.a).normalized();
  const double a_m = obstacles_m(line.a, -way);
  const double b_m = obstacles_m(line.b, way);
  return std::min(a_m, b_m) >= kObstacles_m && a_m + b_m >= kBothObstacles_m;
}

Segment2 WallOpenings::on_line_of_obstacles(const Segment2& jambs) const {
  const Point2 way = (jambs.b - jambs.a).normalized();
  const Point2 across(-way.y(), way.x());
  const Point2 middle = (jambs.a + jambs.b) / 2.0;
  const double half_m = (jambs.b - jambs.a).norm() / 2.0;
  const double reach_m = half_m + kFit_m;
  double sum = 0.0, u = 0.0, v = 0.0, uu = 0.0, uv = 0.0;
  const CellBox box{heard_.frame.cell_of(middle - Point2::Constant(reach_m)),
                    heard_.frame.cell_of(middle + Point2::Constant(reach_m))};
  for_each_cell(box, [&](const Cell& cell) {
    if (!heard_.obstacle.at(cell)) return;
    const Point2 off = heard_.frame.center_of(cell) - middle;
    const double on_m = off.dot(way);
    const double off_m = off.dot(across);
    if (std::abs(on_m) > reach_m || std::abs(on_m) < half_m - kJamb_m) return;
    if (std::abs(off_m) > kFitBand_m) return;
    sum += 1.0;
    u += on_m;
    v += off_m;
    uu += on_m * on_m;
    uv += on_m * off_m;
  });
  const double spread = sum * uu - u * u;
  if (sum < kFewestSeen || spread <= 0.0) return jambs;
  const double slope = (sum * uv - u * v) / spread;
  const double level_m = (v - slope * u) / sum;
  const auto on_line = [&](double on_m) -> Point2 {
    return middle + on_m * way + (level_m + slope * on_m) * across;
  };
  return {on_line(-half_m), on_line(half_m)};
}

/// How far obstacles go on from a jamb.
double WallOpenings::obstacles_m(const Point2& jamb, const Point2& along) const {
  const Point2 across(-along.y(), along.x());
  double last_m = 0.0;
  for (double on_m = kLineStep_m; on_m <= kFarObstacles_m && on_m - last_m <= kObstacleGap_m;
       on_m += kLineStep_m) {
    for (double off_m = -kStandingBand_m; off_m <= kStandingBand_m; off_m += kLineStep_m) {
      const Point2 at = jamb + on_m * along + off_m * across;
      if (heard_.obstacle.at(heard_.frame.cell_of(at))) last_m = on_m;
    }
  }
  return last_m;
}

}  // namespace roomatlas
