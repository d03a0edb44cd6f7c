// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/number_rows.hpp"
#include "text/numbers.hpp"
#include "tum_text.hpp"

#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

#include <cmath>

namespace roomatlas {
namespace {

/// Heading of a unit quaternion; of one that tilts, the heading of its x axis.
double heading_rad(double x, double y, double z, double w) {
  if (x == 0.0 && y == 0.0) return wrap_angle(2.0 * std::atan2(z, w));
  return wrap_angle(std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)));
}

}  // namespace

std::string io::tum_text(const Trajectory& trajectory) {
  std::string text;
  for (const StampedPose& stamped : trajectory) {
    const Pose2& pose = stamped.pose;
    bool is_first = true;
    for (const double value : {stamped.timestamp_s, pose.x_m, pose.y_m, 0.0, 0.0, 0.0,
                               std::sin(pose.theta_rad / 2), std::cos(pose.theta_rad / 2)}) {
      if (!is_first) text += ' ';
      is_first = false;
      append_number(text, value);
    }
    text += '\n';
  }
  return text;
}

void write_tum(const Path& file, const Trajectory& trajectory) {
  write_file(file, io::tum_text(trajectory));
}

Trajectory read_tum(const Path& file) {
  Trajectory trajectory;
  io::read_number_rows(
      file, {"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"},
      [&](std::span<const double> row) -> std::string {
        const double norm = std::hypot(std::hypot(row[4], row[5]), std::hypot(row[6], row[7]));
        if (std::abs(norm - 1.0) > 0.01) {
          return "qx qy qz qw: expected a unit quaternion, found length " + std::to_string(norm);
        }
        const double theta_rad =
            heading_rad(row[4] / norm, row[5] / norm, row[6] / norm, row[7] / norm);
        trajectory.push_back({row[0], {row[1], row[2], theta_rad}});
        return {};
      });
  return trajectory;
}

}  // namespace roomatlas
