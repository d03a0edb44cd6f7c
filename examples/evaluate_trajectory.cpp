// SPDX-License-Identifier: GPL-3.0-or-later
// How far trajectories are from the true one; in TUM's format, or any other that Roomatlas reads:
//
//     evaluate_trajectory truth.tum odometry.tum corrected.tum
#include <exception>
#include <iostream>
#include <roomatlas/evaluate/ape_rpe.hpp>
#include <roomatlas/io/trajectories/trajectory_file.hpp>

int main(int argc, char** argv) try {
  using namespace roomatlas;
  if (argc < 3) throw UsageError("usage: evaluate_trajectory TRUTH TRAJECTORY...");
  const Trajectory truth = read_trajectory(argv[1], {}, LogPoses::truth).poses;

  std::cout.precision(3);
  for (int i = 2; i < argc; ++i) {
    const Trajectory estimate = read_trajectory(argv[i], {}, LogPoses::recorded).poses;
    const MatchedPoses matched = match_poses(estimate, truth, {.match = TimeMatch::interpolate});

    // The path as a whole, laid on the true one, and how it drifts on each metre of the way.
    const Statistics apart_m = ape(matched, {}).statistics;
    const Statistics drift_m = rpe(matched, {.unit = DeltaUnit::metres}).statistics;
    std::cout << argv[i] << ": " << to_string(matched.use) << '\n'
              << "  off by " << apart_m.rmse << " m (RMSE), " << apart_m.maximum << " m at most; "
              << drift_m.mean << " m on each metre driven\n";
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << "evaluate_trajectory: " << error.what() << '\n';
  return 1;
}
