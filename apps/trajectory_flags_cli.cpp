// SPDX-License-Identifier: GPL-3.0-or-later
// How trajectories are judged, on the command line: one of the files that include CLI11.
#include <CLI/CLI.hpp>

#include <map>
#include <utility>

#include "limits.hpp"
#include "trajectory_flags.hpp"

namespace roomatlas::apps {
namespace {

template <typename Choice>
void add_choice(CLI::App* command, const std::string& names, Choice& value,
                const std::map<std::string, Choice>& choices, const std::string& meaning,
                const std::string& preset) {
  command->add_option(names, value, meaning + " [" + preset + "]")
      ->transform(CLI::CheckedTransformer(choices))
      ->group("Judging trajectories")
      ->configurable(false);
}

void add_times(CLI::App* command, TrajectoryFlags& flags) {
  const auto add = [&](const char* names, auto& value, const char* meaning) {
    return command->add_option(names, value, meaning)
        ->group("Judging trajectories")
        ->configurable(false);
  };
  MatchOptions& match = flags.compare.match;
  add_choice<TimeMatch>(command, "--match", match.match,
                        {{"exact", TimeMatch::exact},
                         {"nearest", TimeMatch::nearest},
                         {"interpolate", TimeMatch::interpolate}},
                        "exact, nearest or interpolate: the pose for a time of the truth", "exact");
  command
      ->add_option_function<double>(
          "--max-gap,--t-max-diff,--t_max_diff",
          [&match](double gap_s) { match.max_gap_s = gap_s; },
          "s; nearest: a pose farther away does not count [0.5]; interpolate: nor do neighbours "
          "farther apart [no limit]")
      ->check(CLI::NonNegativeNumber)
      ->check(finite())
      ->group("Judging trajectories")
      ->configurable(false);
  add("--time-offset,--t-offset,--t_offset", flags.time_offset_s,
      "s; added to the trajectory's times")
      ->check(finite());
  add("--pose-offset", flags.pose_offset,
      "x,y,theta (m, m, rad): judge this point of the robot, in the frame of its pose")
      ->delimiter(',')
      ->expected(3)
      ->check(finite());
  add("--stamps-from", flags.stamps_from,
      "CARMEN log: poses stamped by its logger's clock (last column) get its own timestamps")
      ->type_name("FILE");
  add("--carry", flags.carry, "odometry (TUM or log) that carries poses on where there are none")
      ->type_name("FILE");
  add("--split-seconds", flags.compare.split_s,
      "s; relations across less are local, the others loop [30]")
      ->check(finite());
}

void add_ape_rpe(CLI::App* command, TrajectoryFlags& flags) {
  const std::string group = "Judging trajectories by true poses (as evo)";
  CompareOptions& compare = flags.compare;
  command
      ->add_option_function<PoseRelation>(
          "-r,--pose-relation,--pose_relation",
          [&compare](const PoseRelation& relation) {
            compare.rpe.relation = relation;
            compare.ape.relation = relation == PoseRelation::point_distance_error_ratio
                                       ? PoseRelation::trans_part
                                       : relation;
          },
          "what of a pose's error counts [trans_part]")
      ->transform(CLI::CheckedTransformer(std::map<std::string, PoseRelation>{
          {"full", PoseRelation::full},
          {"trans_part", PoseRelation::trans_part},
          {"rot_part", PoseRelation::rot_part},
          {"angle_deg", PoseRelation::angle_deg},
          {"angle_rad", PoseRelation::angle_rad},
          {"point_distance", PoseRelation::point_distance},
          {"point_distance_error_ratio", PoseRelation::point_distance_error_ratio}}))
      ->group(group)
      ->configurable(false);
  const auto flag = [&](const char* names, const char* meaning, std::function<void()> set) {
    return command->add_flag_callback(names, std::move(set), meaning)
        ->group(group)
        ->configurable(false);
  };
  CLI::Option* align = flag("-a,--align", "align by least squares, without scale (default)",
                            [&compare] { compare.ape.alignment = Alignment::umeyama; });
  CLI::Option* origin = flag("--align-origin,--align_origin", "align the first pose",
                             [&compare] { compare.ape.alignment = Alignment::origin; });
  CLI::Option* none = flag("--no-align", "compare in the frames as they are",
                           [&compare] { compare.ape.alignment = Alignment::none; });
  align->excludes(origin)->excludes(none);
  origin->excludes(none);
  const auto add = [&](const char* names, auto& value, const char* meaning) {
    return command->add_option(names, value, meaning)->group(group)->configurable(false);
  };
  add("--n-to-align,--n_to_align", compare.ape.poses_to_align,
      "align by this many poses from the start [-1: all]");
  add("-d,--delta", compare.rpe.delta, "distance of the poses of a pair [1]")->check(finite());
  add_choice<DeltaUnit>(command, "-u,--delta-unit,--delta_unit", compare.rpe.unit,
                        {{"f", DeltaUnit::frames},
                         {"m", DeltaUnit::metres},
                         {"d", DeltaUnit::degrees},
                         {"r", DeltaUnit::radians}},
                        "f frames, m metres of path, d degrees, r radians", "f");
  add("-t,--delta-tol,--delta_tol", compare.rpe.relative_tolerance,
      "share of delta that a pair may miss it by, with --all-pairs [0.1]")
      ->check(finite());
  flag("--all-pairs,--all_pairs", "pairs from every pose instead of end to end",
       [&compare] { compare.rpe.all_pairs = true; });
  flag("--pairs-from-reference,--pairs_from_reference", "measure delta on the truth",
       [&compare] { compare.rpe.pairs_from_reference = true; });
  add("--bootstrap-resamples", compare.bootstrap.resamples,
      "draws for the confidence intervals [1000]")
      ->check(CLI::Range(1, 1000000));
  add("--bootstrap-seed", compare.bootstrap.seed, "decides the draws [1]")
      ->check(within(0.0, kLargestSeed));
}

}  // namespace

void add_trajectory_flags(CLI::App* command, TrajectoryFlags& flags) {
  add_times(command, flags);
  add_ape_rpe(command, flags);
}

}  // namespace roomatlas::apps
