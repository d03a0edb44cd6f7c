// SPDX-License-Identifier: GPL-3.0-or-later
#include "driven_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kNarrowest_m = 0.4;  // of a door as it is heard
constexpr double kWidest_m = 1.6;
constexpr double kSame_m = 0.3;      // gaps whose middles are nearer are one
constexpr double kSwing_m = 1.15;    // from a jamb: a leaf, and how much later a jamb is heard
constexpr double kLeafEnd_m = 1.45;  // the same of a leaf's end, which is heard too long
constexpr double kShortestLeaf_m = 0.6;
constexpr double kLeafCosine = 0.5;  // a leaf that is shut stands in the wall's line
constexpr double kWallsOwn_m = 0.1;  // off the face of a wall
constexpr double kGapStep_m = 0.02;  // between places on a face that are asked

Point2 middle_of(const Segment2& line) { return (line.a + line.b) / 2.0; }

/// The gap of a face's line in which a place is.
std::optional<Segment2> gap_at(const WallFace& face, const std::vector<Interval>& seen,
                               double along_m) {
  double low_m = -std::numeric_limits<double>::infinity();
  double high_m = std::numeric_limits<double>::infinity();
  for (const Interval& one : seen) {
    if (one.low_m < along_m && one.high_m > along_m) return std::nullopt;
    if (one.high_m <= along_m) low_m = std::max(low_m, one.high_m);
    if (one.low_m >= along_m) high_m = std::min(high_m, one.low_m);
  }
  if (!(high_m - low_m >= kNarrowest_m && high_m - low_m <= kWidest_m)) return std::nullopt;
  return Segment2{face.at(low_m), face.at(high_m)};
}

/// Whether the leaf of one of the doors may stand at a place.
bool is_swept(const Point2& at, const std::vector<Segment2>& gaps) {
  return std::any_of(gaps.begin(), gaps.end(), [&](const Segment2& gap) {
    return std::min((at - gap.a).norm(), (at - gap.b).norm()) < kSwing_m;
  });
}

/// Whether a stretch of a wall's line is a leaf that happens to stand on it.
bool is_leaf(const WallFace& face, const Interval& stretch, const std::vector<Segment2>& gaps) {
  if (stretch.length_m() < kShortestLeaf_m) return false;
  return std::any_of(gaps.begin(), gaps.end(), [&](const Segment2& gap) {
    if (std::abs((gap.b - gap.a).normalized().dot(face.along())) > kLeafCosine) return false;
    const auto reaches = [&](const Point2& jamb) {
      return (face.at(stretch.low_m) - jamb).norm() < kLeafEnd_m &&
             (face.at(stretch.high_m) - jamb).norm() < kLeafEnd_m;
    };
    return reaches(gap.a) || reaches(gap.b);
  });
}

}  // namespace

std::vector<Segment2> driven_gaps(const Walls& walls, const std::vector<bool>& is_wall,
                                  const std::vector<Pose2>& path) {
  std::vector<Segment2> gaps;
  for (std::size_t i = 0; i < walls.faces.size(); ++i) {
    const WallFace& face = walls.faces[i];
    if (!is_wall[i]) continue;
    const std::vector<Interval> seen = on_line(face, walls.faces, 0.0);
    const Segment2 line{face.at(face.cover.front().low_m), face.at(face.cover.back().high_m)};
    for (std::size_t k = 1; k < path.size(); ++k) {
      const Segment2 step{path[k - 1].position(), path[k].position()};
      const auto share = crossing_fraction(step, line);
      if (!share) continue;
      const Point2 at = step.a + *share * (step.b - step.a);
      const auto gap = gap_at(face, seen, at.dot(face.along()));
      if (!gap) continue;
      const bool is_known = std::any_of(gaps.begin(), gaps.end(), [&](const Segment2& one) {
        return (middle_of(one) - middle_of(*gap)).norm() < kSame_m;
      });
      if (!is_known) gaps.push_back(*gap);
    }
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Segment2& a, const Segment2& b) {
    return (a.b - a.a).norm() < (b.b - b.a).norm();
  });
  return gaps;
}

std::vector<WallFace> without_swings(const Walls& walls, const std::vector<bool>& is_wall,
                                     const std::vector<Segment2>& gaps) {
  std::vector<WallFace> faces = walls.faces;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::vector<Interval> kept;
    for (const Interval& stretch : faces[i].seen) {
      if (!is_wall[i]) {
        const std::vector<Interval> parts =
            kept_parts(stretch, kGapStep_m, 2.0 * kGapStep_m,
                       [&](double along_m) { return !is_swept(faces[i].at(along_m), gaps); });
        kept.insert(kept.end(), parts.begin(), parts.end());
      } else if (!is_leaf(faces[i], stretch, gaps)) {
        kept.push_back(stretch);
      }
    }
    faces[i].seen = std::move(kept);
  }
  std::erase_if(faces, [](const WallFace& face) { return face.seen.empty(); });
  return faces;
}

void clear_swings(const Walls& walls, const std::vector<bool>& is_wall,
                  const std::vector<Segment2>& gaps, Occupancy& occupancy) {
  const CellFrame& frame = occupancy.frame;
  CellMask own(occupancy.free.domain);
  for (std::size_t i = 0; i < walls.faces.size(); ++i) {
    const WallFace& face = walls.faces[i];
    if (!is_wall[i]) continue;
    for (const Interval& stretch : face.seen) {
      if (!is_leaf(face, stretch, gaps)) mark(face, stretch, frame, own);
    }
  }
  own = dilated(own, static_cast<int>(std::lround(kWallsOwn_m / frame.cell_m)));
  for_each_cell(occupancy.free.domain, [&](const Cell& cell) {
    if (!occupancy.obstacle.at(cell) || own.at(cell)) return;
    if (!is_swept(frame.center_of(cell), gaps)) return;
    occupancy.obstacle.set(cell, false);
    occupancy.free.set(cell, true);
  });
}

}  // namespace roomatlas
