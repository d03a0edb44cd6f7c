// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers: relations, trajectories, pose graphs, matches, tape measures, drives.
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/plans/spans_file.hpp"
#include "roomatlas/io/trajectories/closures_file.hpp"
#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/io/trajectories/relations.hpp"
#include "roomatlas/io/trajectories/tum.hpp"
#include "target.hpp"

namespace roomatlas::fuzz {
namespace {

using Seeds = std::vector<std::string>;

template <typename Read>
Target table(const char* name, const char* file_name, const Seeds& seeds, Read read) {
  return {name, file_name, [seeds] { return seeds; },
          [read](const Path& file, const std::string&) { (void)read(file); }};
}

Seeds graph_seeds() {
  return {
      "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0.1\nVERTEX_SE2 2 2 0.5 0.2\nFIX 0\n"
      "EDGE_SE2 0 1 1 0 0.1 500 0 0 500 0 5000\nEDGE_SE2 1 2 1 0.4 0.1 500 1 2 500 3 5000\n"
      "EDGE_SE2 2 0 -2 0 0 50 0 0 50 0 500\n",
      "VERTEX2 0 0 0 0\nVERTEX2 1 1 0 0.1\nEDGE2 0 1 1 0 0.1 500 0 500 5000 0 0\n",
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nEDGE_SE2_XY 0 1 2 3 1 0 1\n# comment\n"};
}

}  // namespace

std::vector<Target> table_targets() {
  return {
      table("relations", "truth.relations",
            {"1.5 2.5 1 2 0 0 0 0.5\n# comment\n2.5 3.5 -1 0 0 0 0 -3.1\n"}, read_relations),
      table("tum", "poses.tum", pose_seeds(), read_tum),
      table("pose_graph", "graph.g2o", graph_seeds(), read_pose_graph),
      table("closures", "matches.txt", {"1 2 0.5 1 0.1\n# comment\n3 1 -2 0 3.1\n"}, read_closures),
      table("spans", "tape.csv",
            {"# a comment\nwidth of 3, room 3 west, room 3 east, 4.02\n"
             "doors,door 1,door 12,7.5 # twice\ncorner to door, 1.5 -2, door 4, 3\n"},
            read_spans),
      table("drive", "way.drive",
            {"1 2\n# comment\n3.5 2\n-1e2 4\n", shipped("worlds/eight_rooms.drive")}, read_drive),
  };
}

}  // namespace roomatlas::fuzz
