// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_writer.hpp"
#include "bags/write_messages.hpp"

#include "roomatlas/io/logs/mission_writer.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace roomatlas::io {

/// A mission as a recording: /odom and tf odom -> base_link, /scan of all lasers, each with a frame
/// of its own (lasers that are one reading: /scan, /scan_2 ...), one /sonar_N a sonar,
/// /ground_truth, and the sensors' mounts in /tf_static before the first reading of each. A message
/// is recorded at its stamp, or where the log's clock was set back at the latest stamp before:
/// readers go by the times of recording, and would take the mission in another order.
///
/// Nothing within range is written as +Inf, no measurement as NaN (REP 117).
class MissionBag : public MissionWriter {
 public:
  /// @param file of the recording, for errors
  MissionBag(std::unique_ptr<BagWriter> bag, std::string file);
  using MissionWriter::write;
  /// Throws InputError for a time that a stamp cannot hold.
  void write(const OdometryStep& odometry) override;
  void write(const RangeReading& reading) override;
  void write(const TruePose& truth) override;
  void finish() override { bag_->finish(); }

 private:
  /// A sensor that has been met, and the frames of its beams: one of a laser.
  struct Met {
    RangeSensor sensor;
    std::vector<std::string> frames;
  };
  const Met& meet(const std::shared_ptr<const RangeSensor>& sensor, std::int64_t stamp_ns);
  [[nodiscard]] TransformsMessage mounts_of(const Met& met, std::int64_t stamp_ns) const;
  void write_scan(const RangeReading& reading, const Met& met, const std::string& topic,
                  std::int64_t stamp_ns);
  void write_sonars(const RangeReading& reading, const Met& met, std::int64_t stamp_ns);
  /// Adds the topic where it is new.
  void put(const std::string& topic, const char* type, std::int64_t stamp_ns,
           const Serializer& message);

  std::unique_ptr<BagWriter> bag_;
  std::string file_;
  BagEncoding encoding_;
  std::map<std::string, std::size_t> topics_;
  std::map<const RangeSensor*, std::size_t> known_;       ///< into `met_`
  std::vector<std::shared_ptr<const RangeSensor>> kept_;  ///< so that no address comes twice
  std::vector<std::unique_ptr<Met>> met_;
  std::int64_t recorded_ns_ = std::numeric_limits<std::int64_t>::min();  ///< the last message
  int lasers_ = 0;
  int rings_ = 0;
};

}  // namespace roomatlas::io
