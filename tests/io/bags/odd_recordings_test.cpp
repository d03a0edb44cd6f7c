// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that hold too little, too much or nonsense, from the file to the mission.
#include "bags/bag_writers.hpp"
#include "bags/mission_bag.hpp"
#include "io/bags/memory_bag.hpp"
#include "io/bags/small_mission.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace roomatlas::test {
namespace {

const std::vector<std::string> kOddRecordings = {"m.bag", "m.mcap", "m.db3"};

/// What a file gives: its readings, or minus one where it is refused as a user is to be told.
std::int64_t readings_in(const Path& file) {
  try {
    return static_cast<std::int64_t>(read_log(file).readings.size());
  } catch (const InputError& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("m."), std::string::npos) << refusal.what();
  } catch (const NotEnoughError&) {
  }
  return -1;
}

TEST(OddRecording, CutAnywhereItGivesWhatIsLeftOrIsRefused) {
  const TemporaryFolder folder;
  const std::vector<SimulatedStep> steps = mission_of(SensorKind::laser);
  for (const std::string& name : kOddRecordings) {
    write(folder / name, steps);
    const std::string whole = bytes_of(folder / name);
    std::int64_t before = -1;
    for (std::size_t part = 0; part <= 40; ++part) {
      folder.write(name, whole.substr(0, whole.size() * part / 40));
      const std::int64_t readings = readings_in(folder / name);
      if (name != "m.db3") {
        EXPECT_GE(readings, before) << name << " " << part;
      }
      before = readings;
    }
    EXPECT_EQ(before, static_cast<std::int64_t>(steps.size())) << name;
  }
}

TEST(OddRecording, FlippedBytesAreNoMoreThanAnError) {
  constexpr int kTries = 300;
  const TemporaryFolder folder;
  std::vector<SimulatedStep> steps = mission_of(SensorKind::laser);
  steps.resize(20);
  std::mt19937 random(7);
  for (const std::string& name : kOddRecordings) {
    write(folder / name, steps);
    const std::string whole = bytes_of(folder / name);
    int read = 0;
    for (int i = 0; i < kTries; ++i) {
      std::string damaged = whole;
      for (int flips = 1 + i % 3; flips > 0; --flips) {
        damaged[random() % damaged.size()] = static_cast<char>(random());
      }
      folder.write(name, damaged);
      if (readings_in(folder / name) > 0) ++read;
    }
    EXPECT_GT(read, kTries / 20) << name;  // what is refused is not all
  }
}

/// Unpacked, so that the flips are in messages, of which no checksum tells.
TEST(OddRecording, FlippedBytesInMessagesAreNoMoreThanAnError) {
  constexpr int kTries = 500;
  const TemporaryFolder folder;
  std::vector<SimulatedStep> steps = mission_of(SensorKind::sonar);
  steps.resize(20);
  {
    io::MissionBag bag(io::create_ros1_bag(folder / "m.bag", io::Packing::none), "m.bag");
    for (const SimulatedStep& step : steps) static_cast<MissionWriter&>(bag).write(step);
    bag.finish();
  }
  const std::string whole = bytes_of(folder / "m.bag");
  std::mt19937 random(8);
  int read = 0;
  for (int i = 0; i < kTries; ++i) {
    std::string damaged = whole;
    for (int flips = 0; flips < 1 + i % 30; ++flips) {
      damaged[4096 + random() % (damaged.size() - 4096)] = static_cast<char>(random());
    }
    folder.write("m.bag", damaged);
    if (readings_in(folder / "m.bag") > 0) ++read;
  }
  EXPECT_GT(read, kTries / 4);
}

