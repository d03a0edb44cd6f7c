// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/plan_accuracy.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

/// The standard deviation of a normal distribution over its mean absolute deviation.
constexpr double kSigmaOfMeanDeviation = 1.2533;

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

PlanAccuracy plan_accuracy(const FloorPlan& plan, const std::optional<Judgement>& judgement) {
  PlanAccuracy accuracy;
  accuracy.extent_m = longer_side_m(plan);
  if (accuracy.extent_m == 0.0) return accuracy;
  accuracy.within_room_m = scatter_of(plan.edges);
  if (!judgement) return accuracy;
  accuracy.between_rooms_m = judgement->place_m;
  accuracy.over_building_m = judgement->scale_share * accuracy.extent_m;
  accuracy.probability = judgement->probability;
  return accuracy;
}

}  // namespace roomatlas
