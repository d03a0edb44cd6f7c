// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/reflection_map.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace roomatlas {
namespace {

constexpr std::uint16_t kMost = std::numeric_limits<std::uint16_t>::max();  // a count holds no more

/// One more; a full cell is halved, which keeps its share.
void count(CellCounts& counts, std::uint16_t CellCounts::*which) {
  if (counts.*which == kMost) {
    counts.hits /= 2;
    counts.passes /= 2;
  }
  ++(counts.*which);
}

constexpr int kAroundTiles = 2;  // of what was seen that belong to the domain ...
constexpr int kGapTiles = 4;     // ... and in gaps no wider than twice so many: 6 m at 5 cm a cell
constexpr double kSparse = 0.2;  // of its box; a building that fills more has all of it

/// Tiles, one byte each.
struct TileSet {
  CellBox box;
  std::vector<std::uint8_t> bits;
};

/// Tiles of which one within `radius` (a square) is in the set, or, of `value` 0, is not.
TileSet spread(const TileSet& from, int radius, std::uint8_t value) {
  TileSet to{from.box, std::vector<std::uint8_t>(from.bits.size(), 1 - value)};
  TileSet along = to;
  const auto pass = [&](const TileSet& in, TileSet& out, const Cell& step) {
    for_each_cell(in.box, [&](const Cell& tile) {
      if (in.bits[in.box.index_of(tile)] != value) return;
      for (int k = -radius; k <= radius; ++k) {
        const Cell near{tile.x + k * step.x, tile.y + k * step.y};
        if (out.box.contains(near)) out.bits[out.box.index_of(near)] = value;
      }
    });
  };
  pass(from, along, {1, 0});
  pass(along, to, {0, 1});
  return to;
}

/// The cells of a row of tiles.
std::vector<CellDomain::Span> spans_of(const TileSet& tiles, int tile_y, int side) {
  std::vector<CellDomain::Span> spans;
  for (int x = tiles.box.min.x; x < tiles.box.max.x; ++x) {
    if (tiles.bits[tiles.box.index_of({x, tile_y})] == 0) continue;
    if (!spans.empty() && spans.back().to == x * side) {
      spans.back().to += side;
    } else {
      spans.push_back({x * side, (x + 1) * side, 0});
    }
  }
  return spans;
}

}  // namespace

void ReflectionMap::add_sweep(const std::vector<Ray>& rays) {
  for (const Ray& ray : rays) {
    const Cell end = frame_.cell_of(ray.segment.b);
    const auto pass = [&](const Cell& cell) {
      count(counts_.edit(cell), &CellCounts::passes);
      return true;
    };
    for_each_cell_on_line(frame_.cell_of(ray.segment.a), end, pass, ray.ends_at_obstacle ? 2 : 0);
    if (ray.ends_at_obstacle) count(counts_.edit(end), &CellCounts::hits);
  }
}

void ReflectionMap::add(const ReflectionMap& other) {
  other.counts_.for_each([&](const Cell& cell, const CellCounts& more) {
    if (!more.is_seen()) return;
    CellCounts& counts = counts_.edit(cell);
    int hits = counts.hits + more.hits;
    int passes = counts.passes + more.passes;
    while (std::max(hits, passes) > kMost) {
      hits /= 2;
      passes /= 2;
    }
    counts = {static_cast<std::uint16_t>(hits), static_cast<std::uint16_t>(passes)};
  });
}

CellDomain ReflectionMap::domain(int border_cells) const {
  constexpr int kSide = TileGrid<CellCounts>::kTileCells;
  const CellBox seen = box();
  const CellBox all{{seen.min.x - border_cells, seen.min.y - border_cells},
                    {seen.max.x + border_cells, seen.max.y + border_cells}};
  if (seen.count() == 0) return all;
  constexpr int kRim = kAroundTiles + kGapTiles;
  TileSet tiles{{{seen.min.x / kSide - kRim, seen.min.y / kSide - kRim},
                 {seen.max.x / kSide + kRim, seen.max.y / kSide + kRim}},
                {}};
  tiles.bits.assign(tiles.box.count(), 0);
  std::size_t written = 0;
  counts_.for_each_tile([&](const Cell& tile) {
    tiles.bits[tiles.box.index_of(tile)] = 1;
    ++written;
  });
  if (static_cast<double>(written * kSide * kSide) > kSparse * static_cast<double>(all.count())) {
    return all;
  }
  tiles = spread(spread(tiles, kRim, 1), kGapTiles, 0);
  std::vector<std::vector<CellDomain::Span>> rows;
  for (int y = tiles.box.min.y; y < tiles.box.max.y; ++y) {
    rows.insert(rows.end(), kSide, spans_of(tiles, y, kSide));
  }
  return CellDomain::from_rows(tiles.box.min.y * kSide, std::move(rows)).within(all);
}

Point2 ReflectionMap::mean_hit(const Cell& cell) const {
  Point2 sum = Point2::Zero();
  double hits = 0.0;
  for_each_cell({{cell.x - 1, cell.y - 1}, {cell.x + 2, cell.y + 2}}, [&](const Cell& near) {
    const double weight = at(near).hits;
    sum += weight * frame_.center_of(near);
    hits += weight;
  });
  return hits > 0.0 ? Point2(sum / hits) : frame_.center_of(cell);
}

}  // namespace roomatlas