/// Topics by the hundred thousand, of which four are a mission.
void write_many_topics(const Path& file, int topics, const std::vector<SimulatedStep>& steps) {
  class Crowded : public io::BagWriter {
   public:
    Crowded(std::unique_ptr<io::BagWriter> bag, int topics) : bag_(std::move(bag)) {
      const io::BagEncoding encoding =
          bag_->takes(io::BagEncoding::cdr) ? io::BagEncoding::cdr : io::BagEncoding::ros1;
      const std::vector<std::byte> bytes(12);
      for (int i = 0; i < topics; ++i) {
        const auto topic = bag_->add_topic(
            {"/t" + std::to_string(i), "std_msgs/String", encoding, "string data\n", {}});
        bag_->write(topic, 1'700'000'000'000'000'000, bytes);
      }
    }
    [[nodiscard]] bool takes(io::BagEncoding e) const override { return bag_->takes(e); }
    std::size_t add_topic(const io::BagTopic& topic) override { return bag_->add_topic(topic); }
    void write(std::size_t topic, std::int64_t time_ns, std::span<const std::byte> b) override {
      bag_->write(topic, time_ns, b);
    }
    void finish() override { bag_->finish(); }

   private:
    std::unique_ptr<io::BagWriter> bag_;
  };
  io::MissionBag bag(std::make_unique<Crowded>(io::create_bag(file), topics), file.string());
  for (const SimulatedStep& step : steps) static_cast<MissionWriter&>(bag).write(step);
  bag.finish();
}

