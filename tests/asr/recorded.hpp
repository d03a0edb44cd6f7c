// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every recording, whatever was driven.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "roomatlas/asr/recorder.hpp"
#include "support/drawn_world.hpp"
#include "support/memory_store.hpp"

namespace roomatlas::test {

/// A localizer from a function of the predicted pose.
class LocalizerBy : public Localizer {
 public:
  using Function = std::function<Pose2(const Pose2& predicted)>;
  explicit LocalizerBy(Function function) : function_(std::move(function)) {}
  void clear() override {}
  void add(const RangeReading&, const Pose2&) override {}
  Pose2 locate(const RangeReading&, const Pose2& predicted, const Pose2&) override {
    return function_(predicted);
  }
  [[nodiscard]] bool localizes(const RangeReading& reading) const override {
    return can_be_matched(reading);
  }

 private:
  Function function_;
};

inline std::vector<Asr> recorded(const std::vector<RangeReading>& readings,
                                 const RecorderOptions& options,
                                 std::unique_ptr<Localizer> localizer = nullptr) {
  MemoryStore store;
  AsrRecorder recorder(options, {}, store, std::move(localizer));
  for (const RangeReading& reading : readings) recorder.add(reading, reading.odom_from_robot);
  recorder.finish();
  EXPECT_EQ(recorder.asrs_written(), static_cast<std::int64_t>(store.asrs.size()));
  return store.asrs;
}

inline void expect_near(const Pose2& a, const Pose2& b, double tolerance) {
  EXPECT_NEAR(a.x_m, b.x_m, tolerance);
  EXPECT_NEAR(a.y_m, b.y_m, tolerance);
  EXPECT_NEAR(wrap_angle(a.theta_rad - b.theta_rad), 0.0, tolerance);
}

/// The exit of each ASR and the entry of the next are one passage, seen from its two sides.
inline void expect_joined(const std::vector<Asr>& asrs) {
  for (std::size_t i = 0; i + 1 < asrs.size(); ++i) {
    ASSERT_FALSE(asrs[i].exits.empty());
    ASSERT_FALSE(asrs[i + 1].exits.empty());
    const Exit& exit = asrs[i].exits.back();
    const Exit& entry = asrs[i + 1].exits.front();
    EXPECT_FALSE(exit.is_entry);
    EXPECT_TRUE(entry.is_entry);
    EXPECT_EQ(exit.neighbor, asrs[i + 1].id);
    EXPECT_EQ(entry.neighbor, asrs[i].id);
    EXPECT_EQ(exit.kind, entry.kind);
    EXPECT_EQ(exit.width_m, entry.width_m);
    EXPECT_EQ(exit.timestamp_s, entry.timestamp_s);
    expect_near(asrs[i].odom_from_asr * exit.frame_from_pivot, asrs[i + 1].odom_from_asr, 1e-9);
    expect_near(entry.frame_from_pivot, {0.0, 0.0, wrap_angle(kPi)}, 1e-9);
    const Segment2 left = transformed(asrs[i].odom_from_asr, exit.jambs);
    const Segment2 entered = transformed(asrs[i + 1].odom_from_asr, entry.jambs);
    EXPECT_LT((left.a - entered.b).norm(), 1e-9) << "left on one side is right on the other";
    EXPECT_LT((left.b - entered.a).norm(), 1e-9);
  }
}

inline void expect_all_once_in_order(const std::vector<Asr>& asrs,
                                     const std::vector<RangeReading>& readings) {
  std::size_t next = 0;
  for (const Asr& asr : asrs) {
    ASSERT_FALSE(asr.path.empty());
    EXPECT_EQ(asr.start_s, asr.path.front().timestamp_s);
    EXPECT_EQ(asr.end_s, asr.path.back().timestamp_s);
    ASSERT_EQ(asr.readings.size(), asr.path.size());
    for (std::size_t i = 0; i < asr.path.size(); ++i, ++next) {
      ASSERT_LT(next, readings.size());
      EXPECT_EQ(asr.path[i].timestamp_s, readings[next].timestamp_s);
      EXPECT_EQ(asr.path[i].odom_from_robot, readings[next].odom_from_robot);
      EXPECT_EQ(asr.readings[i].timestamp_s, readings[next].timestamp_s);
      EXPECT_EQ(asr.readings[i].ranges_m, readings[next].ranges_m);
    }
  }
  EXPECT_EQ(next, readings.size());
}

inline void expect_composes_to_odometry(const std::vector<Asr>& asrs, double tolerance) {
  for (const Asr& asr : asrs) {
    for (const PathSample& sample : asr.path) {
      expect_near(asr.odom_from_asr * sample.asr_from_robot, sample.odom_from_robot, tolerance);
    }
  }
}

}  // namespace roomatlas::test
