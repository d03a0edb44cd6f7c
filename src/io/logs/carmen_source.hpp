// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "carmen_message.hpp"
#include "carmen_parameters.hpp"
#include "event_queue.hpp"
#include "left_out_lines.hpp"
#include "odometry_track.hpp"
#include "sensor_catalog.hpp"
#include "spike_filter.hpp"
#include "text/line_reader.hpp"

#include "roomatlas/mission/mission.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace roomatlas::io {

/// A CARMEN log as a mission, streaming.
///
/// Where a reading's robot pose comes from:
/// - the pose in the scan line holds where there is one;
/// - pose slots that are all zero hold only once a scan of the log has had other values: a log
///   whose scans are all zero left the slots empty;
/// - everything else (SONAR, RAWLASER, empty slots) is interpolated between the ODOM lines around
///   it in the file, or between the poses of scans in a log without ODOM lines; beyond the last
///   one its pose stays. With no odometry in reach the pose is the origin, and an issue says so.
///
/// A pose that jumps away and back with the next one of its tag is left out with its line.
///
/// The first message decides whether a log has times. In one without, a reading's timestamp is its
/// number, from 0, and a true pose has the number of the readings before it. Timestamps stay as
/// they are: `steps_back_in_time` counts, per tag, lines older than the line before.
///
/// `path_length_m` is along the poses of the first tag that has poses in its scans, else along the
/// ODOM lines.
class CarmenSource : public MissionSource {
 public:
  CarmenSource(const std::filesystem::path& file, const MissionOptions& options);
  CarmenSource(const CarmenSource&) = delete;  // the catalog writes into this object's info
  CarmenSource& operator=(const CarmenSource&) = delete;

  [[nodiscard]] std::optional<MissionEvent> next() override;
  [[nodiscard]] const MissionInfo& info() const override { return info_; }
  [[nodiscard]] double progress() const override { return reader_.progress(); }

 private:
  /// What was seen of one tag.
  struct TagState {
    std::optional<double> last_timestamp_s;
    int trailing_fields = 0;
    bool has_poses = false;
  };

  void read_first_message(const std::string& name);
  bool read_line();
  void read_message(const CarmenTag& tag, std::string_view line);
  void report_cut();
  [[nodiscard]] bool is_cut_off(const CarmenTag& tag, bool malformed) const;

  /// Uses the messages that need not wait any longer. False where there is none.
  bool use_decided();
  void use_message();
  void use_odometry(double timestamp_s);
  void use_scan(double timestamp_s);
  void use_scan_pose(double timestamp_s);
  void use_parameter();
  /// The message's timestamp as this log counts; nothing when a line of a log with times has none.
  [[nodiscard]] std::optional<double> timestamp_of_message();
  void note_state(double timestamp_s);
  void note_odd_scan();
  [[nodiscard]] MissionEvent hand_out(EventQueue::Taken taken);

  void count_ignored(std::string_view tag);
  void add_malformed(std::string_view tag, const CarmenProblem& problem);
  void add_issue(Severity severity, std::string field, std::string message);

  MissionInfo info_;
  LineReader reader_;
  SensorCatalog catalog_;
  CarmenParameters parameters_;
  CarmenMessage message_;  ///< the one at work
  std::int64_t line_ = 0;  ///< at work, for issues
  SpikeFilter<CarmenMessage> spikes_;
  LeftOutLines left_out_;
  OdometryTrack track_;
  EventQueue queue_;
  std::map<const CarmenTag*, TagState> tags_;

  bool ended_ = false;
  bool cut_reported_ = false;
  std::optional<bool> has_times_;  ///< decided by the first message
  bool scans_have_poses_ = false;  ///< some scan had a pose other than zero
  bool origin_reported_ = false;
  bool cone_reported_ = false;
  bool directions_reported_ = false;
  bool times_reported_ = false;
  const CarmenTag* path_tag_ = nullptr;  ///< whose poses make up the path
  std::optional<Pose2> last_odometry_;
  std::optional<Pose2> last_path_scan_;
  double odometry_path_m_ = 0.0;
  double scan_path_m_ = 0.0;
};

}  // namespace roomatlas::io