TEST(OddRecording, OfManyTopicsIsReadAllTheSame) {
  const TemporaryFolder folder;
  const std::vector<SimulatedStep> steps = mission_of(SensorKind::laser);
  for (const auto& [name, topics] : std::vector<std::pair<std::string, int>>{
           {"m.bag", 200'000}, {"m.db3", 50'000}, {"m.mcap", 65'000}}) {
    write_many_topics(folder / name, topics, steps);
    const ReadLog log = read_log(folder / name);
    EXPECT_EQ(log.readings.size(), steps.size()) << name;
    EXPECT_EQ(log.info.recording->topics.size(), static_cast<std::size_t>(topics) + 5) << name;
  }
}

/// What is thrown for a recording; empty where nothing is.
std::string refusal_of(const MemoryBag& bag, const MissionOptions& options = {}) {
  try {
    (void)read_bag(bag, options);
  } catch (const NotEnoughError& error) {
    return std::string("not enough: ") + error.what();
  } catch (const InputError& error) {
    return std::string("input: ") + error.what();
  }
  return "";
}

bool has_words(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(OddRecording, WithoutScansIsToldWhatIsThere) {
  MemoryBag odometry;
  for (int i = 0; i < 50; ++i) odometry.odometry(100.0 + 0.1 * i, {0.1 * i, 0, 0});
  const std::string refusal = refusal_of(odometry);
  EXPECT_TRUE(has_words(refusal, "not enough: ")) << refusal;
  EXPECT_TRUE(has_words(refusal, "/odom (nav_msgs/Odometry)")) << refusal;

  MemoryBag unknown = odometry;
  unknown.add("/laser", "acme_msgs/LaserSweep", 100.0, std::vector<std::byte>(100));
  const std::string nearest = refusal_of(unknown);
  EXPECT_TRUE(has_words(nearest, "/laser (acme_msgs/LaserSweep): its type is not read")) << nearest;

  MemoryBag silent = odometry;
  silent.topics.push_back({"/scan", "sensor_msgs/LaserScan", io::BagEncoding::ros1, "", 0});
  const std::string no_message = refusal_of(silent);
  EXPECT_TRUE(has_words(no_message, "/scan (sensor_msgs/LaserScan): no message was seen"))
      << no_message;
  EXPECT_TRUE(has_words(refusal_of(MemoryBag{}), "no topics at all"));
}

TEST(OddRecording, OfScansThatAreTooShortIsToldWhy) {
  MemoryBag bag;
  for (int i = 0; i < 50; ++i) {
    bag.odometry(100.0 + 0.1 * i, {0.1 * i, 0, 0});
    bag.add("/scan", "sensor_msgs/LaserScan", 100.0 + 0.1 * i, std::vector<std::byte>(17));
  }
  const std::string refusal = refusal_of(bag);
  EXPECT_TRUE(has_words(refusal, "too short for their type")) << refusal;
}

TEST(OddRecording, WithoutStampsGoesByTheTimesOfRecording) {
  MemoryBag bag;
  bag.tf(99.0, {{"base_link", "laser", {}}}, "/tf_static");
  for (int i = 0; i < 50; ++i) {
    const double time_s = 100.0 + 0.1 * i;
    bag.add("/odom", "nav_msgs/Odometry", time_s, odometry_bytes(0.0, {0.1 * i, 0, 0}));
    bag.add("/scan", "sensor_msgs/LaserScan", time_s, scan_bytes({}));
  }
  const ReadLog log = read_bag(bag);
  ASSERT_EQ(log.readings.size(), 50U);
  EXPECT_TRUE(is_told(log, "stamps are zero"));
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_NEAR(log.readings[i].timestamp_s, 100.0 + 0.1 * static_cast<double>(i), 1e-6);
    EXPECT_NEAR(log.readings[i].odom_from_robot.x_m, 0.1 * static_cast<double>(i), 1e-6);
  }
}

TEST(OddRecording, OutOfOrderHasItsPosesSortedAndItsStepsBackCounted) {
  MemoryBag bag;
  bag.tf(99.0, {{"base_link", "laser", {}}}, "/tf_static");
  for (int i = 0; i < 60; ++i) {
    const int swapped = i ^ 1;  // 1, 0, 3, 2 ...
    ScanFields scan;
    scan.stamp_s = 100.0 + 0.1 * swapped;
    const double log_s = 100.2 + 0.1 * i;
    bag.add("/odom", "nav_msgs/Odometry", log_s,
            odometry_bytes(scan.stamp_s, {0.1 * swapped, 0, 0}));
    bag.scan(log_s, scan);
  }
  const ReadLog log = read_bag(bag);
  EXPECT_EQ(log.readings.size(), 60U);
  EXPECT_EQ(log.info.steps_back_in_time, 2 * 30);  // of scans and of odometry
  EXPECT_TRUE(is_told(log, "came out of order and were sorted"));
  for (const RangeReading& reading : log.readings) {
    EXPECT_NEAR(reading.odom_from_robot.x_m, reading.timestamp_s - 100.0, 1e-6);
  }
}

TEST(OddRecording, TruthOfAnotherPartOfTheRobotIsJoinedByTf) {
  MemoryBag bag;
  const Pose2 base_from_prism{0.3, -0.1, kPi / 2};
  bag.tf(99.0, {{"base_link", "laser", {}}, {"base_link", "prism", base_from_prism}}, "/tf_static");
  for (int i = 0; i < 20; ++i) {
    const double time_s = 100.0 + 0.1 * i;
    const Pose2 world_from_base{2.0 + 0.1 * i, 1.0, 0.05 * i};
    bag.odometry(time_s, {0.1 * i, 0, 0}).scan(time_s, {});
    MessageBytes out(Layout::ros1);
    const Pose2 seen = world_from_base * base_from_prism;
    out.header(time_s, "map").text("prism").pose(seen.x_m, seen.y_m, 0.4, 0.0, seen.theta_rad);
    bag.add("/total_station", "geometry_msgs/TransformStamped", time_s, out.bytes);
  }
  MissionOptions options;
  EXPECT_TRUE(read_bag(bag, options).true_poses.empty());  // its name does not say what it is
  options.recording.truth_topic = "/total_station";
  const ReadLog log = read_bag(bag, options);
  ASSERT_EQ(log.true_poses.size(), 20U);
  for (int i = 0; i < 20; ++i) {
    const TruePose& truth = log.true_poses[static_cast<std::size_t>(i)];
    EXPECT_NEAR(truth.world_from_robot.x_m, 2.0 + 0.1 * i, 1e-9);
    EXPECT_NEAR(truth.world_from_robot.y_m, 1.0, 1e-9);
    EXPECT_NEAR(truth.world_from_robot.theta_rad, 0.05 * i, 1e-9);
  }
}

TEST(OddRecording, ASimulatorsTruthIsNotTakenForOdometry) {
  MemoryBag bag;
  bag.tf(99.0, {{"base_link", "laser", {}}}, "/tf_static");
  for (int i = 0; i < 20; ++i) {
    const double time_s = 100.0 + 0.1 * i;
    bag.scan(time_s, {}).odometry(time_s, {0.1 * i, 0.5, 0}, "/ground_truth/state");
    if (i % 5 == 0) bag.odometry(time_s, {0.1 * i, 0, 0});
  }
  const ReadLog log = read_bag(bag);
  EXPECT_EQ(log.info.odometry, "/odom");
  EXPECT_EQ(log.true_poses.size(), 20U);
  MissionOptions without;
  without.recording.truth_topic = "none";
  EXPECT_TRUE(read_bag(bag, without).true_poses.empty());
}

}  // namespace
}  // namespace roomatlas::test
