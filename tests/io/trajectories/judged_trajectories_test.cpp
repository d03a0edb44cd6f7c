// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that are known: of files kept beside the tests, computed again here from their text,
// and of recorded logs.
#include "roomatlas/evaluate/evaluate.hpp"
#include "roomatlas/io/trajectories/relations.hpp"
#include "roomatlas/io/trajectories/trajectory_file.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

#include "support/shared_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace roomatlas {
namespace {

using Number = long double;

const Path kFolder = Path(ROOMATLAS_SOURCE_DIR) / "tests/data";

/// Columns of a file of numbers, read without the library.
std::vector<std::vector<Number>> rows_of(const Path& file) {
  std::vector<std::vector<Number>> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    rows.emplace_back();
    for (Number number = 0; fields >> number;) rows.back().push_back(number);
  }
  return rows;
}

/// Distance of the positions of both files, row by row, as they are.
std::vector<Number> distances(const std::vector<std::vector<Number>>& a,
                              const std::vector<std::vector<Number>>& b) {
  std::vector<Number> result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.push_back(std::hypot(a[i][1] - b[i][1], a[i][2] - b[i][2]));
  }
  return result;
}

void expect_seven(const Statistics& s, std::vector<Number> values) {
  Number sum = 0;
  Number squares = 0;
  for (const Number value : values) {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<Number>(values.size());
  Number deviations = 0;
  for (const Number value : values) deviations += (value - sum / count) * (value - sum / count);
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const Number median = (values[half] + values[values.size() - 1 - half]) / 2;
  const auto near = [](double ours, Number theirs) {
    EXPECT_NEAR(ours, static_cast<double>(theirs), 1e-9);
  };
  EXPECT_EQ(s.count, std::ssize(values));
  near(s.rmse, std::sqrt(squares / count));
  near(s.mean, sum / count);
  near(s.median, median);
  near(s.standard_deviation, std::sqrt(deviations / count));
  near(s.minimum, values.front());
  near(s.maximum, values.back());
  near(s.sse, squares);
}

MatchedPoses kept_poses() {
  return match_poses(read_tum(kFolder / "wavy_estimate.tum"), read_tum(kFolder / "wavy_truth.tum"),
                     {});
}

TEST(KeptFiles, HaveTheSevenStatisticsOfAPEThatTheirTextGives) {
  const auto errors =
      distances(rows_of(kFolder / "wavy_estimate.tum"), rows_of(kFolder / "wavy_truth.tum"));
  ASSERT_EQ(errors.size(), 120U);
  expect_seven(ape(kept_poses(), {PoseRelation::trans_part, Alignment::none, -1}).statistics,
               errors);
}

TEST(KeptFiles, HaveTheSevenStatisticsOfRPEThatTheirTextGives) {
  const auto estimate = rows_of(kFolder / "wavy_estimate.tum");
  const auto truth = rows_of(kFolder / "wavy_truth.tum");
  // The step from a row to the next, in the frame of the first: x forward, y left, and its turn.
  struct Step {
    Number x, y, turn;
  };
  const auto heading = [](const std::vector<Number>& row) {
    return 2 * std::atan2(row[6], row[7]);
  };
  const auto step = [&](const std::vector<std::vector<Number>>& rows, std::size_t i) {
    const Number dx = rows[i + 1][1] - rows[i][1];
    const Number dy = rows[i + 1][2] - rows[i][2];
    const Number at = heading(rows[i]);
    return Step{std::cos(at) * dx + std::sin(at) * dy, std::cos(at) * dy - std::sin(at) * dx,
                heading(rows[i + 1]) - at};
  };
  std::vector<Number> lengths;
  std::vector<Number> turns;
  for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
    const Step ours = step(estimate, i);
    const Step theirs = step(truth, i);
    lengths.push_back(std::hypot(ours.x - theirs.x, ours.y - theirs.y));
    turns.push_back(std::abs(ours.turn - theirs.turn));
  }
  expect_seven(rpe(kept_poses(), {}).statistics, lengths);
  RpeOptions options;
  options.relation = PoseRelation::angle_rad;
  expect_seven(rpe(kept_poses(), options).statistics, turns);
}

/// A log, its relations, and what the figures are over.
struct Recorded {
  Trajectory raw;
  Trajectory corrected;  ///< with the raw log's timestamps; empty where there is none
  std::vector<Relation> relations;
};

