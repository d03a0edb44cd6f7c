// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/map_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace roomatlas {
namespace {

constexpr CellCounts kFree{0, 40};  // beams: enough for every threshold of drafting
constexpr CellCounts kOccupied{40, 0};
constexpr double kWall_m = 0.25;     // a strip of unknown cells between floor and obstacle that is
                                     // no wider is a wall: its face was drawn too faintly
constexpr double kEvenCells = 1e-6;  // 0.1 / 0.05 is two cells
constexpr std::array kSides = {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}};

/// One connected piece of floor and what is around it, in cells' edges.
struct Piece {
  std::vector<Cell> cells;
  std::int64_t on_obstacle = 0;
  std::int64_t on_rim = 0;
  std::int64_t edges = 0;

  [[nodiscard]] double share(std::int64_t of) const {
    return edges > 0 ? static_cast<double>(of) / static_cast<double>(edges) : 0.0;
  }
};

void count_edge(const MapCells& map, const Cell& beyond, Piece& piece) {
  ++piece.edges;
  if (!map.cells.domain.contains(beyond)) {
    ++piece.on_rim;
  } else if (map.cells[beyond] == MapCell::occupied) {
    ++piece.on_obstacle;
  }
}

std::vector<Piece> pieces_of(const MapCells& map) {
  std::vector<Piece> pieces;
  Raster<char> is_done(map.cells.domain, 0);
  for_each_cell(map.cells.domain, [&](const Cell& start) {
    if (is_done[start] != 0 || map.cells[start] != MapCell::free) return;
    Piece piece;
    piece.cells.push_back(start);
    is_done[start] = 1;
    for (std::size_t i = 0; i < piece.cells.size(); ++i) {
      const Cell at = piece.cells[i];
      for (const Cell& side : kSides) {
        const Cell next{at.x + side.x, at.y + side.y};
        if (map.cells.get(next) != MapCell::free) {
          count_edge(map, next, piece);
        } else if (is_done[next] == 0) {
          is_done[next] = 1;
          piece.cells.push_back(next);
        }
      }
    }
    pieces.push_back(std::move(piece));
  });
  return pieces;
}

/// The map without floor that is not the building's.
MapCells building_alone(const MapCells& map, const MapEvidenceOptions& options) {
  MapCells kept = map;
  std::vector<Piece> pieces = pieces_of(map);
  const auto drop = [&](const auto& is_dropped) {
    for (const Piece& piece : pieces) {
      if (!is_dropped(piece)) continue;
      for (const Cell& cell : piece.cells) kept.cells[cell] = MapCell::unknown;
    }
    std::erase_if(pieces, is_dropped);
  };
  const auto is_outside = [&](const Piece& piece) {
    return piece.share(piece.on_rim) > options.max_rim_share;
  };
  // A map that is nothing but floor up to its rim has no inside: it is taken as it is.
  if (!std::all_of(pieces.begin(), pieces.end(), is_outside)) drop(is_outside);
  std::size_t largest = 0;
  for (const Piece& piece : pieces) largest = std::max(largest, piece.cells.size());
  const double cell_m2 = map.frame.cell_m * map.frame.cell_m;
  drop([&](const Piece& piece) {
    return piece.cells.size() < largest &&
           (static_cast<double>(piece.cells.size()) * cell_m2 < options.min_floor_m2 ||
            piece.share(piece.on_obstacle) < options.min_obstacle_share);
  });
  return kept;
}

/// Whether beyond a cell that is not known an obstacle lies within a wall's thickness.
bool is_in_wall(const MapCells& map, Cell at, const Cell& way) {
  const int most = std::max(1, static_cast<int>(kWall_m / map.frame.cell_m));
  for (int i = 0; i <= most && map.cells.domain.contains(at); ++i) {
    if (map.cells[at] != MapCell::unknown) return map.cells[at] == MapCell::occupied;
    at = {at.x + way.x, at.y + way.y};
  }
  return false;
}

/// The map with faces of walls where floor goes over into a wall that is grey on this side.
MapCells with_faint_faces(const MapCells& map) {
  MapCells closed = map;
  for_each_cell(map.cells.domain, [&](const Cell& cell) {
    if (map.cells[cell] != MapCell::unknown) return;
    for (const Cell& side : kSides) {
      const Cell floor{cell.x - side.x, cell.y - side.y};
      if (map.cells.get(floor) != MapCell::free || !is_in_wall(map, cell, side)) continue;
      closed.cells[cell] = MapCell::occupied;
      return;
    }
  });
  return closed;
}

/// Counts in cells of so many of the map's cells to a side: occupied where any of these is, so that
/// thin walls stay whole; free where half of them are.
ReflectionMap counts_of(const MapCells& map, int side) {
  ReflectionMap counts(map.frame.cell_m * side);
  const CellBox& box = map.cells.domain.bounds();
  const auto coarse = [side](int value) {
    return static_cast<int>(std::floor(static_cast<double>(value) / side));
  };
  const CellBox large{{coarse(box.min.x), coarse(box.min.y)},
                      {coarse(box.max.x - 1) + 1, coarse(box.max.y - 1) + 1}};
  for_each_cell(large, [&](const Cell& cell) {
    int free = 0;
    int occupied = 0;
    const Cell low{cell.x * side, cell.y * side};
    for_each_cell({low, {low.x + side, low.y + side}}, [&](const Cell& fine) {
      const MapCell value = map.cells.get(fine);
      if (value == MapCell::free) ++free;
      if (value == MapCell::occupied) ++occupied;
    });
    if (occupied > 0) {
      counts.set(cell, kOccupied);
    } else if (2 * free >= side * side) {
      counts.set(cell, kFree);
    }
  });
  return counts;
}

}  // namespace

BuildingEvidence evidence_of_map(const MapCells& map, const MapEvidenceOptions& options) {
  if (!(map.frame.cell_m > 0.0) || !(options.cell_m > 0.0)) {
    throw std::invalid_argument("evidence_of_map: expected cells of a positive size");
  }
  const MapCells building = building_alone(with_faint_faces(map), options);
  const int side =
      std::max(1, static_cast<int>(std::floor(options.cell_m / map.frame.cell_m + kEvenCells)));
  BuildingEvidence evidence;
  evidence.kind = SensorKind::laser;
  const bool any = std::any_of(building.cells.values.begin(), building.cells.values.end(),
                               [](MapCell cell) { return cell == MapCell::free; });
  if (!any) return evidence;
  evidence.counts = counts_of(building, side);
  evidence.surfaces = thinned(surfaces_of(building));
  return evidence;
}

}  // namespace roomatlas
