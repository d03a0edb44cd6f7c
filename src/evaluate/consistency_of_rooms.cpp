// SPDX-License-Identifier: GPL-3.0-or-later
// Overlap, walls of negative thickness: what the outlines say.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "consistency_figures.hpp"

namespace roomatlas {
namespace {

constexpr double kOpposite = -0.9;  ///< cosine between the sides of one wall

using LatticeCell = std::pair<std::int64_t, std::int64_t>;

/// The lattice cells that each room covers, each once.
std::map<RoomId, std::vector<LatticeCell>> cells_of_rooms(const PlacedAll& all, double step_m) {
  std::map<RoomId, std::vector<LatticeCell>> cells;
  for (const PlacedEvidence& placed : all) {
    for (const Point2& point : placed.evidence->inside) {
      const Point2 at = placed.building_from_asr * point / step_m;
      cells[placed.room].emplace_back(std::llround(at.x()), std::llround(at.y()));
    }
  }
  for (auto& [room, list] : cells) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return cells;
}

/// How far the facing wall of another room lies behind this surface: the wall's thickness, signed.
/// The nearest such wall counts.
std::optional<double> thickness_at(const Point2& point, const Point2& outwards,
                                   const std::vector<SurfaceSample>& others, double reach_m,
                                   double step_m) {
  std::optional<double> nearest;
  for (const SurfaceSample& other : others) {
    const Point2 apart = other.point - point;
    if (std::abs(apart.x()) > reach_m + step_m || std::abs(apart.y()) > reach_m + step_m) continue;
    if (std::abs(cross(outwards, apart)) > step_m) continue;  // beside it, not behind it
    if (outwards.dot(other.outwards) > kOpposite) continue;
    const double behind_m = outwards.dot(apart);
    if (std::abs(behind_m) > reach_m) continue;
    if (!nearest || std::abs(behind_m) < std::abs(*nearest)) nearest = behind_m;
  }
  return nearest;
}

}  // namespace

ConsistencyValue room_overlap(const PlacedAll& all, const ConsistencyOptions& options) {
  std::vector<LatticeCell> covered;
  for (const auto& [room, cells] : cells_of_rooms(all, options.evidence.step_m)) {
    covered.insert(covered.end(), cells.begin(), cells.end());
  }
  ConsistencyValue result{ConsistencyFigure::room_overlap};
  if (covered.empty()) return result;
  std::sort(covered.begin(), covered.end());
  const auto twice = static_cast<double>(covered.size());
  covered.erase(std::unique(covered.begin(), covered.end()), covered.end());
  const auto once = static_cast<double>(covered.size());
  result.value = (twice - once) / once;
  result.measured = once * options.evidence.step_m * options.evidence.step_m;
  return result;
}

ConsistencyValue negative_walls(const PlacedAll& all, const ConsistencyOptions& options) {
  double depth_sum_m = 0.0;
  std::int64_t measured = 0;
  for (const PlacedEvidence& a : all) {
    for (const PlacedEvidence& b : all) {
      if (a.room == b.room || !near(a, b, options.wall_reach_m)) continue;
      const Pose2 b_from_a = inverse(b.building_from_asr) * a.building_from_asr;
      for (const SurfaceSample& sample : a.evidence->surfaces) {
        const auto thickness_m =
            thickness_at(b_from_a * sample.point, b_from_a * sample.outwards - b_from_a.position(),
                         b.evidence->surfaces, options.wall_reach_m, options.evidence.step_m);
        if (!thickness_m) continue;
        ++measured;
        depth_sum_m += std::max(-*thickness_m, 0.0);
      }
    }
  }
  ConsistencyValue result{ConsistencyFigure::negative_walls};
  result.measured = static_cast<double>(measured);
  if (measured > 0) result.value = depth_sum_m / result.measured;
  return result;
}

}  // namespace roomatlas
