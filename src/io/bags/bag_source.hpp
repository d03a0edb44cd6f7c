// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_reader.hpp"
#include "bags/cloud_ring.hpp"
#include "bags/laser_group.hpp"
#include "bags/laser_reader.hpp"
#include "bags/robot_poses.hpp"
#include "bags/sonar_ring.hpp"
#include "bags/survey.hpp"
#include "bags/topic_choice.hpp"

#include "roomatlas/mission/mission.hpp"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace roomatlas::io {

/// Opens the recording anew: its beginning is read twice.
using OpenRecording = std::function<std::unique_ptr<BagReader>()>;

/// A recording of topics as a mission, streaming.
///
/// The recording's beginning is surveyed, topics and frames are chosen (topic_choice.hpp), then it
/// is read through. A reading's time is its header's stamp. It waits until odometry and mount are
/// known for the whole sweep, for at most `kWaits_ns` of recorded time and `kMostWaiting` readings;
/// then the nearest pose holds if it is near in time, else the reading is left out, and counted.
class BagSource : public MissionSource {
 public:
  static constexpr std::int64_t kWaits_ns = 3'000'000'000;
  static constexpr std::size_t kMostWaiting = 256;

  /// @param name of the file, for messages
  /// Throws NotEnoughError, UsageError and InputError as `choose_topics` does.
  BagSource(std::string name, const OpenRecording& open, const MissionOptions& options);
  /// Of what has been chosen already.
  /// @param beginning whose evidence is of `reader`'s topics
  BagSource(std::string name, std::unique_ptr<BagReader> reader, const MissionOptions& options,
            TopicChoice choice, const Survey& beginning);
  BagSource(const BagSource&) = delete;  // poses refer to this object's choice
  BagSource& operator=(const BagSource&) = delete;

  /// Throws InputError where a sensor's mount is not known, naming the option that tells it.
  [[nodiscard]] std::optional<MissionEvent> next() override;
  [[nodiscard]] const MissionInfo& info() const override { return info_; }
  [[nodiscard]] double progress() const override { return reader_->progress(); }

  /// Sweeps so far of which each beam was put to its own pose.
  [[nodiscard]] std::int64_t unrolled() const { return lasers_.notes().unrolled; }
  /// As far as it was read: the turns of a gyro that is not judged yet, and how it is mounted.
  [[nodiscard]] const GyroTrack& gyro(std::size_t topic) const { return gyros_.at(topic); }
  [[nodiscard]] std::optional<Transform3> mount_of_gyro(std::size_t topic) const;

 private:
  /// A reading, or a true pose, on its way.
  struct Waiting {
    std::size_t topic = 0;
    std::int64_t stamp_ns = 0;
    std::int64_t until_ns = 0;  ///< the end of the sweep
    std::int64_t log_ns = 0;
    std::variant<LaserScanMessage, CloudMessage, SonarRing::Round, TruePose> content;
  };
  /// What a topic is used for.
  enum class Use { none, laser, echoes, cloud, range, odometry, transforms, truth, gyro };
  struct Topic {
    Use use = Use::none;
    MessageKind kind = MessageKind::imu;
    bool is_fixed = false;  ///< latched transforms
    std::int64_t used = 0;
    std::int64_t unreadable = 0;
    std::string why;  ///< the first could not be used
    std::optional<std::int64_t> last_stamp_ns;
    std::set<std::string> frames;
  };

  void start(std::string name, std::unique_ptr<BagReader> reader, TopicChoice choice,
             const Survey& beginning);
  void meet_topics(const Survey& beginning);
  [[nodiscard]] SonarRing make_ring(const Survey& beginning) const;

