// SPDX-License-Identifier: GPL-3.0-or-later
// Overlap, walls of negative thickness: what the outlines say.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "consistency_figures.hpp"
#include "room_raster.hpp"
#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

constexpr double kOpposite = -0.9;  ///< cosine between the sides of one wall

/// The lattice cells that each room covers, each once.
std::map<RoomId, std::vector<LatticeCell>> cells_of_rooms(const PlacedAll& all, double step_m) {
  std::map<RoomId, std::vector<LatticeCell>> cells;
  for (const PlacedEvidence& placed : all) {
    std::vector<LatticeCell>& list = cells[placed.room];
    for (const LatticeCell& cell :
         cells_in(transformed(placed.building_from_asr, placed.evidence->outline), step_m)) {
      list.push_back(cell);
    }
  }
  for (auto& [room, list] : cells) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return cells;
}

using Surfaces = std::vector<SurfaceSample>;

/// Each ASR's surfaces by x in its own frame: only those about a place are asked.
std::vector<Surfaces> surfaces_by_x(const PlacedAll& all) {
  std::vector<Surfaces> surfaces;
  surfaces.reserve(all.size());
  for (const PlacedEvidence& placed : all) {
    surfaces.push_back(placed.evidence->surfaces);
    std::stable_sort(
        surfaces.back().begin(), surfaces.back().end(),
        [](const SurfaceSample& a, const SurfaceSample& b) { return a.point.x() < b.point.x(); });
  }
  return surfaces;
}

/// How far the facing wall of another room lies behind this surface: the wall's thickness, signed.
/// The nearest such wall counts.
/// @param others by x
std::optional<double> thickness_at(const Point2& point, const Point2& outwards,
                                   const Surfaces& others, double reach_m, double step_m) {
  const double apart_m = reach_m + step_m;
  std::optional<double> nearest;
  const auto first = std::partition_point(
      others.begin(), others.end(),
      [&](const SurfaceSample& other) { return other.point.x() < point.x() - apart_m; });
  for (auto other = first; other != others.end(); ++other) {
    const Point2 apart = other->point - point;
    if (apart.x() > apart_m) break;
    if (std::abs(apart.y()) > apart_m) continue;
    if (std::abs(cross(outwards, apart)) > step_m) continue;  // beside it, not behind it
    if (outwards.dot(other->outwards) > kOpposite) continue;
    const double behind_m = outwards.dot(apart);
    if (std::abs(behind_m) > reach_m) continue;
    if (!nearest || std::abs(behind_m) < std::abs(*nearest)) nearest = behind_m;
  }
  return nearest;
}

/// Lowers each thickness of `a`'s surfaces to that against `b`, where `b`'s wall is nearer.
/// @param surfaces those of b
void find_nearest_backs(const PlacedEvidence& a, const PlacedEvidence& b, const Surfaces& surfaces,
                        const ConsistencyOptions& options, std::vector<double>& thickness_m) {
  const Pose2 step = inverse(b.building_from_asr) * a.building_from_asr;
  const PointTransform b_from_a(step);
  for (std::size_t i = 0; i < thickness_m.size(); ++i) {
    const SurfaceSample& sample = a.evidence->surfaces[i];
    const auto found =
        thickness_at(b_from_a * sample.point, b_from_a * sample.outwards - step.position(),
                     surfaces, options.wall_reach_m, options.evidence.step_m);
    if (found && std::abs(*found) < std::abs(thickness_m[i])) thickness_m[i] = *found;
  }
}

/// The thickness of the wall at each of an ASR's surfaces; `wall_reach_m` where nothing is behind.
/// @param surfaces those of all, by x
std::vector<double> thicknesses_of(std::size_t asr, const PlacedAll& all, const NearAsrs& walls,
                                   const std::vector<Surfaces>& surfaces,
                                   const ConsistencyOptions& options) {
  const PlacedEvidence& a = all[asr];
  std::vector<double> thickness_m(a.evidence->surfaces.size(), options.wall_reach_m);
  for (const PlacedEvidence* b : walls.near(a.solid)) {
    if (a.room == b->room) continue;
    const auto at = static_cast<std::size_t>(b - all.data());
    find_nearest_backs(a, *b, surfaces[at], options, thickness_m);
  }
  return thickness_m;
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
  ConsistencyValue result{ConsistencyFigure::negative_walls};
  const NearAsrs walls(all, &PlacedEvidence::solid, options.wall_reach_m);
  const std::vector<Surfaces> surfaces = surfaces_by_x(all);
  double depth_sum_m = 0.0;
  std::int64_t samples = 0;
  for (const auto& of_asr : results_of<std::vector<double>>(
           all.size(), options.jobs,
           [&](std::size_t i) { return thicknesses_of(i, all, walls, surfaces, options); })) {
    for (const double thickness : of_asr) {
      depth_sum_m += std::max(-thickness, 0.0);
      if (thickness < options.wall_reach_m) result.measured += 1.0;
      ++samples;
    }
  }
  if (samples > 0) result.value = depth_sum_m / static_cast<double>(samples);
  return result;
}

}  // namespace roomatlas
