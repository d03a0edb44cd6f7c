// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/extract_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roomatlas/polyline/region.hpp"

namespace roomatlas {
namespace {

/// The steps of at most `radius` cells, nearest first; ties in a fixed order.
std::vector<Cell> steps_within(double radius) {
  std::vector<Cell> steps;
  const auto reach = static_cast<int>(std::floor(radius));
  for_each_cell({{-reach, -reach}, {reach + 1, reach + 1}}, [&](const Cell& step) {
    const double length = std::hypot(step.x, step.y);
    if (length > 0.0 && length <= radius) steps.push_back(step);
  });
  std::stable_sort(steps.begin(), steps.end(), [](const Cell& a, const Cell& b) {
    return a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y;
  });
  return steps;
}

/// Follows the left-over cells from `start`, removing each; `start` itself is not in the result.
CellChain follow(CellMask& left, const Cell& start, const std::vector<Cell>& steps) {
  CellChain chain;
  Cell at = start;
  while (true) {
    const auto next = std::find_if(steps.begin(), steps.end(), [&](const Cell& step) {
      return left.at({at.x + step.x, at.y + step.y});
    });
    if (next == steps.end()) return chain;
    at = {at.x + next->x, at.y + next->y};
    left.set(at, false);
    chain.push_back(at);
  }
}

}  // namespace

std::vector<CellChain> extract_points(const CellMap& map, double gamma_cells) {
  CellMask left(map.box);
  for_each_cell(map.box,
                [&](const Cell& cell) { left.set(cell, map.at(cell) == CellState::occupied); });
  const std::vector<Cell> steps = steps_within(gamma_cells);
  std::vector<CellChain> chains;
  for_each_cell(map.box, [&](const Cell& start) {
    if (!left.at(start)) return;
    left.set(start, false);
    CellChain onward = follow(left, start, steps);
    CellChain chain = follow(left, start, steps);
    std::reverse(chain.begin(), chain.end());
    chain.push_back(start);
    chain.insert(chain.end(), onward.begin(), onward.end());
    chains.push_back(std::move(chain));
  });
  return chains;
}

Point2 refined_point(const Cell& cell, const HimmGrid& grid, double epsilon) {
  constexpr int kReach = 2;  // the band of a wall is three cells wide, the front layer its first
  Point2 sum = Point2::Zero();
  double weight = 0.0;
  for_each_cell({{cell.x - kReach, cell.y - kReach}, {cell.x + kReach + 1, cell.y + kReach + 1}},
                [&](const Cell& near) {
                  const double certainty = grid.value(near);
                  if (certainty <= epsilon) return;
                  sum += certainty * grid.frame().center_of(near);
                  weight += certainty;
                });
  return weight > 0.0 ? Point2(sum / weight) : grid.frame().center_of(cell);
}

std::vector<Polyline> chain_points(const std::vector<CellChain>& chains, const HimmGrid& grid,
                                   double epsilon, bool refine) {
  std::vector<Polyline> lines;
  lines.reserve(chains.size());
  for (const CellChain& chain : chains) {
    Polyline& line = lines.emplace_back();
    for (const Cell& cell : chain) {
      line.push_back(refine ? refined_point(cell, grid, epsilon) : grid.frame().center_of(cell));
    }
  }
  return lines;
}

}  // namespace roomatlas
