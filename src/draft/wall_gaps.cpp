// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/wall_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kJoin_m = 0.1;       // stretches this near are one
constexpr double kFreeShare = 0.6;    // of a gap

/// Stretches of wall on a line without overlaps.
std::vector<Stretch> joined(const std::vector<Stretch>& stretches) {
  std::vector<Stretch> all;
  for (const Stretch& one : stretches) {
    if (!all.empty() && one.low_m <= all.back().high_m + kJoin_m) {
      all.back().high_m = std::max(all.back().high_m, one.high_m);
    } else {
      all.push_back(one);
    }
  }
  return all;
}

bool is_free(const Segment2& gap, const Occupancy& occupancy) {
  int free = 0;
  int all = 0;
  for (double share = 0.1; share <= 0.9; share += 0.05) {
    ++all;
    if (occupancy.free.at(occupancy.frame.cell_of(gap.a + share * (gap.b - gap.a)))) ++free;
  }
  return free >= kFreeShare * all;
}

}  // namespace

std::vector<Segment2> find_wall_gaps(const Walls& walls, const Occupancy& occupancy,
                                     const WallGapOptions& options) {
  std::vector<Segment2> gaps;
  for (const WallFace& face : walls.faces) {
    if (!face.is_regular || line_support_m(face, walls.faces) < options.min_line_m) continue;
    const std::vector<Stretch> line = joined(on_line(face, walls.faces, 0.0));
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Stretch gap{line[i].high_m, line[i + 1].low_m};
      if (gap.low_m > face.high_m() + kJoin_m || gap.high_m < face.low_m() - kJoin_m) continue;
      if (gap.length_m() < options.narrowest_m || gap.length_m() > options.widest_m) continue;
      const double flank_m = std::min(line[i].length_m(), line[i + 1].length_m());
      const bool is_short = gap.length_m() <= options.short_m;
      if (flank_m < (is_short ? options.short_flank_m : options.long_flank_m)) continue;
      const Segment2 segment{face.at(gap.low_m), face.at(gap.high_m)};
      if (is_free(segment, occupancy)) gaps.push_back(segment);
    }
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Segment2& a, const Segment2& b) {
    return (a.b - a.a).norm() < (b.b - b.a).norm();
  });
  return gaps;
}

}  // namespace roomatlas
