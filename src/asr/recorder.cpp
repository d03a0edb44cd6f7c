// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>
#include <utility>

#include "live_grid.hpp"

namespace roomatlas {
namespace {

constexpr double kSearchEveryM = 0.1;   // doorways are looked for after this much path
constexpr double kBestWithinM = 0.4;    // the narrowest chord within this much path is the doorway
constexpr double kSonarLagM = 0.4;      // sonars hear a jamb well only from beside it: looked for
                                        // this much later than with a laser
constexpr double kSeedM = 1.0;          // the live grid of a new ASR starts with this much path
constexpr int kSettledAfter = 12;       // readings: the first of a new room cost most
constexpr int kHandOverAfter = 150;     // readings: a room that was left is mapped by then
constexpr double kHeadingSpanM = 0.15;  // motion direction is taken over this much path each way

/// A doorway on the path, and where on the path it was found.
struct DoorwayOnPath {
  Doorway doorway;
  std::size_t index = 0;  ///< into the path
  double at_m = 0.0;      ///< along the path
};

Exit open_passage_at(const Pose2& asr_from_robot) {
  Exit exit;
  exit.kind = PassageKind::open_passage;
  exit.frame_from_pivot = asr_from_robot;
  exit.jambs = {asr_from_robot.position(), asr_from_robot.position()};
  return exit;
}

/// The same passage as the room behind it sees it: the origin, looking back.
Exit entry_from(const Exit& exit, AsrId from) {
  Exit entry = exit;
  entry.is_entry = true;
  entry.frame_from_pivot = {0.0, 0.0, wrap_angle(kPi)};
  const Pose2 entry_from_old = inverse(exit.frame_from_pivot);
  // looking out of the new room, left and right change places
  entry.jambs = {entry_from_old * exit.jambs.b, entry_from_old * exit.jambs.a};
  entry.neighbor = from;
  return entry;
}

}  // namespace

/// The room being mapped.
class AsrRecorder::State {
 public:
  State(const RecorderOptions& options, const RobotFootprint& footprint, AsrSink& sink,
        std::unique_ptr<Localizer> localizer)
      : options_(options),
        footprint_(footprint),
        sink_(sink),
        localizer_(std::move(localizer)),
        live_(options_.map, footprint_) {}

  void add(const RangeReading& reading, const Pose2& reckoned_from_robot) {
    if (++since_left_ == kHandOverAfter) hand_over();
    if (!last_) odom_from_asr_ = reading.odom_from_robot;
    const Pose2 step = last_ ? inverse(last_->reckoned_from_robot) * reckoned_from_robot : Pose2{};
    const Pose2 predicted = last_ ? last_->asr_from_robot * step : Pose2{};
    const Pose2 asr_from_robot =
        localizer_ ? localizer_->locate(reading, predicted, step) : predicted;
    last_ = {asr_from_robot, reckoned_from_robot};
    append(reading, asr_from_robot);
    if (const auto found = search_doorway()) {
      leave_through(*found);
    } else if (along_m_.back() > options_.max_piece_path_m || is_full()) {
      leave_open();
    }
  }

  void finish() {
    if (!path_.empty()) close(std::nullopt);
    hand_over();
  }

  void resume(const RoomEntered& room, const std::vector<RangeReading>& readings) {
    next_id_ = room.asr;
    if (localizer_) localizer_->resume(room.learnt);
    enter(room, readings);
  }
  [[nodiscard]] const RoomEntered& entered() const { return entered_; }

  [[nodiscard]] bool has_just_left() const {
    return asrs_written() > 0 && since_left_ < kSettledAfter;
  }
  [[nodiscard]] std::int64_t asrs_written() const { return next_id_ - 1; }
  [[nodiscard]] std::optional<OdometryHabits> habits() const {
    return localizer_ ? localizer_->habits() : std::nullopt;
  }

 private:
  /// Adds a reading to the room: path, readings and the live grid.
  void append(const RangeReading& reading, const Pose2& asr_from_robot) {
    const double step_m =
        path_.empty() ? 0.0
                      : (asr_from_robot.position() - path_.back().asr_from_robot.position()).norm();
    along_m_.push_back(path_.empty() ? 0.0 : along_m_.back() + step_m);
    path_.push_back({reading.timestamp_s, asr_from_robot, reading.odom_from_robot});
    readings_.push_back(reading);
    live_.add(reading, asr_from_robot);
  }

  /// The pose on the path at an index, heading along the motion; nothing where the robot only
  /// turned.
  [[nodiscard]] std::optional<Pose2> motion_at(std::size_t index) const {
    const auto along = [&](double m) {
      const auto at = std::lower_bound(along_m_.begin(), along_m_.end(), m);
      return std::min(static_cast<std::size_t>(at - along_m_.begin()), path_.size() - 1);
    };
    const Point2 from = path_[along(along_m_[index] - kHeadingSpanM)].asr_from_robot.position();
    const Point2 to = path_[along(along_m_[index] + kHeadingSpanM)].asr_from_robot.position();
    const Point2 motion = to - from;
    if (motion.norm() < kHeadingSpanM / 2.0) return std::nullopt;
    const Point2 at = path_[index].asr_from_robot.position();
    return Pose2{at.x(), at.y(), std::atan2(motion.y(), motion.x())};
  }

