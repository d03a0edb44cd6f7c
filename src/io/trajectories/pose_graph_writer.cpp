// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/output_file.hpp"
#include "text/numbers.hpp"

#include "roomatlas/io/trajectories/pose_graph_file.hpp"

namespace roomatlas {
namespace {

void append(std::string& line, const Pose2& pose) {
  for (const double value : {pose.x_m, pose.y_m, pose.theta_rad}) {
    line += ' ';
    io::append_number(line, value);
  }
}

}  // namespace

void write_g2o(const std::filesystem::path& file, const PoseGraph& graph,
               std::span<const Pose2> poses, std::span<const std::uint8_t> accepted) {
  io::OutputFile output(file);
  std::string line;
  for (std::size_t i = 0; i < graph.ids.size(); ++i) {
    line = "VERTEX_SE2 " + std::to_string(graph.ids[i]);
    append(line, poses[i]);
    output.write(line += '\n');
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const PoseEdge& edge = graph.edges[e];
    line = accepted.empty() || accepted[e] != 0 ? "EDGE_SE2 " : "# rejected: EDGE_SE2 ";
    line += std::to_string(graph.ids[static_cast<std::size_t>(edge.from)]) + ' ' +
            std::to_string(graph.ids[static_cast<std::size_t>(edge.to)]);
    append(line, edge.from_from_to);
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) {
        line += ' ';
        io::append_number(line, edge.information(row, column));
      }
    }
    output.write(line += '\n');
  }
  output.commit();
}

}  // namespace roomatlas
