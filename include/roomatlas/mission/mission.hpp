// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace roomatlas {

enum class SensorKind { laser, sonar };

/// A set of beams that are read together: a laser scanner or a ring of sonars.
struct RangeSensor {
  SensorKind kind = SensorKind::laser;
  std::vector<Pose2> robot_from_beam;  ///< origin and direction of each beam in the robot's frame
  double half_cone_rad = 0.0;          ///< half the opening angle of one beam, [0, pi/2)
  double max_range_m = 0.0;            ///< readings at or beyond it are "no echo": free space
};

/// One sweep of one sensor, with the robot's odometry pose at that time.
struct RangeReading {
  double timestamp_s = 0.0;  ///< as in the log, or the reading's number where the log has no times
  Pose2 odom_from_robot;     ///< the robot's pose, never the sensor's
  std::shared_ptr<const RangeSensor> sensor;  ///< never null
  std::vector<float> ranges_m;  ///< one a beam; NaN, infinite or <= 0 means "no measurement"
  /// From the first beam to the last, of a sweep that is as it was measured, for who knows how the
  /// robot moved in it; negative: the last came first. 0: all at once, or put to the one pose.
  double sweep_s = 0.0;
};

/// Ground truth, where a log has it (CARMEN's TRUEPOS).
struct TruePose {
  double timestamp_s = 0.0;
  Pose2 world_from_robot;
};

using MissionEvent = std::variant<RangeReading, TruePose>;

struct RobotFootprint {
  double length_m = 0.45;  ///< larger frees walls that the robot drove along ...
  double width_m = 0.40;   ///< ... and jambs of doors that it went through
};

/// A laser read as if it were a ring of sonars, and how much worse than exact that ring is.
struct AsSonarOptions {
  bool enabled = false;
  double range_noise_m = 0.0;        ///< standard deviation
  double specular_limit_deg = 90.0;  ///< beyond this angle of incidence a wall gives no echo
  double dropout_share = 0.0;        ///< cones that lose their reading at random, [0, 1]
  std::uint64_t seed = 1;            ///< decides noise and losses
};

/// Of a recording of topics (a bag), what is taken from it. Empty: chosen by what the recording
/// shows. Lists are names of topics, separated by commas.
struct RecordingOptions {
  std::string scan_topics;     ///< lasers or point clouds; several are mapped together
  std::string odometry_topic;  ///< a topic, "tf", or "none": mapped by scan matching alone
  std::string odometry_frame;  ///< in which odometry's poses are; "odom" in most recordings
  std::string base_frame;      ///< the robot; sensors' mounts are told from it
  std::string imu_topic;       ///< whose gyro tells the turns; "none"
  std::string range_topics;    ///< single sonars, mapped as one ring
  std::string truth_topic;     ///< poses of the robot to compare with; "tf": its root frame; "none"
  std::string laser_mount;     ///< "x,y,deg": where the laser sits, instead of what tf says
  double cloud_low_m = 0.1;   ///< of a 3-D cloud, points above the base frame's plane from here ...
  double cloud_high_m = 1.5;  ///< ... to here are walls. Wider takes floor and lamps for walls
};

/// What the log does not say. Where it does, the log wins.
struct MissionOptions {
  double laser_max_range_m = 50.0;  ///< at or beyond: no echo. Lower drops far walls
  double sonar_max_range_m = 5.0;   ///< at or beyond: no echo
  double sonar_cone_deg = 30.0;     ///< full opening angle; wider trusts bearings less
  RobotFootprint footprint;         ///< cells under it are marked as robot path
  AsSonarOptions as_sonar;          ///< thins lasers to what a sonar robot would have heard
  RecordingOptions recording;       ///< which topics of a bag, and how they are read
};

/// A topic of a recording.
struct RecordedTopic {
  std::string name;
  std::string type;
  std::optional<std::int64_t> messages;  ///< none: the recording has no index that says so
  double rate_hz = 0.0;                  ///< 0: not known
  std::vector<std::string> frames;       ///< of its headers, where they were looked at
  std::string use;                       ///< "laser", "odometry" ...; empty: not used
};

/// An edge of a recording's tree of coordinate frames.
struct RecordedFrame {
  std::string parent;
  std::string child;
  bool is_fixed = false;
  std::int64_t transforms = 0;
};

/// What is in a recording of topics.
struct RecordingInfo {
  std::vector<RecordedTopic> topics;  ///< by name
  std::vector<RecordedFrame> frames;  ///< by the child's name
  std::string choice;                 ///< what is mapped, in one line
  std::string base_frame;
  std::string odometry_frame;  ///< empty without odometry
  std::string gyro_topic;      ///< whose gyro tells the turns; empty: none does
};

/// Summary of what has been read so far.
struct MissionInfo {
  std::string file;
  std::string format;                                       ///< "CARMEN"
  std::map<std::string, std::int64_t> line_counts;          ///< lines by tag, those that were read
  std::map<std::string, std::int64_t> ignored_line_counts;  ///< lines by unknown tag
  std::int64_t readings = 0;                                ///< range readings handed out
  std::int64_t true_poses = 0;
  std::int64_t malformed_lines = 0;
  std::int64_t steps_back_in_time = 0;
  double path_length_m = 0.0;  ///< along odometry
  std::optional<double> first_timestamp_s;
  std::optional<double> last_timestamp_s;
  bool has_times = true;  ///< false: readings are indexed by their number
  std::string odometry;   ///< "ODOM lines", "poses in scans" or "none"
  RobotFootprint footprint;
  std::vector<std::shared_ptr<const RangeSensor>> sensors;  ///< in order of appearance
  Issues issues;                                            ///< the first hundred, then counted
  std::int64_t issues_not_listed = 0;
  std::optional<RecordingInfo> recording;  ///< of a bag
};

/// A mission as a stream, in file order. Memory does not grow with its length.
class MissionSource {
 public:
  virtual ~MissionSource() = default;
  /// The next event; nothing at the end.
  [[nodiscard]] virtual std::optional<MissionEvent> next() = 0;
  [[nodiscard]] virtual const MissionInfo& info() const = 0;
  /// Share of the input consumed, [0, 1].
  [[nodiscard]] virtual double progress() const = 0;
};

}  // namespace roomatlas
