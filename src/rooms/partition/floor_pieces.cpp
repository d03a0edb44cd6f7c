// SPDX-License-Identifier: GPL-3.0-or-later
#include "floor_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace roomatlas {
namespace {

constexpr double kSaddleShare = 0.9;  // larger cuts at every bulge of a wall
constexpr double kLevelM = 0.002;     // clearances that differ by less are one

// Over edges alone: neither thin walls nor chords let through at corners.
constexpr std::array<Cell, 4> kSides = {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}};

/// The numbers of a field's cells from the highest down, row by row within a level.
std::vector<std::uint32_t> by_height(const Raster<float>& field) {
  const float highest =
      field.values.empty() ? 0.0F : *std::max_element(field.values.begin(), field.values.end());
  const auto level_of = [&](float value) {
    return static_cast<std::size_t>((highest - value) / static_cast<float>(kLevelM));
  };
  std::vector<std::size_t> begin(level_of(0.0F) + 2, 0);
  for (const float value : field.values) {
    if (value > 0.0F) ++begin[level_of(value) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> cells(begin.back());
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    const float value = field.values[i];
    if (value > 0.0F) cells[begin[level_of(value)]++] = static_cast<std::uint32_t>(i);
  }
  return cells;
}

/// From the number of a domain's cell back to the cell: an order of all cells takes a word for
/// each.
class NumberedCells {
 public:
  explicit NumberedCells(const CellDomain& domain) {
    for (int y = domain.bounds().min.y; y < domain.bounds().max.y; ++y) {
      domain.for_each_span(y, [&](const CellDomain::Span& span) {
        first_.push_back(span.first);
        cell_.push_back({span.from, y});
      });
    }
  }
  [[nodiscard]] Cell at(std::size_t number) const {
    const auto span = static_cast<std::size_t>(
        std::upper_bound(first_.begin(), first_.end(), number) - first_.begin() - 1);
    return {cell_[span].x + static_cast<int>(number - first_[span]), cell_[span].y};
  }

 private:
  std::vector<std::size_t> first_;  ///< number of each span's first cell
  std::vector<Cell> cell_;          ///< each span's first cell
};

/// Basins that grow together.
class Basins {
 public:
  explicit Basins(double saddle_share) : saddle_share_(saddle_share) {}

  std::int32_t add(float peak) {
    into_.push_back(static_cast<std::int32_t>(into_.size()));
    peak_.push_back(peak);
    return into_.back();
  }
  std::int32_t root(std::int32_t basin) {
    while (into_[at(basin)] != basin) {
      into_[at(basin)] = into_[at(into_[at(basin)])];
      basin = into_[at(basin)];
    }
    return basin;
  }
  /// Two basins meet at a saddle.
  void meet(std::int32_t one, std::int32_t other, float saddle) {
    one = root(one);
    other = root(other);
    if (one == other) return;
    if (peak_[at(one)] < peak_[at(other)]) std::swap(one, other);
    if (saddle >= saddle_share_ * peak_[at(other)]) into_[at(other)] = one;
  }
  [[nodiscard]] std::size_t size() const { return into_.size(); }

 private:
  static std::size_t at(std::int32_t basin) { return static_cast<std::size_t>(basin); }

  double saddle_share_;
  std::vector<std::int32_t> into_{0};
  std::vector<float> peak_{0.0F};
};

/// Cells under a chord go to the neighbour with most clearance.
void give_cut_cells_away(const OpenFloor& floor, Raster<std::int32_t>& piece_of_cell) {
  std::vector<Cell> left;
  for_each_cell(floor.open.domain, [&](const Cell& cell) {
    if (floor.open.at(cell) && piece_of_cell[cell] == 0) left.push_back(cell);
  });
  while (!left.empty()) {
    std::vector<std::pair<Cell, std::int32_t>> given;
    std::vector<Cell> still;
    for (const Cell& cell : left) {
      std::int32_t best = 0;
      float most = -1.0F;
      for (const Cell& step : kSides) {
        const Cell next{cell.x + step.x, cell.y + step.y};
        const std::int32_t piece = piece_of_cell.get(next);
        if (piece == 0 || floor.clearance_m[next] <= most) continue;
        most = floor.clearance_m[next];
        best = piece;
      }
      if (best != 0) {
        given.emplace_back(cell, best);
      } else {
        still.push_back(cell);
      }
    }
    if (given.empty()) return;  // cut off on all sides
    for (const auto& [cell, piece] : given) piece_of_cell[cell] = piece;
    left.swap(still);
  }
}

}  // namespace

Raster<std::int32_t> flooded(const Raster<float>& field, double saddle_share) {
  Raster<std::int32_t> basin_of(field.domain, 0);
  Basins basins(saddle_share);
  const NumberedCells cells(field.domain);
  for (const std::uint32_t number : by_height(field)) {
    const Cell cell = cells.at(number);
    const float height = field.values[number];
    std::array<std::int32_t, 4> met{};
    std::size_t meeting = 0;
    std::int32_t highest = 0;
    float most = -1.0F;
    for (const Cell& step : kSides) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      std::int32_t basin = basin_of.get(next);
      if (basin == 0) continue;
      basin = basins.root(basin);
      if (field[next] > most) {
        most = field[next];
        highest = basin;
      }
      const auto end = met.begin() + meeting;
      if (std::find(met.begin(), end, basin) == end) met[meeting++] = basin;
    }
    basin_of.values[number] = meeting == 0 ? basins.add(height) : highest;
    for (std::size_t i = 0; i < meeting; ++i) basins.meet(met[i], highest, height);
  }
  std::vector<std::int32_t> number(basins.size(), 0);
  std::int32_t count = 0;
  for (std::int32_t& basin : basin_of.values) {
    if (basin == 0) continue;
    std::int32_t& to = number[static_cast<std::size_t>(basins.root(basin))];
    if (to == 0) to = ++count;
    basin = to;
  }
  return basin_of;
}

FloorPieces cut_floor(const OpenFloor& floor, const ChordCells& chords) {
  const Raster<float> field = clearance_m(chords.cut_out_of(floor.open), floor.frame);
  FloorPieces pieces;
  pieces.piece_of_cell = flooded(field, kSaddleShare);
  for (const std::int32_t piece : pieces.piece_of_cell.values) {
    pieces.count = std::max(pieces.count, piece);
  }
  pieces.radius_m.assign(static_cast<std::size_t>(pieces.count) + 1, 0.0);
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    const auto piece = static_cast<std::size_t>(pieces.piece_of_cell.values[i]);
    if (piece == 0) continue;
    pieces.radius_m[piece] = std::max(pieces.radius_m[piece], double{field.values[i]});
  }
  give_cut_cells_away(floor, pieces.piece_of_cell);
  return pieces;
}

}  // namespace roomatlas
