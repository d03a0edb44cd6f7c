// SPDX-License-Identifier: GPL-3.0-or-later
#include "altered_cells.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/grid/raster.hpp"

namespace roomatlas::changes {
namespace {

int cells_in(double length_m, double cell_m) {
  return static_cast<int>(std::lround(length_m / cell_m));
}

/// The robot was there: whatever beams say, nothing stands under its middle.
void clear_path(const BuildingEvidence& evidence, const VisitTimes* times, SeenCells& cells) {
  for (std::size_t i = 0; i < evidence.building_from_robot.size(); ++i) {
    const Cell at = evidence.counts.frame().cell_of(evidence.building_from_robot[i].position());
    for_each_cell({{at.x - 1, at.y - 1}, {at.x + 2, at.y + 2}}, [&](const Cell& cell) {
      if (times != nullptr && !times->holds(evidence.asr_of_pose[i], cell)) return;
      cells.seen.set(cell, true);
      cells.clear.set(cell, true);
      cells.standing.set(cell, false);
      cells.touched.set(cell, false);
    });
  }
}

}  // namespace

SeenCells seen_cells(const BuildingEvidence& evidence, const VisitTimes* times, const CellBox& box,
                     const ChangeOptions& options) {
  SeenCells cells{CellMask(box), CellMask(box), CellMask(box), CellMask(box)};
  for_each_cell(box, [&](const Cell& cell) {
    const CellCounts counts = evidence.counts.at(cell);
    if (!counts.is_seen()) return;
    const double share = counts.reflected_share();
    const bool is_clear = share <= options.clear_share;
    cells.seen.set(cell, true);
    cells.standing.set(cell, counts.hits >= options.min_hits && share >= options.standing_share);
    cells.clear.set(cell, counts.passes >= options.min_passes && is_clear);
    cells.touched.set(cell, counts.hits > 0 && !is_clear);
  });
  clear_path(evidence, times, cells);
  return cells;
}

CellMask only_in(const SeenCells& one, const SeenCells& other, double cell_m,
                 const ChangeOptions& options) {
  const CellMask near = dilated(other.touched, cells_in(options.apart_m, cell_m));
  CellMask alone = both(one.standing, other.clear);
  for (std::size_t i = 0; i < alone.bits.size(); ++i) {
    if (near.bits[i] != 0) alone.bits[i] = 0;
  }
  return alone;
}

std::vector<CellGroup> groups_of(const CellMask& mask, double cell_m,
                                 const ChangeOptions& options) {
  const CellMask joined = dilated(mask, cells_in(options.join_m, cell_m));
  CellMask visited(mask.domain);
  std::vector<CellGroup> groups;
  for_each_cell(mask.domain, [&](const Cell& start) {
    if (!joined.at(start) || visited.at(start)) return;
    std::vector<Cell> reached{start};
    visited.set(start, true);
    CellGroup group;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Cell at = reached[i];
      if (mask.at(at)) group.push_back(at);
      for_each_cell({{at.x - 1, at.y - 1}, {at.x + 2, at.y + 2}}, [&](const Cell& next) {
        if (!joined.at(next) || visited.at(next)) return;
        visited.set(next, true);
        reached.push_back(next);
      });
    }
    if (static_cast<int>(group.size()) >= options.min_cells) groups.push_back(std::move(group));
  });
  return groups;
}

}  // namespace roomatlas::changes