  void take(const BagMessage& message);
  [[nodiscard]] bool use(Topic& topic, const BagMessage& message);
  [[nodiscard]] bool use_scan(Topic& topic, const BagMessage& message,
                              std::optional<LaserScanMessage> scan);
  [[nodiscard]] bool use_cloud(Topic& topic, const BagMessage& message, const MessageCursor& in);
  [[nodiscard]] bool use_range(Topic& topic, const BagMessage& message, const MessageCursor& in);
  [[nodiscard]] bool use_pose(Topic& topic, const BagMessage& message, const MessageCursor& in);
  [[nodiscard]] bool use_gyro(Topic& topic, const BagMessage& message, const MessageCursor& in);
  [[nodiscard]] bool use_transforms(const Topic& topic, const BagMessage& message,
                                    const MessageCursor& in);
  [[nodiscard]] TruePose true_pose(const PoseMessage& pose, std::int64_t stamp_ns);
  void wait_for_round(std::size_t topic, std::int64_t log_ns, SonarRing::Round round);
  /// The message's time; counted where it has no stamp.
  [[nodiscard]] std::int64_t time_of(Topic& topic, const HeaderMessage& header,
                                     std::int64_t log_ns);

  /// The first waiting one as an event, where it can be told by now.
  [[nodiscard]] std::optional<MissionEvent> hand_out();
  [[nodiscard]] bool is_told(const Waiting& waiting, bool given_up);
  [[nodiscard]] bool is_group_told(const Waiting& waiting) const;
  [[nodiscard]] std::optional<TransformAt> mount_of(const Waiting& waiting) const;
  [[noreturn]] void refuse_without_mount(std::size_t topic, const std::string& frame,
                                         const std::string& remedy);
  [[noreturn]] void refuse_laser(std::size_t topic, const std::string& frame);
  [[nodiscard]] RangeReading laser_reading(const Waiting& waiting);
  [[nodiscard]] RangeReading cloud_reading(const Waiting& waiting);
  /// What another laser of the group has to a reading; nothing where it has no sweep near it.
  [[nodiscard]] std::optional<RangeReading> companion_reading(std::size_t topic,
                                                              const Waiting& waiting);
  [[nodiscard]] std::optional<RangeReading> reading_of(const Waiting& waiting);
  [[nodiscard]] std::optional<RangeReading> ring_reading(const Waiting& waiting);
  void note(const RangeReading& reading, std::size_t topic);
  void add_truth(const Waiting& waiting);

  /// What is in the recording, as far as known.
  void describe();
  void note_end();
  void add_issue(Severity severity, std::string field, std::string message);
  void note_poses();
  void note_lasers();
  void note_unreadable();

  MissionInfo info_;
  MissionOptions options_;
  TopicChoice choice_;
  std::vector<TopicEvidence> evidence_;
  std::unique_ptr<BagReader> reader_;
  std::unique_ptr<RobotPoses> poses_;
  std::vector<Topic> topics_;
  std::map<std::size_t, GyroTrack> gyros_;  ///< by topic, those that are not judged yet
  LaserReader lasers_;
  LaserGroup group_;
  CloudRing clouds_;
  SonarRing ring_{{}};
  std::shared_ptr<const RangeSensor> ring_sensor_;

  std::deque<Waiting> waiting_;
  std::deque<TruePose> truths_;  ///< tf's, to be handed out next
  std::optional<Pose2> last_pose_;
  std::int64_t newest_log_ns_ = 0;
  std::optional<std::int64_t> first_log_ns_;
  std::string unjoined_truth_;  ///< whose poses are taken for the robot's
  std::int64_t without_stamp_ = 0;
  std::int64_t without_pose_ = 0;
  std::int64_t at_nearest_pose_ = 0;
  bool read_to_end_ = false;
  bool ended_ = false;
};

/// Opens a recording that `path` holds; null when it is none.
[[nodiscard]] std::unique_ptr<MissionSource> open_recording(const std::filesystem::path& path,
                                                            const MissionOptions& options);

/// "x,y,deg" in metres and degrees; nothing for an empty text. Throws UsageError.
[[nodiscard]] std::optional<Pose2> mount_in(const std::string& text);

}  // namespace roomatlas::io
