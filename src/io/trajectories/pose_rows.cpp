// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_rows.hpp"

#include "text/number_rows.hpp"

#include <cmath>
#include <cstdio>

namespace roomatlas::io {

TrajectoryFile read_pose_rows(const std::filesystem::path& file, bool has_times) {
  TrajectoryFile read;
  read.format = "poses";
  read.clock = has_times ? PoseClock::timestamps : PoseClock::numbers;
  std::vector<std::string> columns = {"x", "y", "theta"};
  if (has_times) columns.insert(columns.begin(), "timestamp");
  std::vector<double> theta_rad;
  read_number_rows(file, columns, [&](std::span<const double> row) {
    const double time_s = has_times ? row[0] : static_cast<double>(read.poses.size());
    const std::size_t x = has_times ? 1 : 0;
    theta_rad.push_back(row[x + 2]);
    read.poses.push_back({time_s, {row[x], row[x + 1], wrap_angle(row[x + 2])}});
    return std::string();
  });
  refuse_degrees(file, theta_rad);
  return read;
}

void refuse_degrees(const std::filesystem::path& file, const std::vector<double>& theta_rad) {
  constexpr double kMostTurn_rad = 1.0;  // root mean square, from one pose to the next
  double largest = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < theta_rad.size(); ++i) {
    largest = std::fmax(largest, std::abs(theta_rad[i]));
    if (i > 0) squares += std::pow(theta_rad[i] - theta_rad[i - 1], 2);
  }
  // Headings may be counted on beyond a turn, but then they do not jump.
  const double turn_rad =
      std::sqrt(squares / std::fmax(1.0, static_cast<double>(theta_rad.size())));
  if (largest <= 2.0 * kPi || turn_rad <= kMostTurn_rad) return;
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", largest);
  throw InputError(file.string() + ": theta: values up to " + text +
                   " look like degrees; this format has radians: multiply them by pi / 180");
}

}  // namespace roomatlas::io
