// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {

struct PoseGraphFile {
  PoseGraph graph;             ///< nodes in the order of the file; guess empty without vertices
  std::int64_t g2o_lines = 0;  ///< VERTEX_SE2 and EDGE_SE2
  std::int64_t toro_lines = 0;
  std::map<std::string, std::int64_t> ignored_lines;  ///< by tag
  Issues issues;                                      ///< says what was passed over
};

/// Reads a planar pose graph, plain or gzip, g2o or TORO (docs/formats.md). Edges between ids that
/// differ by 1 are odometry, all others loops. Vertices are optional: without any, nodes are those
/// of the edges.
/// Throws InputError naming file and line when a line of the graph cannot be read, a number is not
/// finite, an information matrix has a negative eigenvalue, a vertex stands twice, an edge joins a
/// vertex with itself or, in a file with vertices, one that is missing.
[[nodiscard]] PoseGraphFile read_pose_graph(const std::filesystem::path& file);

/// Writes g2o, numbers in their shortest form that reads back to the same double.
/// @param poses one a node
/// @param accepted one an edge, or empty: edges that are not are written as comments
void write_g2o(const std::filesystem::path& file, const PoseGraph& graph,
               std::span<const Pose2> poses, std::span<const std::uint8_t> accepted);

}  // namespace roomatlas
