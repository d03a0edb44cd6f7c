// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "models.hpp"

namespace roomatlas {

Measurements measurements_of(const std::vector<Asr>& asrs, const RoomGraph& graph,
                             const CorrectOptions& options) {
  Measurements measurements;
  std::map<AsrId, std::size_t> index_of;
  for (const Asr& asr : asrs) {
    index_of[asr.id] = measurements.ids.size();
    measurements.ids.push_back(asr.id);
    measurements.odom_from_asr.push_back(asr.odom_from_asr);
    measurements.walls.push_back(options.use_wall_directions
                                     ? wall_direction(asr.walls, options.walls)
                                     : std::nullopt);
  }
  measurements.component = components_of(graph);
  int components = 0;
  for (const int component : measurements.component) {
    measurements.is_fixed.push_back(component == components);
    if (component == components) ++components;
  }
  for (const PassageEdge& edge : edges_of(graph)) {
    auto& edges =
        edge.source == EdgeSource::driven ? measurements.driven : measurements.recognised;
    edges.push_back({index_of.at(edge.from), index_of.at(edge.to), edge});
  }
  return measurements;
}

HeadingAndPosition sigmas_of(const PassageEdge& edge, const CorrectOptions& options) {
  if (edge.source == EdgeSource::recognised) {
    return {radians(options.doorway_heading_deg), options.doorway_position_m};
  }
  const double heading_rad =
      std::hypot(radians(options.odometry_heading_deg),
                 radians(options.odometry_heading_deg_per_m) * edge.path_length_m,
                 options.odometry_heading_per_turn * edge.turned_rad);
  return {heading_rad, options.odometry_position_m +
                           options.odometry_position_m_per_m * edge.path_length_m};
}

std::optional<double> wall_offset(const Measurements& measurements, const State& state,
                                  std::size_t index, const CorrectOptions& options) {
  if (!measurements.walls[index]) return std::nullopt;
  const auto component = static_cast<std::size_t>(measurements.component[index]);
  const double wall = measurements.walls[index]->angle_rad;
  const double apart = state.building_from_asr[index].theta_rad + wall -
                       state.direction_rad[component];
  const double left_over = wrap_quarter(apart);
  if (std::abs(left_over) > radians(options.wall_gate_deg)) return std::nullopt;
  return wall - (apart - left_over);
}

State initial_guess(const Measurements& measurements, const CorrectOptions& options) {
  const std::size_t count = measurements.ids.size();
  std::vector<const Measurements::Edge*> driven_into(count, nullptr);
  for (const Measurements::Edge& edge : measurements.driven) driven_into[edge.to] = &edge;

  State state{measurements.odom_from_asr, {}};
  std::vector<bool> has_direction;
  for (std::size_t i = 0; i < count; ++i) {
    const auto component = static_cast<std::size_t>(measurements.component[i]);
    if (component >= state.direction_rad.size()) {
      state.direction_rad.resize(component + 1, 0.0);
      has_direction.resize(component + 1, false);
    }
    Pose2& pose = state.building_from_asr[i];
    if (driven_into[i] != nullptr && driven_into[i]->from < i) {
      pose = state.building_from_asr[driven_into[i]->from] * driven_into[i]->measured.from_from_to;
    }
    if (!measurements.walls[i]) continue;
    const double wall_rad = pose.theta_rad + measurements.walls[i]->angle_rad;
    if (!has_direction[component]) {
      state.direction_rad[component] = wrap_quarter(wall_rad);
      has_direction[component] = true;
      continue;
    }
    const double off = wrap_quarter(wall_rad - state.direction_rad[component]);
    if (!measurements.is_fixed[i] && std::abs(off) <= radians(options.wall_gate_deg)) {
      pose.theta_rad = wrap_angle(pose.theta_rad - off);
    }
  }
  return state;
}

}  // namespace roomatlas
