// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/correct/correct.hpp"

#include <cmath>

#include "models.hpp"
#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {
namespace {

/// Turns each component about its fixed ASR so that its walls' direction is the x axis.
void align_with_walls(const Measurements& measurements, const PlacedAsrs& state,
                      std::vector<AsrCorrection>& asrs) {
  std::map<int, Pose2> aligned_from_building;
  for (std::size_t i = 0; i < asrs.size(); ++i) {
    const int component = measurements.component[i];
    if (measurements.is_fixed[i]) {
      const Pose2& fixed = measurements.odom_from_asr[i];
      const double turn = -wrap_quarter(state.direction_rad[static_cast<std::size_t>(component)]);
      aligned_from_building[component] =
          Pose2{fixed.x_m, fixed.y_m, turn} * Pose2{-fixed.x_m, -fixed.y_m, 0.0};
    }
    const Pose2& aligned = aligned_from_building.at(component);
    asrs[i].building_from_asr_before = aligned * asrs[i].building_from_asr_before;
    asrs[i].building_from_asr = aligned * asrs[i].building_from_asr;
  }
}

/// The direction of each component's walls, more finely than from one direction a room.
/// @param asrs in the order of the measurements
void settle_directions(const std::vector<Asr>& asrs, const Measurements& measurements,
                       const CorrectOptions& options, PlacedAsrs& state) {
  for (std::size_t component = 0; component < state.direction_rad.size(); ++component) {
    std::vector<const Asr*> rooms;
    std::vector<double> heading_rad;
    for (std::size_t i = 0; i < asrs.size(); ++i) {
      if (measurements.component[i] != static_cast<int>(component)) continue;
      rooms.push_back(&asrs[i]);
      heading_rad.push_back(state.building_from_asr[i].theta_rad);
    }
    double& direction_rad = state.direction_rad[component];
    direction_rad = settled_direction(direction_rad, rooms, heading_rad, options.walls);
  }
}

void fill_moves(std::vector<AsrCorrection>& asrs) {
  for (AsrCorrection& asr : asrs) {
    asr.moved_m =
        (asr.building_from_asr.position() - asr.building_from_asr_before.position()).norm();
    asr.turned_rad =
        wrap_angle(asr.building_from_asr.theta_rad - asr.building_from_asr_before.theta_rad);
  }
}

/// Why each ASR moved: the ledger of the correction.
void fill_causes(const std::vector<FactorReport>& factors, std::vector<AsrCorrection>& asrs) {
  std::map<AsrId, AsrCorrection*> of;
  for (AsrCorrection& asr : asrs) of[asr.asr] = &asr;
  std::map<AsrId, double> settled;
  const auto charge = [&](const FactorReport& factor, AsrId id, AsrId other) {
    AsrCorrection& asr = *of.at(id);
    asr.chi_square_before += factor.chi_square_before;
    asr.chi_square_after += factor.chi_square_after;
    const double gain = factor.weight * (factor.chi_square_before - factor.chi_square_after);
    if (gain <= settled[id]) return;
    settled[id] = gain;
    asr.cause = factor.kind;
    asr.cause_asr = other;
  };
  for (const FactorReport& factor : factors) {
    if (factor.chi_square_before < 0.0 || factor.chi_square_after < 0.0) continue;
    charge(factor, factor.from, factor.to);
    if (factor.to != 0) charge(factor, factor.to, factor.from);
  }
}

}  // namespace

const char* to_string(FactorKind kind) {
  switch (kind) {
    case FactorKind::odometry:
      return "odometry";
    case FactorKind::doorway:
      return "doorway";
    case FactorKind::closure:
      return "closure";
    case FactorKind::wall_direction:
      return "wall_direction";
  }
  return "unknown";
}

Correction correct(const std::vector<Asr>& asrs, const RoomGraph& graph,
                   const CorrectOptions& options, const Placement& start,
                   const std::optional<EstimatedHabits>& habits) {
  Correction correction;
  const bool is_se2 = options.model == CorrectionModel::se2;
  correction.model = is_se2 ? "se2" : "rotation_only";
  if (asrs.empty()) {
    correction.converged = true;
    correction.message = "nothing to correct";
    return correction;
  }
  const Measurements measurements = measurements_of(asrs, graph, options, habits);
  const PlacedAsrs guess = initial_guess(measurements, options, start);
  ModelResult solved = is_se2 ? solve_se2(measurements, guess, options)
                              : solve_rotation_only(measurements, guess, options);
  correction.converged = solved.converged;
  correction.message = solved.message;
  correction.initial_cost = solved.initial_cost;
  correction.final_cost = solved.final_cost;
  correction.iterations = solved.iterations;
  correction.odometry = measurements.habits;
  correction.factors = solved.factors;
  for (std::size_t i = 0; i < measurements.ids.size(); ++i) {
    correction.asrs.push_back({measurements.ids[i], measurements.component[i],
                               measurements.odom_from_asr[i], solved.state.building_from_asr[i],
                               0.0, 0.0, 0.0, 0.0});
  }
  if (options.use_wall_directions && options.settle_on_walls) {
    settle_directions(asrs, measurements, options, solved.state);
  }
  align_with_walls(measurements, solved.state, correction.asrs);
  fill_moves(correction.asrs);
  fill_causes(correction.factors, correction.asrs);
  return correction;
}

Correction correct_to(const std::vector<Asr>& asrs, const RoomGraph& graph,
                      const Placement& placement, const CorrectOptions& options,
                      std::optional<double> walls_rad) {
  Correction correction;
  correction.model = "trajectory";
  correction.message = "placed by the corrected trajectory";
  correction.converged = true;
  CorrectOptions as_measured = options;
  as_measured.use_heading_bias = false;
  const Measurements measurements = measurements_of(asrs, graph, as_measured);
  PlacedAsrs state = initial_guess(measurements, as_measured, placement);
  for (double& direction_rad : state.direction_rad) {
    direction_rad = walls_rad.value_or(direction_rad);
  }
  correction.initial_cost = correction.final_cost = 0.0;
  const auto report = [&](const Measurements::Edge& edge, FactorKind kind) {
    PoseEdge measured;
    measured.from_from_to = edge.measured.from_from_to;
    measured.information = information_of(edge.measured, options);
    const auto chi_square_at = [&](const std::vector<Pose2>& poses) {
      return chi_square(measured, poses[edge.from], poses[edge.to]);
    };
    correction.factors.push_back({kind, measurements.ids[edge.from], measurements.ids[edge.to],
                                  chi_square_at(measurements.odom_from_asr),
                                  chi_square_at(state.building_from_asr), 1.0});
    correction.initial_cost += correction.factors.back().chi_square_before / 2.0;
    correction.final_cost += correction.factors.back().chi_square_after / 2.0;
  };
  for (const auto& edge : measurements.driven) report(edge, FactorKind::odometry);
  for (const auto& edge : measurements.recognised) report(edge, kind_of(edge.measured));
  for (std::size_t i = 0; i < measurements.ids.size(); ++i) {
    correction.asrs.push_back({measurements.ids[i], measurements.component[i],
                               measurements.odom_from_asr[i], state.building_from_asr[i], 0.0, 0.0,
                               0.0, 0.0});
  }
  align_with_walls(measurements, state, correction.asrs);
  fill_moves(correction.asrs);
  fill_causes(correction.factors, correction.asrs);
  return correction;
}

Placement placement_of(const Correction& correction) {
  Placement placement;
  for (const AsrCorrection& asr : correction.asrs) placement[asr.asr] = asr.building_from_asr;
  return placement;
}

}  // namespace roomatlas
