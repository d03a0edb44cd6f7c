// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/plan_accuracy.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

/// Of a building's lengths: by how much whole plans are too short or too long, the root mean square
/// over nine simulated missions and both axes, rounded up (docs/method.md). A robot does not see
/// how far it drove along a corridor, so that odometry's scale remains there.
constexpr double kScaleShare = 0.005;

/// The standard deviation of a normal distribution over its mean absolute deviation.
constexpr double kSigmaOfMeanDeviation = 1.2533;

constexpr double kCounts = 0.5;  // weight of a measurement that the correction believed

/// The scatter about the measured edges, each by its length.
std::optional<double> scatter_of(const std::vector<PlanEdge>& edges) {
  double all_m = 0.0;
  double sum = 0.0;
  for (const PlanEdge& edge : edges) {
    if (edge.evidence != WallEvidence::measured || !edge.deviation_m) continue;
    const double length_m = (edge.line.b - edge.line.a).norm();
    all_m += length_m;
    sum += length_m * *edge.deviation_m * *edge.deviation_m;
  }
  if (!(all_m > 0.0)) return std::nullopt;
  return kSigmaOfMeanDeviation * std::sqrt(sum / all_m);
}

double longer_side_m(const FloorPlan& plan) {
  Box2 box;
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) {
      for (const Point2& point : part.outer) box.extend(point);
    }
  }
  return box.size().maxCoeff();
}

}  // namespace

PlanAccuracy plan_accuracy(const FloorPlan& plan, const Correction& correction,
                           std::optional<double> between_rooms_m) {
  PlanAccuracy accuracy;
  accuracy.extent_m = longer_side_m(plan);
  if (accuracy.extent_m == 0.0) return accuracy;
  accuracy.within_room_m = scatter_of(plan.edges);
  accuracy.between_rooms_m = between_rooms_m;
  accuracy.loops = static_cast<int>(
      std::count_if(correction.factors.begin(), correction.factors.end(), [](const auto& factor) {
        const bool is_loop =
            factor.kind == FactorKind::closure || factor.kind == FactorKind::doorway;
        return is_loop && factor.weight >= kCounts;
      }));
  accuracy.over_building_m =
      std::hypot(between_rooms_m.value_or(0.0), kScaleShare * accuracy.extent_m);
  return accuracy;
}

}  // namespace roomatlas
