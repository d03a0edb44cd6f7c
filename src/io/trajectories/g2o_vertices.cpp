// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_rows.hpp"
#include "text/line_reader.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace roomatlas::io {
namespace {

struct Vertex {
  double id = 0.0;
  Pose2 pose;
  std::optional<double> timestamp_s;
};

bool is_vertex(std::string_view tag) { return tag == "VERTEX_SE2" || tag == "VERTEX2"; }

/// The third field from the end: `... timestamp host logger_timestamp`.
std::optional<double> timestamp_of_scan(Tokens fields) {
  const std::size_t count = fields.count();
  if (count < 3) return std::nullopt;
  for (std::size_t i = 0; i + 3 < count; ++i) (void)fields.next();
  return parse_number(fields.next());
}

}  // namespace

TrajectoryFile read_vertices(const std::filesystem::path& file) {
  LineReader reader(file);
  std::vector<Vertex> vertices;
  std::vector<double> theta_rad;
  while (const auto line = reader.next()) {
    Tokens fields(*line);
    if (fields.at_end()) continue;
    const std::string_view tag = fields.next();
    if (tag == "ROBOTLASER1" && !vertices.empty()) {
      vertices.back().timestamp_s = timestamp_of_scan(fields);
      continue;
    }
    if (!is_vertex(tag)) continue;
    std::array<double, 4> value{};
    for (double& number : value) {
      const std::string_view token = fields.next();
      const auto parsed = parse_number(token);
      if (!parsed || !std::isfinite(*parsed)) {
        throw InputError(file.string() + ":" + std::to_string(reader.line_number()) +
                         ": expected a vertex `id x y theta`, found " + quoted(token) +
                         "; correct or delete the line");
      }
      number = *parsed;
    }
    theta_rad.push_back(value[3]);
    vertices.push_back({value[0], {value[1], value[2], wrap_angle(value[3])}, std::nullopt});
  }
  if (vertices.empty()) {
    throw InputError(file.string() +
                     ": has no vertices (VERTEX_SE2 or VERTEX2), so no poses; "
                     "name an optimised graph");
  }
  refuse_degrees(file, theta_rad);

  TrajectoryFile read;
  read.format = "g2o";
  const bool stamped = std::all_of(vertices.begin(), vertices.end(), [](const Vertex& vertex) {
    return vertex.timestamp_s.has_value();
  });
  read.clock = stamped ? PoseClock::timestamps : PoseClock::numbers;
  for (const Vertex& vertex : vertices) {
    read.poses.push_back({stamped ? *vertex.timestamp_s : vertex.id, vertex.pose});
  }
  return read;
}

}  // namespace roomatlas::io
