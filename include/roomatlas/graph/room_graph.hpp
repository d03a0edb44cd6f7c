// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "roomatlas/asr/asr.hpp"
#include "roomatlas/asr/store.hpp"

namespace roomatlas {

/// A vertex of the room graph: one visit.
struct AsrVertex {
  AsrId asr = 0;
  RoomId room = 0;  ///< 0 until rooms are assigned
};

enum class EdgeSource {
  driven,      ///< the robot drove from one ASR into the other
  recognised,  ///< found offline: both ASRs begin at the same doorway
  matched,     ///< found offline: both ASRs saw the same walls
};

/// An edge of the room graph: a measured relative pose. The graph is undirected; the edge itself
/// says which ASR its pose starts from.
struct PassageEdge {
  AsrId from = 0;
  AsrId to = 0;
  Pose2 from_from_to;  ///< the frame of `to` in the frame of `from`
  PassageKind kind = PassageKind::doorway;
  EdgeSource source = EdgeSource::driven;
  double path_length_m = 0.0;  ///< driven inside `from`; 0 for a recognised edge
  Turning turning;             ///< inside `from`; none for a recognised edge
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of a matched edge, else zero: in the
                                                          ///< frame of `to`, 1/m^2, 1/rad^2
  bool is_localized = false;  ///< the pose was found in the map of `from`, not by odometry
  bool is_doubtful = false;   ///< the robot was lost on the way: closures say otherwise
};

/// Paper Fig. 8: rooms as vertices, passages as edges.
struct RoomGraph {
  std::vector<AsrVertex> vertices;  ///< vertex i is the i-th ASR, ascending by id
  std::vector<PassageEdge> edges;   ///< in the order in which they were added; both ends exist
};

/// The graph of a mission: a vertex for each ASR, an edge for each passage driven through.
/// An exit whose neighbour is missing (a store cut short) gives no edge.
/// @param asrs ascending by id, with their paths
[[nodiscard]] RoomGraph build_graph(const std::vector<Asr>& asrs);

/// Adds an edge between two ASRs of the graph. Throws std::out_of_range when one is missing.
void add_edge(RoomGraph& graph, const PassageEdge& edge);

/// Doubts the driven passages into these ASRs.
void doubt_passages_into(RoomGraph& graph, const std::set<AsrId>& asrs);

/// Writes the room of each ASR into its vertex.
void set_rooms(RoomGraph& graph, const std::map<AsrId, RoomId>& room_of_asr);

/// The component of each vertex, 0, 1, 2 ... in the order of the vertices.
[[nodiscard]] std::vector<int> components_of(const RoomGraph& graph);

/// A basis of the graph's cycles: one for each edge outside of a spanning forest, as the ASRs
/// along it. Their number is edges - vertices + components.
[[nodiscard]] std::vector<std::vector<AsrId>> cycle_basis(const RoomGraph& graph);

/// Graphviz DOT; doorways solid, open passages dashed, recognised doorways bold.
[[nodiscard]] std::string to_dot(const RoomGraph& graph);

}  // namespace roomatlas
