// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/wall_gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr std::array kOff_m = {0.4, 0.7, 1.0};  // where the floor on a side is measured
constexpr double kWallStep_m = 0.05;
constexpr double kGapBand_m = 0.05;        // off the line, obstacles are on it
constexpr double kSmallest_m = 0.1;        // breaks in a wall that are no gaps
constexpr double kFlankOff_m = 0.25;       // a flank begins this near the gap
constexpr double kSolidShare = 0.85;       // of a long flank
constexpr double kFreeShare = 0.6;         // of a gap
constexpr double kStubEnd_m = 0.25;        // from a stub's end to the wall that it stands at
constexpr double kGapCrossingSine = 0.95;  // of walls that cross

/// What stands on a line, step by step.
struct LineScan {
  double from_m = 0.0;
  std::vector<bool> is_wall;
  [[nodiscard]] double at_m(std::size_t step) const {
    return from_m + static_cast<double>(step) * kWallStep_m;
  }
};

LineScan scan(const WallFace& face, const Interval& reach, const CellMask& near_obstacle,
              const CellFrame& frame) {
  LineScan line{reach.low_m, {}};
  for (double along_m = reach.low_m; along_m <= reach.high_m; along_m += kWallStep_m) {
    bool is_wall = false;
    for (const double off_m : {-kGapBand_m, 0.0, kGapBand_m}) {
      is_wall =
          is_wall || near_obstacle.at(frame.cell_of(face.at(along_m) + off_m * face.normal()));
    }
    line.is_wall.push_back(is_wall);
  }
  return line;
}

/// How far pieces of one wall reach along a face's line.
Interval reach_of(const WallFace& face, const std::vector<Interval>& line, double gap_m) {
  Interval reach{face.low_m(), face.high_m()};
  bool grows = true;
  while (grows) {
    grows = false;
    for (const Interval& one : line) {
      const bool is_near = one.low_m < reach.high_m + gap_m && one.high_m > reach.low_m - gap_m;
      const bool is_beyond = one.low_m < reach.low_m - 1e-9 || one.high_m > reach.high_m + 1e-9;
      if (!is_near || !is_beyond) continue;
      reach = {std::min(reach.low_m, one.low_m), std::max(reach.high_m, one.high_m)};
      grows = true;
    }
  }
  return reach;
}

double solid_share(const LineScan& line, std::size_t from, std::size_t to) {
  const auto begin = line.is_wall.begin();
  const auto solid = std::count(begin + static_cast<std::ptrdiff_t>(from),
                                begin + static_cast<std::ptrdiff_t>(to), true);
  return static_cast<double>(solid) / static_cast<double>(std::max<std::size_t>(1, to - from));
}

class GapFinder {
 public:
  GapFinder(const Walls& walls, const Occupancy& occupancy, const WallGapOptions& options)
      : walls_(walls),
        occupancy_(occupancy),
        options_(options),
        near_obstacle_(dilated(occupancy.obstacle, 1)) {}

  void add_gaps_of(const WallFace& face, std::vector<Segment2>& gaps) const {
    const std::vector<Interval> on_it = on_line(face, walls_.faces, 0.0);
    const double support_m = line_support_m(face, walls_.faces);
    if (support_m < options_.min_stub_line_m) return;
    const bool is_stubs = support_m < options_.min_line_m;
    const bool is_buildings = face.prominence_m >= options_.building_line_m;
    const Interval reach =
        reach_of(face, on_it, is_buildings ? options_.building_reach_m : options_.reach_m);
    const LineScan line = scan(face, reach, near_obstacle_, occupancy_.frame);
    std::size_t last = 0;  // step with wall
    bool any = false;
    for (std::size_t step = 0; step < line.is_wall.size(); ++step) {
      if (!line.is_wall[step]) continue;
      if (any && step > last + 1 && is_gap(line, last, step, on_it) &&
          (!is_stubs || is_between_stubs(face, line.at_m(last), line.at_m(step), on_it))) {
        const Segment2 gap{face.at(line.at_m(last)), face.at(line.at_m(step))};
        if (is_free(gap) && is_narrower_than_floor(gap)) gaps.push_back(gap);
      }
      last = step;
      any = true;
    }
  }

 private:
  /// Whether a prominent wall crosses a face's line near a place on it.
  [[nodiscard]] bool is_at_wall(const WallFace& face, double along_m) const {
    return std::any_of(walls_.faces.begin(), walls_.faces.end(), [&](const WallFace& wall) {
      if (wall.prominence_m < options_.prominent_m) return false;
      if (std::abs(face.along().dot(wall.normal())) < kGapCrossingSine) return false;
      const Point2 at = face.at(along_m);
      const double on_wall_m = at.dot(wall.along());
      return std::abs(at.dot(wall.normal()) - wall.offset_m) < kStubEnd_m &&
             on_wall_m > wall.low_m() - kStubEnd_m && on_wall_m < wall.high_m() + kStubEnd_m;
    });
  }

