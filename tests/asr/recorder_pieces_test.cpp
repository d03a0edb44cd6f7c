// SPDX-License-Identifier: GPL-3.0-or-later
// How the recorder cuts what is too long for one piece, and what it keeps in memory.
#include <gtest/gtest.h>

#include "asr/recorded.hpp"

namespace roomatlas {
namespace {

using namespace test;

/// 36 m of corridor without a door.
const WorldDrawing kCorridor = {std::string(122, '#'),
                                "#" + std::string(120, ' ') + "#",
                                "#" + std::string(120, ' ') + "#",
                                "#  a" + std::string(114, ' ') + "b #",
                                "#" + std::string(120, ' ') + "#",
                                "#" + std::string(120, ' ') + "#",
                                std::string(122, '#')};

const WorldDrawing kHall = {"####################",  //
                            "#                  #",  //
                            "#   b          a   #",  //
                            "#                  #",  //
                            "#                  #",  //
                            "#                  #",  //
                            "#                  #",  //
                            "#   c          d   #",  //
                            "#                  #",  //
                            "####################"};

TEST(RecorderPieces, CutsALongCorridorAtOpenPassagesOfAtMostTheOptionsLength) {
  for (const double max_m : {1.0, 5.0, 9.0}) {
    RecorderOptions options;
    options.max_piece_path_m = max_m;
    const auto readings = readings_in(kCorridor);
    const std::vector<Asr> asrs = recorded(readings, options);
    EXPECT_GE(static_cast<double>(asrs.size()) * max_m, 34.0);
    EXPECT_LE(static_cast<double>(asrs.size()), 2.0 * 34.0 / max_m);
    for (const Asr& asr : asrs) {
      EXPECT_LE(path_length_m(asr), max_m);
      for (const Exit& exit : asr.exits) {
        EXPECT_EQ(exit.kind, PassageKind::open_passage);
        EXPECT_EQ(exit.width_m, 0.0);
      }
    }
    expect_joined(asrs);
    expect_all_once_in_order(asrs, readings);
    expect_composes_to_odometry(asrs, 1e-9);
  }
}

TEST(RecorderPieces, CutsTheVisitOfARobotThatStandsStillByItsReadings) {
  RecorderOptions options;
  options.max_piece_readings = 40;
  auto readings = readings_in(kHall);
  readings.resize(1);
  for (int i = 1; i < 400; ++i) {
    readings.push_back(readings.front());
    readings.back().timestamp_s += i;
  }
  const std::vector<Asr> asrs = recorded(readings, options);
  expect_all_once_in_order(asrs, readings);
  expect_joined(asrs);
  for (const Asr& asr : asrs) EXPECT_LE(asr.path.size(), 40U);
  EXPECT_LE(asrs.size(), 20U) << "pieces of half the limit or more";
}

TEST(RecorderPieces, CutsByReadingsAgainAfterTheRobotHasMovedAndStands) {
  RecorderOptions options;
  options.max_piece_readings = 60;
  auto readings = readings_in(kHall);
  for (int i = 0; i < 600; ++i) readings.push_back(readings.back());
  const std::vector<Asr> asrs = recorded(readings, options);
  expect_all_once_in_order(asrs, readings);
  expect_joined(asrs);
  EXPECT_LE(asrs.size(), 3 * readings.size() / 60);
}

TEST(RecorderPieces, WorksWithTheSmallestLimitOfReadings) {
  RecorderOptions options;
  options.max_piece_readings = 1;
  auto readings = readings_in(kHall);
  readings.resize(10);
  expect_all_once_in_order(recorded(readings, options), readings);
}

/// Counts ASRs and forgets them.
struct CountingSink : AsrSink {
  void put(const Asr&) override { ++asrs; }
  void put(const TruePose&) override {}
  int asrs = 0;
};

TEST(RecorderPieces, HoldsNoReadingOfARoomThatIsFinished) {
  // Second route: every reading that is held anywhere holds its sensor too.
  Polyline laps;
  for (int lap = 0; lap < 6; ++lap) {
    for (const Point2& point : way_points_of(kHall)) laps.push_back(point);
  }
  std::vector<RangeReading> readings = readings_along(surfaces_of(kHall), laps);
  const std::weak_ptr<const RangeSensor> sensor = readings.front().sensor;
  RecorderOptions options;
  options.max_piece_path_m = 4.0;
  CountingSink sink;
  AsrRecorder recorder(options, {}, sink);
  long most_held = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    recorder.add(readings[i], readings[i].odom_from_robot);
    readings[i] = {};
    const auto waiting = static_cast<long>(readings.size() - i - 1);
    most_held = std::max(most_held, sensor.use_count() - waiting);
  }
  EXPECT_GT(sink.asrs, 10);
  EXPECT_LT(most_held, static_cast<long>(readings.size()) / 5);
  recorder.finish();
  EXPECT_EQ(sensor.use_count(), 0);
}

TEST(RecorderPieces, PlacesReadingsWhereTheLocalizerSaysAndKeepsTheFramesContinuous) {
  // Odometry says straight on; the localizer knows of a turn to the left, a little each reading.
  const double turn_rad = radians(0.05);
  std::vector<Pose2> predictions;
  const auto localizer = [&](const Pose2& predicted) {
    predictions.push_back(predicted);
    return predicted * Pose2{0.0, 0.0, turn_rad};
  };
  RecorderOptions options;
  options.max_piece_path_m = 6.0;
  const auto readings = readings_in(kCorridor);
  const std::vector<Asr> asrs =
      recorded(readings, options, std::make_unique<LocalizerBy>(localizer));
  ASSERT_GT(asrs.size(), 3U);
  EXPECT_EQ(predictions.size(), readings.size()) << "each reading is localised once";
  expect_all_once_in_order(asrs, readings);

  // Second route: chain the odometry steps with the turns from the start, and compare with the
  // ASRs chained at their passages.
  Pose2 expected = Pose2{} * Pose2{0.0, 0.0, turn_rad};
  Pose2 start_from_asr;
  std::size_t next = 0;
  for (std::size_t k = 0; k < asrs.size(); ++k) {
    for (const PathSample& sample : asrs[k].path) {
      if (next > 0) {
        expected = expected *
                   (inverse(readings[next - 1].odom_from_robot) * readings[next].odom_from_robot) *
                   Pose2{0.0, 0.0, turn_rad};
      }
      expect_near(start_from_asr * sample.asr_from_robot, expected, 1e-9);
      ++next;
    }
    if (k + 1 < asrs.size()) {
      start_from_asr = start_from_asr * asrs[k].exits.back().frame_from_pivot;
    }
  }
}

TEST(RecorderPieces, PutsAFrameWhereOdometryHasItNowWhenTheLocalizerHasCorrectedOdometry) {
  const auto localizer = [](const Pose2& predicted) {
    return predicted * Pose2{0.0, 0.0, radians(0.05)};
  };
  RecorderOptions options;
  options.max_piece_path_m = 6.0;
  const std::vector<Asr> asrs =
      recorded(readings_in(kCorridor), options, std::make_unique<LocalizerBy>(localizer));
  ASSERT_GT(asrs.size(), 3U);
  for (std::size_t k = 1; k < asrs.size(); ++k) {
    const PathSample& last = asrs[k - 1].path.back();
    const Pose2 odom_from_former = last.odom_from_robot * inverse(last.asr_from_robot);
    expect_near(asrs[k].odom_from_asr, odom_from_former * asrs[k - 1].exits.back().frame_from_pivot,
                1e-9);
  }
}

TEST(RecorderPieces, FollowsABetterOdometryThanTheLogs) {
  // The log counts a drive back as a drive on; the reckoned poses know better.
  const auto readings = readings_in(kCorridor);
  MemoryStore store;
  AsrRecorder recorder({}, {}, store);
  for (const RangeReading& reading : readings) {
    const Pose2 odom = reading.odom_from_robot;
    recorder.add(reading, {-odom.x_m, odom.y_m, odom.theta_rad});
  }
  recorder.finish();
  ASSERT_FALSE(store.asrs.empty());
  Pose2 first_from_asr;
  const double start_m = readings.front().odom_from_robot.x_m;
  for (const Asr& asr : store.asrs) {
    for (const PathSample& sample : asr.path) {
      EXPECT_NEAR((first_from_asr * sample.asr_from_robot).x_m,
                  start_m - sample.odom_from_robot.x_m, 1e-9);
    }
    first_from_asr = first_from_asr * asr.exits.back().frame_from_pivot;
  }
}

}  // namespace
}  // namespace roomatlas