  /// Looks for a doorway some way behind the robot. Answers when the narrowest one is known.
  std::optional<DoorwayOnPath> search_doorway() {
    const double at_m = along_m_.back() - lag_m();
    if (at_m < searched_to_m_ + kSearchEveryM) return std::nullopt;
    searched_to_m_ = at_m;
    const auto lagged = std::lower_bound(along_m_.begin(), along_m_.end(), at_m);
    const auto index = static_cast<std::size_t>(lagged - along_m_.begin());
    const std::optional<Pose2> motion = motion_at(index);
    const std::optional<Doorway> doorway =
        motion ? find_doorway(live_.grid(), *motion, options_.doorway) : std::nullopt;
    if (doorway && (!candidate_ || doorway->width_m < candidate_->doorway.width_m)) {
      candidate_ = DoorwayOnPath{*doorway, index, along_m_[index]};
    }
    if (!candidate_) return std::nullopt;
    const double passed_m = along_m_[index] - candidate_->at_m;
    const bool decided = passed_m > kBestWithinM || (!doorway && passed_m > kBestWithinM / 2.0);
    if (!decided) return std::nullopt;
    const DoorwayOnPath found = *std::exchange(candidate_, std::nullopt);
    const bool too_near =
        since_doorway_m_ && *since_doorway_m_ + found.at_m < options_.min_doorway_gap_m;
    return too_near ? std::nullopt : std::optional<DoorwayOnPath>(found);
  }

  /// Splits the path where it crosses the door line.
  void leave_through(const DoorwayOnPath& found) {
    const Pose2 pivot_from_asr = inverse(found.doorway.frame_from_pivot);
    const auto is_beyond = [&](std::size_t i) {
      return (pivot_from_asr * path_[i].asr_from_robot.position()).x() > 0.0;
    };
    std::size_t split = found.index;
    while (split > 0 && is_beyond(split - 1)) --split;
    while (split < path_.size() && !is_beyond(split)) ++split;
    if (split == 0 || split == path_.size()) return;
    leave({found.doorway, PassageKind::doorway, false, std::nullopt, 0.0}, split);
  }

  /// Cuts the room where doorways have been looked for already, so that none is lost at the cut;
  /// but not so early that a robot that hardly moves, or short pieces, would be cut again at once.
  void leave_open() {
    if (path_.size() < 2) return;
    const double cut_m = std::max(along_m_.back() / 2.0, along_m_.back() - lag_m() - kBestWithinM);
    const auto cut = std::lower_bound(along_m_.begin(), along_m_.end(), cut_m);
    std::size_t split = std::max<std::size_t>(1, static_cast<std::size_t>(cut - along_m_.begin()));
    if (is_full()) split = std::max(split, path_.size() / 2);
    leave(open_passage_at(path_[split].asr_from_robot), split);
  }

  /// How far behind the robot doorways are looked for.
  [[nodiscard]] double lag_m() const {
    const bool is_sonar = readings_.back().sensor->kind == SensorKind::sonar;
    return options_.doorway_lag_m + (is_sonar ? kSonarLagM : 0.0);
  }

  [[nodiscard]] bool is_full() const {
    return path_.size() >= static_cast<std::size_t>(options_.max_piece_readings);
  }

  /// Closes the ASR with the samples before `split`, and opens the next with the rest.
  void leave(Exit exit, std::size_t split) {
    const auto at = static_cast<std::ptrdiff_t>(split);
    const double left_m = along_m_[split - 1];
    const auto seed = std::lower_bound(along_m_.begin(), along_m_.begin() + at, left_m - kSeedM);
    const std::ptrdiff_t seed_at = seed - along_m_.begin();
    const std::vector<RangeReading> readings(readings_.begin() + seed_at, readings_.end());
    RoomEntered room;
    room.asr = next_id_ + 1;
    const Pose2 new_from_old = inverse(exit.frame_from_pivot);
    for (auto sample = path_.begin() + seed_at; sample != path_.end(); ++sample) {
      std::vector<Pose2>& poses = sample < path_.begin() + at ? room.seed : room.path;
      poses.push_back(new_from_old * sample->asr_from_robot);
    }
    room.reckoned_from_robot = last_->reckoned_from_robot;
    if (since_doorway_m_) room.since_doorway_m = *since_doorway_m_ + left_m;
    if (exit.kind == PassageKind::doorway) room.since_doorway_m = 0.0;

    path_.resize(split);
    readings_.resize(split);
    exit.timestamp_s = path_.back().timestamp_s;
    exit.neighbor = room.asr;
    room.entry = entry_from(exit, next_id_);
    room.odom_from_asr = close(exit) * exit.frame_from_pivot;
    if (localizer_) room.learnt = localizer_->learnt();
    enter(room, readings);
  }

