// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/number_rows.hpp"

#include "roomatlas/io/trajectories/relations.hpp"

#include <cmath>

namespace roomatlas {

/// z, roll and pitch are read and dropped: missions are planar.
std::vector<Relation> read_relations(const Path& file) {
  std::vector<Relation> relations;
  io::read_number_rows(file, {"t1", "t2", "x", "y", "z", "roll", "pitch", "yaw"},
                       [&](std::span<const double> row) -> std::string {
                         if (std::abs(row[7]) > 4.0 * kPi) {
                           return "yaw: " + std::to_string(row[7]) +
                                  " is beyond two turns of radians: it looks like degrees";
                         }
                         const Pose2 pose1_from_pose2{row[2], row[3], wrap_angle(row[7])};
                         relations.push_back({row[0], row[1], pose1_from_pose2});
                         return {};
                       });
  return relations;
}

}  // namespace roomatlas
