// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "roomatlas/grid/cells.hpp"

namespace roomatlas {

/// A grid of cells without bounds that keeps only the tiles of 16 x 16 cells that were written:
/// corridors are long and mostly empty. Cells that were never written read as `CellValue{}`.
template <typename CellValue>
class TileGrid {
 public:
  [[nodiscard]] CellValue at(const Cell& cell) const {
    const Tile* tile = tile_of(cell);
    return tile == nullptr ? CellValue{} : (*tile)[inside(cell)];
  }

  /// The cell for writing. The reference holds until the next call.
  [[nodiscard]] CellValue& edit(const Cell& cell) {
    const Cell tile = {cell.x >> kShift, cell.y >> kShift};
    if (tiles_.empty() || tile != edited_) edit_tile(tile);
    return tiles_[edited_index_][inside(cell)];
  }

  static constexpr int kTileCells = 16;  ///< side of a tile

  /// Visits every written tile, row by row: `visit(tile)`, which has the cells [16 x, 16 x + 16)
  /// and [16 y, 16 y + 16).
  template <typename Visit>
  void for_each_tile(Visit visit) const {
    for_each_cell(box_, [&](const Cell& tile) {
      if (table_[box_.index_of(tile)] >= 0) visit(tile);
    });
  }

  /// Visits every cell of every written tile, tiles and cells row by row.
  template <typename Visit>
  void for_each(Visit visit) const {
    for_each_cell(box_, [&](const Cell& tile) {
      const std::int32_t index = table_[box_.index_of(tile)];
      if (index < 0) return;
      const Cell first{tile.x << kShift, tile.y << kShift};
      for_each_cell({first, {first.x + kSide, first.y + kSide}}, [&](const Cell& cell) {
        visit(cell, tiles_[static_cast<std::size_t>(index)][inside(cell)]);
      });
    });
  }

  /// Visits the values of all cells of a box that lie in written tiles, tile by tile.
  template <typename Visit>
  void for_each_in(const CellBox& box, Visit visit) const {
    const Cell last{box.max.x - 1, box.max.y - 1};
    for (int ty = box.min.y >> kShift; ty <= last.y >> kShift; ++ty) {
      for (int tx = box.min.x >> kShift; tx <= last.x >> kShift; ++tx) {
        const Cell first{tx << kShift, ty << kShift};
        const Tile* tile = tile_of(first);
        if (tile == nullptr) continue;
        const int from_x = std::max(box.min.x, first.x);
        const int to_x = std::min(box.max.x, first.x + kSide);
        const int to_y = std::min(box.max.y, first.y + kSide);
        for (int y = std::max(box.min.y, first.y); y < to_y; ++y) {
          const CellValue* row = tile->data() + inside({first.x, y});
          for (int x = from_x; x < to_x; ++x) visit(row[x - first.x]);
        }
      }
    }
  }

  /// The smallest box of whole tiles around everything written.
  [[nodiscard]] CellBox box() const {
    CellBox used{box_.max, box_.min};
    for_each_cell(box_, [&](const Cell& tile) {
      if (table_[box_.index_of(tile)] < 0) return;
      used.min = {std::min(used.min.x, tile.x), std::min(used.min.y, tile.y)};
      used.max = {std::max(used.max.x, tile.x + 1), std::max(used.max.y, tile.y + 1)};
    });
    if (used.width() <= 0) return {};
    return {{used.min.x << kShift, used.min.y << kShift},
            {used.max.x << kShift, used.max.y << kShift}};
  }

 private:
  static constexpr int kShift = 4;           ///< of 16 cells: larger tiles hold more unused cells
  static constexpr int kSide = 1 << kShift;  ///< cells
  using Tile = std::array<CellValue, std::size_t{kSide} * kSide>;

  static std::size_t inside(const Cell& cell) {
    return static_cast<std::size_t>(((cell.y & (kSide - 1)) << kShift) | (cell.x & (kSide - 1)));
  }
  [[nodiscard]] const Tile* tile_of(const Cell& cell) const {
    const Cell tile{cell.x >> kShift, cell.y >> kShift};
    if (!box_.contains(tile)) return nullptr;
    const std::int32_t index = table_[box_.index_of(tile)];
    return index < 0 ? nullptr : &tiles_[static_cast<std::size_t>(index)];
  }

  /// Makes a tile the one that is edited. Rays go through many cells of one: apart, so that
  /// `edit` stays small.
  [[gnu::noinline]] void edit_tile(const Cell& tile) {
    cover(tile);
    std::int32_t& index = table_[box_.index_of(tile)];
    if (index < 0) {
      index = static_cast<std::int32_t>(tiles_.size());
      tiles_.emplace_back();
    }
    edited_ = tile;
    edited_index_ = static_cast<std::size_t>(index);
  }

  /// Grows the table of tiles, by some tiles more than needed so that it grows rarely.
  void cover(const Cell& tile) {
    constexpr int kMargin = 8;  // tiles: more wastes table, fewer copies it more often
    if (box_.contains(tile)) return;
    CellBox grown = box_.count() == 0 ? CellBox{tile, tile} : box_;
    if (tile.x < grown.min.x || box_.count() == 0) grown.min.x = tile.x - kMargin;
    if (tile.y < grown.min.y || box_.count() == 0) grown.min.y = tile.y - kMargin;
    if (tile.x >= grown.max.x) grown.max.x = tile.x + kMargin;
    if (tile.y >= grown.max.y) grown.max.y = tile.y + kMargin;
    std::vector<std::int32_t> table(grown.count(), -1);
    for_each_cell(box_,
                  [&](const Cell& at) { table[grown.index_of(at)] = table_[box_.index_of(at)]; });
    table_ = std::move(table);
    box_ = grown;
  }

  CellBox box_;  ///< in tiles
  std::vector<std::int32_t> table_;
  std::vector<Tile> tiles_;
  Cell edited_;  ///< the tile edited last, where there are any
  std::size_t edited_index_ = 0;
};

}  // namespace roomatlas