  /// Begins a room with what is known of it already.
  /// @param readings of the seed and the path
  void enter(const RoomEntered& room, const std::vector<RangeReading>& readings) {
    entered_ = room;
    since_left_ = 0;
    odom_from_asr_ = room.odom_from_asr;
    entry_ = room.entry;
    since_doorway_m_ = room.since_doorway_m;
    last_ = {room.path.back(), room.reckoned_from_robot};
    auto reading = readings.begin();
    for (const Pose2& asr_from_robot : room.seed) {
      if (localizer_) localizer_->add(*reading, asr_from_robot);
      live_.add(*reading++, asr_from_robot);
    }
    for (const Pose2& asr_from_robot : room.path) {
      if (localizer_) localizer_->add(*reading, asr_from_robot);
      append(*reading++, asr_from_robot);
    }
    live_.begin();  // with many sweeps: they are drawn until the next reading arrives
  }

  /// Begins to map the room, hands the one before over and forgets both. Returns where odometry has
  /// the room's frame.
  Pose2 close(const std::optional<Exit>& exit) {
    Asr asr;
    asr.id = next_id_++;
    asr.odom_from_asr = odom_from_asr_;
    asr.start_s = path_.front().timestamp_s;
    asr.end_s = path_.back().timestamp_s;
    if (entry_) asr.exits.push_back(*entry_);
    if (exit) asr.exits.push_back(*exit);
    asr.path = std::exchange(path_, {});
    asr.readings = std::exchange(readings_, {});
    asr.is_localized =
        localizer_ && std::all_of(asr.readings.begin(), asr.readings.end(),
                                  [&](const auto& r) { return localizer_->localizes(r); });
    // Where odometry puts the frame *now*: the frame itself is exact, odometry has drifted.
    const Pose2 odom_from_asr =
        asr.path.back().odom_from_robot * inverse(asr.path.back().asr_from_robot);
    hand_over();
    closing_ = std::async(std::launch::async, [this, asr = std::move(asr)]() mutable {
      map(asr);
      return std::move(asr);
    });

    along_m_.clear();
    live_.clear();
    if (localizer_) localizer_->clear();
    candidate_.reset();
    searched_to_m_ = 0.0;
    return odom_from_asr;
  }

  /// In a thread of its own: cleaning and tracing a room takes longer than the robot may wait.
  void map(Asr& asr) const {
    RoomMap map = map_room(asr.path, asr.readings, asr.exits, footprint_, options_.map);
    asr.walls = std::move(map.walls);
    asr.outline_asr = std::move(map.outline);
    asr.reference_point_asr = map.reference_point;
    asr.counters = map.counters;
    if (!options_.keep_readings) asr.readings.clear();
  }

  /// Waits for the room that is being mapped. Always as many readings later, so that what the sink
  /// receives does not depend on how long it took.
  void hand_over() {
    if (closing_.valid()) sink_.put(closing_.get());
  }

  const RecorderOptions options_;
  const RobotFootprint footprint_;
  AsrSink& sink_;
  const std::unique_ptr<Localizer> localizer_;

  /// Where the last reading was taken.
  struct LastReading {
    Pose2 asr_from_robot;
    Pose2 reckoned_from_robot;
  };

  AsrId next_id_ = 1;    ///< of the ASR that is mapped
  RoomEntered entered_;  ///< as it was entered
  std::optional<LastReading> last_;
  Pose2 odom_from_asr_;
  std::optional<Exit> entry_;
  std::vector<PathSample> path_;
  std::vector<RangeReading> readings_;
  std::vector<double> along_m_;  ///< length of the path up to each sample
  LiveGrid live_;
  double searched_to_m_ = 0.0;  ///< doorways were looked for up to here
  std::optional<DoorwayOnPath> candidate_;
  std::optional<double> since_doorway_m_;  ///< from the last doorway to this ASR's first sample
  int since_left_ = 0;                     ///< readings since a room was left
  std::future<Asr> closing_;               ///< the room before; its destructor waits
};

AsrRecorder::AsrRecorder(const RecorderOptions& options, const RobotFootprint& footprint,
                         AsrSink& sink, std::unique_ptr<Localizer> localizer)
    : state_(std::make_unique<State>(options, footprint, sink, std::move(localizer))) {}
AsrRecorder::~AsrRecorder() = default;

void AsrRecorder::add(const RangeReading& reading, const Pose2& reckoned_from_robot) {
  state_->add(reading, reckoned_from_robot);
}
void AsrRecorder::finish() { state_->finish(); }
void AsrRecorder::resume(const RoomEntered& room, const std::vector<RangeReading>& readings) {
  state_->resume(room, readings);
}
const RoomEntered& AsrRecorder::entered() const { return state_->entered(); }
bool AsrRecorder::has_just_left() const { return state_->has_just_left(); }
std::int64_t AsrRecorder::asrs_written() const { return state_->asrs_written(); }
std::optional<OdometryHabits> AsrRecorder::habits() const { return state_->habits(); }

}  // namespace roomatlas
