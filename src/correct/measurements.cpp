// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "asr_headings.hpp"
#include "models.hpp"

namespace roomatlas {

Measurements measurements_of(const std::vector<Asr>& asrs, const RoomGraph& graph,
                             const CorrectOptions& options,
                             const std::optional<EstimatedHabits>& habits) {
  Measurements measurements;
  std::map<AsrId, std::size_t> index_of;
  for (const Asr& asr : asrs) {
    index_of[asr.id] = measurements.ids.size();
    measurements.ids.push_back(asr.id);
    measurements.odom_from_asr.push_back(asr.odom_from_asr);
    measurements.walls.push_back(
        options.use_wall_directions ? wall_direction(asr.walls, options.walls) : std::nullopt);
    measurements.path_length_m.push_back(path_length_m(asr));
    measurements.turning.push_back(turning(asr));
  }
  measurements.component = components_of(graph);
  int components = 0;
  for (const int component : measurements.component) {
    measurements.is_fixed.push_back(component == components);
    if (component == components) ++components;
  }
  for (const PassageEdge& edge : graph.edges) {
    auto& edges = edge.source == EdgeSource::driven ? measurements.driven : measurements.recognised;
    edges.push_back({index_of.at(edge.from), index_of.at(edge.to), edge});
  }
  const bool is_reckoned =
      std::any_of(measurements.driven.begin(), measurements.driven.end(),
                  [](const auto& edge) { return !edge.measured.is_localized; });
  if (options.use_heading_bias && is_reckoned) {
    measurements.habits = habits ? *habits : estimate_habits(measurements, options);
    take_out_habits(measurements, measurements.habits.habits);
  }
  return measurements;
}

HeadingAndPosition sigmas_of(const PassageEdge& edge, const CorrectOptions& options) {
  if (edge.source == EdgeSource::recognised) {
    return {radians(options.doorway_heading_deg), options.doorway_position_m};
  }
  if (edge.source == EdgeSource::matched) {
    return {std::sqrt(1.0 / edge.information(2, 2)), std::sqrt(1.0 / edge.information(0, 0))};
  }
  if (edge.is_localized) {
    return {radians(options.localized_heading_deg), options.localized_position_m};
  }
  const double turned_rad = edge.turning.absolute_rad;
  const MotionSigma& heading = options.odometry.heading;
  return {
      std::hypot(heading.still, heading.per_m * edge.path_length_m, heading.per_rad * turned_rad),
      plain_sum(options.odometry.position, edge.path_length_m, turned_rad)};
}

std::optional<double> wall_offset(const Measurements& measurements, const PlacedAsrs& state,
                                  std::size_t index, const CorrectOptions& options) {
  if (!measurements.walls[index]) return std::nullopt;
  const auto component = static_cast<std::size_t>(measurements.component[index]);
  const double wall = measurements.walls[index]->angle_rad;
  const double apart =
      state.building_from_asr[index].theta_rad + wall - state.direction_rad[component];
  const double left_over = wrap_quarter(apart);
  if (std::abs(left_over) > radians(options.wall_gate_deg)) return std::nullopt;
  return wall - (apart - left_over);
}

double wall_sigma_rad(const WallDirection& wall, const CorrectOptions& options) {
  return radians(std::hypot(options.wall_heading_deg, options.wall_heading_deg_m / wall.aligned_m));
}

FactorKind kind_of(const PassageEdge& edge) {
  return edge.source == EdgeSource::matched ? FactorKind::closure : FactorKind::doorway;
}

Eigen::Matrix3d information_of(const PassageEdge& edge, const CorrectOptions& options) {
  if (edge.source == EdgeSource::matched) return edge.information;
  const HeadingAndPosition sigma = sigmas_of(edge, options);
  const double position = 1.0 / (sigma.position_m * sigma.position_m);
  const double heading = 1.0 / (sigma.heading_rad * sigma.heading_rad);
  return Eigen::Vector3d(position, position, heading).asDiagonal();
}

PlacedAsrs initial_guess(const Measurements& measurements, const CorrectOptions& options,
                         const Placement& known) {
  std::vector<const Measurements::Edge*> driven_into(measurements.ids.size(), nullptr);
  for (const Measurements::Edge& edge : measurements.driven) driven_into[edge.to] = &edge;
  const std::vector<double> turn =
      asr_headings(measurements, {}, options).correction_rad;  // `driven` has no habits any more

  PlacedAsrs state{measurements.odom_from_asr, {}};
  std::vector<Point2> direction_votes;  // of each component, at four times the angle
  for (std::size_t i = 0; i < state.building_from_asr.size(); ++i) {
    const auto component = static_cast<std::size_t>(measurements.component[i]);
    if (component >= direction_votes.size()) direction_votes.resize(component + 1, {0.0, 0.0});
    Pose2& pose = state.building_from_asr[i];
    if (driven_into[i] != nullptr && driven_into[i]->from < i) {
      const std::size_t from = driven_into[i]->from;
      pose = state.building_from_asr[from] * driven_into[i]->measured.from_from_to;
      pose.theta_rad = wrap_angle(pose.theta_rad + turn[i] - turn[from]);
    }
    if (const auto at = known.find(measurements.ids[i]); at != known.end()) pose = at->second;
    if (!measurements.walls[i]) continue;
    const WallDirection& wall = *measurements.walls[i];
    direction_votes[component] +=
        wall.aligned_m * direction(4.0 * (pose.theta_rad + wall.angle_rad));
  }
  for (const Point2& votes : direction_votes) {
    state.direction_rad.push_back(std::atan2(votes.y(), votes.x()) / 4.0);
  }
  return state;
}

}  // namespace roomatlas
