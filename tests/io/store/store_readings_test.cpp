// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../src/io/store/readings_codec.hpp"
#include "io/store/store_samples.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace roomatlas {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Asr asr_with(std::vector<float> ranges, double max_range_m) {
  RangeSensor sensor;
  sensor.max_range_m = max_range_m;
  Asr asr;
  asr.readings.push_back(
      {1.5, {1, 2, 3}, std::make_shared<const RangeSensor>(sensor), std::move(ranges)});
  asr.path.push_back({1.5, {}, {1, 2, 3}});
  return asr;
}

std::vector<RangeReading> there_and_back(const Asr& asr) {
  const auto sensor = asr.readings.empty() ? nullptr : asr.readings.front().sensor;
  const PackedReadings packed = pack_readings(asr, [](const auto&) { return 7; });
  return unpack_readings(packed, asr.path, [&](std::int64_t id) {
    EXPECT_EQ(id, 7);
    return sensor;
  });
}

std::vector<float> ranges_back(const std::vector<float>& ranges, double max_range_m) {
  return there_and_back(asr_with(ranges, max_range_m)).at(0).ranges_m;
}

TEST(StoredReadings, RangesOfThreeDecimalsReadBackExactly) {
  const std::vector<float> ranges = {1.23f, 0.001f, 49.999f, 81.83f, 81.91f, 7.777f, 655.361f};
  EXPECT_EQ(ranges_back(ranges, 50.0), ranges);
}

TEST(StoredReadings, AnyRangeReadsBackToOneMillimetreAndKeepsItsKind) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0.0f, 12.0f);
  std::vector<float> ranges;
  for (int i = 0; i < 20000; ++i) ranges.push_back(uniform(random));
  for (const double max_range_m : {8.0, 5.00049, 3.0 / 7.0, 0.0}) {
    const std::vector<float> back = ranges_back(ranges, max_range_m);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      ASSERT_LT(std::abs(back[i] - ranges[i]), 1e-3f);
      ASSERT_EQ(back[i] > 0, ranges[i] > 0);
      ASSERT_EQ(back[i] >= max_range_m, ranges[i] >= max_range_m);
    }
  }
}

TEST(StoredReadings, RoundingTurnsNoEchoIntoAMissAndNoMissIntoAnEcho) {
  EXPECT_EQ(ranges_back({4.9997f}, 5.0), std::vector<float>{4.999f});
  EXPECT_EQ(ranges_back({5.0004f}, 5.0003), std::vector<float>{5.001f});
  EXPECT_EQ(ranges_back({5.0f, 0.0001f}, 5.0), (std::vector<float>{5.0f, 0.001f}));
}

TEST(StoredReadings, WhatIsNoMeasurementStaysWhatItWas) {
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  const auto back = ranges_back({nan, kInfinity, -kInfinity, 0.0f, -1.5f, -0.0001f, 1e30f}, 8.0);
  EXPECT_TRUE(std::isnan(back[0]));
  EXPECT_EQ(back[1], kInfinity);
  EXPECT_EQ(back[2], -kInfinity);
  EXPECT_EQ(back[3], 0.0f);
  EXPECT_EQ(back[4], -1.5f);
  EXPECT_EQ(back[5], -0.001f);
  EXPECT_GE(back[6], 1e8f);  // beyond any maximum
}

TEST(StoredReadings, StampsThatDifferFromThePathAreKept) {
  Asr asr = asr_with({1.0f}, 8.0);
  asr.path[0].timestamp_s = 99.0;
  EXPECT_EQ(there_and_back(asr)[0].timestamp_s, 1.5);
  EXPECT_EQ(there_and_back(asr)[0].odom_from_robot, (Pose2{1, 2, 3}));
  asr.path.clear();
  EXPECT_EQ(there_and_back(asr)[0].odom_from_robot, (Pose2{1, 2, 3}));
}

TEST(StoredReadings, ASteadyScanTakesAboutAByteABeam) {
  std::vector<float> ranges;
  for (int mm = 300; mm < 11100; mm += 3) ranges.push_back(static_cast<float>(mm) / 1000.0f);
  const PackedReadings packed =
      pack_readings(asr_with(ranges, 50.0), [](const auto&) { return 1; });
  EXPECT_LT(packed.raw_bytes, 3700);
  EXPECT_LT(packed.deflated.size(), 100u);
}

TEST(StoredReadings, DamageIsRefused) {
  const Asr asr = sample_asr(1);
  const auto sensor = asr.readings[0].sensor;
  const auto unpack = [&](const PackedReadings& packed) {
    return unpack_readings(packed, asr.path, [&](std::int64_t) { return sensor; });
  };
  const PackedReadings whole = pack_readings(asr, [](const auto&) { return 1; });
  EXPECT_EQ(unpack(whole).size(), asr.readings.size());
  PackedReadings cut = whole;
  cut.deflated.pop_back();
  EXPECT_THROW(unpack(cut), DamagedData);
  PackedReadings changed = whole;
  changed.deflated[changed.deflated.size() / 2] ^= 0x55;
  EXPECT_THROW(unpack(changed), DamagedData);
  PackedReadings swollen = whole;
  swollen.raw_bytes = std::int64_t{1} << 40;
  EXPECT_THROW(unpack(swollen), DamagedData);
  PackedReadings many = whole;
  many.count = std::int64_t{1} << 40;
  EXPECT_THROW(unpack(many), DamagedData);
}

}  // namespace
}  // namespace roomatlas
