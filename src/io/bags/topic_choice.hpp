// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/survey.hpp"

#include "roomatlas/mission/mission.hpp"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace roomatlas::io {

/// A gyro whose turns are taken for odometry's.
struct GyroChoice {
  std::size_t topic = 0;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< the robot's vertical, in the gyro's axes
  double drift_rad_per_s = 0.0;                   ///< about it, in the recording's beginning
};

/// Which topics of a recording are the mission, and what their frames are.
struct TopicChoice {
  std::vector<std::size_t> scans;   ///< lasers or clouds
  bool is_one_reading = false;      ///< sweeps of all lasers, those nearest in time
  std::int64_t half_period_ns = 0;  ///< of the first laser's sweeps
  /// 1: a laser's beams were measured one after the other as its messages say; -1: the other way
  /// round; 0: at once, or it is not known.
  double beam_order = 1.0;
  std::vector<std::size_t> ranges;  ///< single sonars; none where there is a laser
  enum class Odometry { none, topic, transforms };
  Odometry odometry = Odometry::none;
  std::size_t odometry_topic = 0;  ///< where it is a topic
  std::string odometry_frame;
  std::string odometry_child;  ///< whose poses odometry tells: the base frame, or joined to it
  std::string base_frame;
  std::optional<Pose2> mount;      ///< of the laser, where no tf tells it and sweeps do
  std::vector<std::size_t> gyros;  ///< not judged yet
  std::optional<GyroChoice> gyro;
  std::optional<std::size_t> truth;     ///< a topic of poses
  std::string truth_frame;              ///< tf's root frame, where truth is tf; else empty
  bool use_log_times = false;           ///< stamps are missing, or of clocks that disagree
  std::int64_t log_minus_stamp_ns = 0;  ///< usual; tells the stamp of a message that has none
  std::string said;                     ///< the choice in one line
  Issues issues;                        ///< without a file
};

/// Names of a list that commas separate; blanks around them do not count.
[[nodiscard]] std::vector<std::string> names_in(const std::string& list);

/// Chooses by what the recording's beginning shows; what the options name is taken as named.
/// Throws NotEnoughError naming the file where no topic can be mapped: which types are looked for,
/// and which topics come nearest; UsageError where an option names a topic that is not there.
[[nodiscard]] TopicChoice choose_topics(const Survey& survey, const RecordingOptions& options,
                                        const std::string& file);

/// The part that chooses odometry and frames; `choice` has its scans and ranges.
void choose_odometry(TopicChoice& choice, const Survey& survey, const RecordingOptions& options,
                     const std::string& file);

/// The part that takes the other lasers of the robot beside the first, where tf tells where all of
/// them sit: they look the same way up, at one height, from different places. `choice` has its
/// frames.
void join_lasers(TopicChoice& choice, const Survey& survey, const RecordingOptions& options);

/// The part that finds gyros that may turn better than odometry, or instead of it; which is taken,
/// sweeps tell (gyro_trial.hpp). None without a laser. Throws as `choose_topics` does.
void find_gyros(TopicChoice& choice, const Survey& survey, const RecordingOptions& options,
                const std::string& file);

/// The part that chooses truth; `choice` has its frames. What is named for it is truth unasked.
void choose_truth(TopicChoice& choice, const Survey& survey, const RecordingOptions& options,
                  const std::string& file);

/// As `topic_named`; throws InputError where its messages are not what their type says.
[[nodiscard]] std::size_t usable_topic(const Survey& survey, const std::string& name,
                                       const char* option, const std::string& file);

/// The index of a topic. Throws UsageError naming what is there instead.
[[nodiscard]] std::size_t topic_named(const Survey& survey, const std::string& name,
                                      const char* option, const std::string& file);

/// Whether it tells poses that were measured from outside, by its name: "/ground_truth",
/// "/vicon/robot".
[[nodiscard]] bool is_named_for_truth(const std::string& topic);

/// Whether its messages are poses that can be read.
[[nodiscard]] bool has_poses(const TopicEvidence& evidence);

}  // namespace roomatlas::io
