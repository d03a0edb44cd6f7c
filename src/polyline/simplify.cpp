// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/simplify.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas {

std::vector<std::size_t> decimate(const Polyline& points, double tau_m,
                                  const std::vector<std::size_t>& pinned) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool must_stay =
        i == 0 || i + 1 == points.size() || std::binary_search(pinned.begin(), pinned.end(), i);
    if (must_stay || (points[i] - points[kept.back()]).norm() >= tau_m) kept.push_back(i);
  }
  return kept;
}

std::vector<std::size_t> douglas_peucker(const Polyline& points, double tolerance_m,
                                         const std::vector<std::size_t>& pinned) {
  std::vector<bool> stays(points.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> open;  // spans still to be examined
  std::size_t last = 0;
  const auto keep_and_open = [&](std::size_t index) {
    stays[index] = true;
    if (index > last) open.emplace_back(last, index);
    last = index;
  };
  if (points.empty()) return {};
  keep_and_open(0);
  for (const std::size_t index : pinned) keep_and_open(index);
  keep_and_open(points.size() - 1);

  while (!open.empty()) {
    const auto [first, end] = open.back();
    open.pop_back();
    const Segment2 edge{points[first], points[end]};
    double farthest_m = tolerance_m;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < end; ++i) {
      const double off_m = distance(edge, points[i]);
      if (off_m > farthest_m) {
        farthest_m = off_m;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    stays[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, end);
  }

  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (stays[i]) kept.push_back(i);
  }
  return kept;
}

}  // namespace roomatlas