std::optional<Recorded> recorded(const std::string& name, const std::string& log,
                                 bool is_corrected) {
  const auto raw = test::shared_data("logs/" + name + "/" + log);
  const auto relations = test::shared_data("logs/" + name + "/" + name + ".relations");
  if (!raw || !relations) return std::nullopt;
  Recorded read;
  read.raw = read_trajectory(*raw, {}, LogPoses::recorded).poses;
  read.relations = read_relations(*relations);
  if (!is_corrected) return read;
  const auto corrected = test::shared_data("logs/" + name + "/" + name + ".gfs-corrected.log.gz");
  if (!corrected) return std::nullopt;
  const Trajectory poses = read_trajectory(*corrected, {}, LogPoses::recorded).poses;
  read.corrected = restamp(poses, read_clock(*raw)).trajectory;
  EXPECT_EQ(read.corrected.size(), poses.size());
  return read;
}

void expect_figures(const RelationErrors& errors, std::int64_t matched, double translation_m,
                    double rotation_deg, double within_m, double within_deg) {
  EXPECT_EQ(errors.matched, matched);
  EXPECT_NEAR(errors.all.translation_m.mean, translation_m, within_m);
  EXPECT_NEAR(errors.all.rotation_deg.mean, rotation_deg, within_deg);
}

TEST(RecordedLogs, Fr079HasItsKnownErrorsRawAndCorrected) {
  const auto log = recorded("fr079", "fr079.clf.gz", true);
  if (!log) return;
  expect_figures(relation_errors(log->raw, log->relations, {}), 1685, 6.504, 30.3, 0.0005, 0.05);
  expect_figures(
      relation_errors(log->corrected, log->relations, {30.0, {TimeMatch::interpolate, {}}}), 1685,
      0.058, 0.71, 0.0005, 0.005);
}

TEST(RecordedLogs, AcesHasItsKnownErrorsRawCorrectedAndCarried) {
  const auto log = recorded("aces", "aces.clf.gz", true);
  if (!log) return;
  expect_figures(relation_errors(log->raw, log->relations, {}), 1279, 0.549, 2.33, 0.0005, 0.005);
  const RelationErrors linear =
      relation_errors(log->corrected, log->relations, {30.0, {TimeMatch::interpolate, {}}});
  expect_figures(linear, 1274, 0.0705, 3.38, 0.00005, 0.005);
  EXPECT_NEAR(linear.coverage(), 0.996, 0.0005);
  const RelationErrors carried = relation_errors(log->corrected, log->relations, {}, &log->raw);
  expect_figures(carried, 1279, 0.049, 1.06, 0.0005, 0.005);
  EXPECT_GT(carried.use.carried, 2000);
}

TEST(RecordedLogs, MitKillianHasItsKnownErrorsByNearestStamp) {
  const auto log = recorded("mit-killian", "mit-killian.reconstructed.clf.gz", false);
  if (!log) return;
  const RelationErrors errors =
      relation_errors(log->raw, log->relations, {30.0, {TimeMatch::nearest, {}}});
  expect_figures(errors, 4677, 50.3, 9.3, 0.05, 0.05);
  EXPECT_LT(errors.use.largest_gap_s, 0.02);
}

TEST(RecordedLogs, Fr079sOptimisedGraphIsStampedByItsScansAndAgreesWithTheRelations) {
  const auto graph = test::shared_data("posegraphs/fr079_1464_with_scans.graph.gz");
  const auto relations = test::shared_data("logs/fr079/fr079.relations");
  if (!graph || !relations) return;
  const TrajectoryFile read = read_trajectory(*graph, {}, LogPoses::truth);
  EXPECT_EQ(read.clock, PoseClock::timestamps);
  EXPECT_EQ(read.poses.size(), 1464U);
  const RelationErrors errors = relation_errors(read.poses, read_relations(*relations), {});
  EXPECT_EQ(errors.matched, 136);  // most relations are between scans that the graph left out
  EXPECT_NEAR(errors.all.translation_m.mean, 0.04, 0.005);
  EXPECT_NEAR(errors.all.rotation_deg.mean, 0.5, 0.05);
}

}  // namespace
}  // namespace roomatlas
