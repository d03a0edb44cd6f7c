// SPDX-License-Identifier: GPL-3.0-or-later
// Readings matched once more where the correction puts them, on a mission whose truth is known.
#include "roomatlas/loops/feed_back.hpp"

#include <gtest/gtest.h>

#include "pipeline/three_rounds.hpp"
#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/pipeline/assemble.hpp"

namespace roomatlas {
namespace {

using namespace test;

/// Three times round eight rooms and a corridor.
struct Mission {
  MemoryStore store;
  Assembly assembly;
  std::vector<AsrShape> shapes;
  Placement placement;
};

const Mission& mission() {
  static const Mission result = [] {
    Mission made;
    made.store = mapped(three_rounds(OdometryPreset::typical));
    made.assembly = assemble(made.store, {}, {});
    for (const Asr& asr : made.store.asrs) made.shapes.push_back(shape_of(asr, {}, {}));
    made.placement = placement_of(made.assembly.correction);
    return made;
  }();
  return result;
}

double error_m(const AsrSource& source) {
  return rmse_m(mission().store, place(source, mission().assembly.correction).corrected);
}

Paths fed_back(const AsrSource& source) {
  return feed_back(source, mission().shapes, mission().assembly.closures, mission().placement, {});
}

TEST(FeedBack, BringsThePathNearerToTheTruth) {
  const Paths& paths = mission().assembly.paths;
  ASSERT_EQ(paths.size(), mission().store.asrs.size());
  EXPECT_LT(error_m(WithPaths(mission().store, paths)), 0.95 * error_m(mission().store));
}

TEST(FeedBack, IsWhatAssembleDoes) {
  EXPECT_EQ(fed_back(mission().store), mission().assembly.paths);
  Options off;
  off.assemble.feed_back.enabled = false;
  EXPECT_TRUE(assemble(mission().store, {}, off).paths.empty());
}

/// The mission with every reading of one ASR's path moved.
MemoryStore moved(std::size_t asr, const Pose2& by) {
  MemoryStore store = mission().store;
  for (PathSample& sample : store.asrs[asr].path) {
    sample.asr_from_robot = sample.asr_from_robot * by;
  }
  return store;
}

double largest_m(const std::vector<Pose2>& path, const std::vector<PathSample>& other) {
  double largest = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Point2 off = path[i].position() - other[i].asr_from_robot.position();
    largest = std::max(largest, off.norm());
  }
  return largest;
}

TEST(FeedBack, FindsBackAPathThatWasMoved) {
  const MemoryStore store = moved(3, {0.06, -0.05, radians(1.5)});
  const std::vector<PathSample>& was = mission().store.asrs[3].path;
  const std::vector<Pose2> found = fed_back(store).at(store.asrs[3].id);
  ASSERT_EQ(found.size(), was.size());
  EXPECT_GT(largest_m(fed_back(mission().store).at(store.asrs[3].id), store.asrs[3].path), 0.06);
  EXPECT_LT(largest_m(found, was), 0.04);
}

TEST(FeedBack, LeavesAReadingThatFitsNowhere) {
  const MemoryStore store = moved(3, {50.0, 0.0, 0.0});
  EXPECT_EQ(largest_m(fed_back(store).at(store.asrs[3].id), store.asrs[3].path), 0.0);
}

TEST(FeedBack, KeepsAllButThePaths) {
  const WithPaths with(mission().store, mission().assembly.paths);
  EXPECT_EQ(with.ids(), mission().store.ids());
  const Asr geometry = with.get(3, AsrDetail::geometry);
  EXPECT_TRUE(geometry.path.empty());
  const Asr asr = with.get(3, AsrDetail::path);
  const Asr was = mission().store.get(3, AsrDetail::path);
  for (std::size_t i = 0; i < asr.path.size(); ++i) {
    EXPECT_EQ(asr.path[i].asr_from_robot, mission().assembly.paths.at(3)[i]);
    EXPECT_EQ(asr.path[i].odom_from_robot, was.path[i].odom_from_robot);
    EXPECT_EQ(asr.path[i].timestamp_s, was.path[i].timestamp_s);
  }
}

}  // namespace
}  // namespace roomatlas