  /// Whether what stands on both sides of a gap runs from it to a prominent wall.
  [[nodiscard]] bool is_between_stubs(const WallFace& face, double low_m, double high_m,
                                      const std::vector<Interval>& on_it) const {
    bool low = false;
    bool high = false;
    for (const Interval& one : on_it) {
      low = low || (std::abs(one.high_m - low_m) < kFlankOff_m && is_at_wall(face, one.low_m));
      high = high || (std::abs(one.low_m - high_m) < kFlankOff_m && is_at_wall(face, one.high_m));
    }
    return low && high && high_m - low_m <= options_.free_m;
  }

  [[nodiscard]] bool is_gap(const LineScan& line, std::size_t low, std::size_t high,
                            const std::vector<Interval>& on_it) const {
    const double width_m = line.at_m(high) - line.at_m(low);
    if (width_m <= std::max(kSmallest_m, options_.narrowest_m)) return false;
    int flanks = 0;
    for (const bool is_low : {true, false}) {
      flanks += std::any_of(on_it.begin(), on_it.end(), [&](const Interval& one) {
        if (one.length_m() < options_.flank_m) return false;
        return is_low ? std::abs(one.high_m - line.at_m(low)) < kFlankOff_m
                      : std::abs(one.low_m - line.at_m(high)) < kFlankOff_m;
      });
    }
    if (width_m > options_.door_m) {
      const auto flank = static_cast<std::size_t>(options_.long_flank_m / kWallStep_m);
      return width_m <= options_.widest_m && flanks == 2 && low >= flank &&
             high + flank < line.is_wall.size() &&
             solid_share(line, low - flank, low + 1) >= kSolidShare &&
             solid_share(line, high, high + flank + 1) >= kSolidShare;
    }
    return width_m <= options_.free_m || flanks >= 1;
  }

  [[nodiscard]] bool is_free(const Segment2& gap) const {
    int free = 0;
    int all = 0;
    for (double share = 0.1; share <= 0.9; share += 0.05) {
      ++all;
      if (occupancy_.free.at(occupancy_.frame.cell_of(gap.a + share * (gap.b - gap.a)))) ++free;
    }
    return free >= kFreeShare * all;
  }

  [[nodiscard]] bool is_narrower_than_floor(const Segment2& gap) const {
    const Point2 way = gap.b - gap.a;
    if (way.norm() < options_.narrow_m) return true;
    const Point2 across = Point2(-way.y(), way.x()).normalized();
    return widens(occupancy_.free, occupancy_.frame, gap, across, options_.widening_m) &&
           widens(occupancy_.free, occupancy_.frame, gap, -across, options_.widening_m);
  }

  const Walls& walls_;
  const Occupancy& occupancy_;
  const WallGapOptions& options_;
  CellMask near_obstacle_;
};

/// How far the floor reaches from a point, up to `most_m`.
double reach_m(const CellMask& free, const CellFrame& frame, const Point2& from,
               const Point2& along, double most_m) {
  double off_m = 0.0;
  while (off_m < most_m && free.at(frame.cell_of(from + off_m * along))) off_m += kWallStep_m;
  return off_m;
}

}  // namespace

bool widens(const CellMask& free, const CellFrame& frame, const Segment2& line,
            const Point2& across, double by_m) {
  const Point2 middle = (line.a + line.b) / 2.0;
  const double width_m = (line.b - line.a).norm();
  const Point2 along = (line.b - line.a) / width_m;
  const double most_m = width_m / 2.0 + by_m + kWallStep_m;
  return std::all_of(kOff_m.begin(), kOff_m.end(), [&](double off_m) {
    const Point2 at = middle + off_m * across;
    return reach_m(free, frame, at, along, most_m) + reach_m(free, frame, at, -along, most_m) >=
           width_m + by_m;
  });
}

std::vector<Segment2> find_wall_gaps(const Walls& walls, const Occupancy& occupancy,
                                     const WallGapOptions& options) {
  const GapFinder finder(walls, occupancy, options);
  std::vector<Segment2> gaps;
  for (const WallFace& face : walls.faces) {
    if (face.is_regular && !face.is_furniture) finder.add_gaps_of(face, gaps);
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Segment2& a, const Segment2& b) {
    return (a.b - a.a).norm() < (b.b - b.a).norm();
  });
  return gaps;
}

}  // namespace roomatlas
