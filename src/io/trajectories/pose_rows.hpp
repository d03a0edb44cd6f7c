// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/trajectories/trajectory_file.hpp"

namespace roomatlas::io {

/// `timestamp x y theta` a line, or `x y theta` where the pose's number, from 0, is its time.
[[nodiscard]] TrajectoryFile read_pose_rows(const std::filesystem::path& file, bool has_times);

/// Vertices of a g2o or TORO graph.
[[nodiscard]] TrajectoryFile read_vertices(const std::filesystem::path& file);

/// Throws InputError when headings, in file order and as the file has them, look like degrees:
/// beyond a full turn of radians, and jumping from one to the next by more than a robot turns.
void refuse_degrees(const std::filesystem::path& file, const std::vector<double>& theta_rad);

}  // namespace roomatlas::io
