// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/map_mission.hpp"

#include <deque>
#include <utility>

#include "rehearsal.hpp"
#include "roomatlas/odometry/dead_reckoner.hpp"
#include "roomatlas/odometry/late_odometry.hpp"

namespace roomatlas {
namespace {

/// Passes ASRs on, with the checkpoint behind each where the sink keeps such, and counts what they
/// hold.
class CountingSink : public AsrSink {
 public:
  CountingSink(AsrSink& sink, CheckpointSink* keeps_checkpoints)
      : sink_(sink), keeps_checkpoints_(keeps_checkpoints) {}

  void put(const Asr& asr) override {
    ++summary.asrs;
    summary.wall_vertices += asr.counters.vertices;
    if (!behind_next_ || keeps_checkpoints_ == nullptr) return sink_.put(asr);
    behind_next_->true_poses = true_poses_;
    behind_next_->wall_vertices = summary.wall_vertices;
    keeps_checkpoints_->put(asr, to_bytes(*std::exchange(behind_next_, std::nullopt)));
  }
  void put(const TruePose& truth) override {
    if (++true_poses_ > there_already_) sink_.put(truth);
  }

  /// Where a run goes on that has the next ASR.
  void set_checkpoint(MapCheckpoint checkpoint) { behind_next_ = std::move(checkpoint); }
  /// The sink holds what another run had put into it by then.
  void resume(const MapCheckpoint& from) {
    there_already_ = from.true_poses;
    summary.asrs = from.room.asr - 1;
    summary.wall_vertices = from.wall_vertices;
  }

  MapSummary summary;

 private:
  AsrSink& sink_;
  CheckpointSink* keeps_checkpoints_;
  std::optional<MapCheckpoint> behind_next_;
  std::int64_t true_poses_ = 0;
  std::int64_t there_already_ = 0;
};

void require_enough(const MissionInfo& info, const MapSummary& summary) {
  if (info.odometry == "none") {
    throw NotEnoughError(info.file +
                         ": no odometry: there are no ODOM lines and no poses in the scans; "
                         "record wheel odometry with the ranges");
  }
  if (info.readings == 0) {
    throw NotEnoughError(info.file +
                         ": no range readings: expected FLASER, ROBOTLASER or SONAR lines; "
                         "record a laser or sonars");
  }
  if (summary.wall_vertices == 0) {
    throw NotEnoughError(info.file +
                         ": no wall was seen: every reading is free of echoes, too short or too "
                         "seldom; check the maximum range and that the robot moved");
  }
}

/// The way of a reading from the mission to the room that it is of.
class OnlineStage {
 public:
  /// @param from where another run was stopped: what it had recorded passes by, until then
  OnlineStage(const MissionSource& mission, CountingSink& sink, const MapOptions& options,
              const std::optional<MapCheckpoint>& from)
      : mission_(mission),
        sink_(sink),
        options_(options),
        reckoner_(options.directions),
        from_(from) {
    if (from_) {
      sink_.resume(*from_);
    } else if (options_.localize.enabled) {
      rehearsal_.emplace(options_.localize);
    }
  }

  void add(const MissionEvent& event) {
    ++events_;
    if (const auto* truth = std::get_if<TruePose>(&event)) {
      sink_.put(*truth);
      return;
    }
    take(reckoner_.add(std::get<RangeReading>(event)));
    if (is_behind()) return catch_up();
    if (!recorder_) return;
    record_one();
    // many have waited for the rehearsal, or for the reckoner: caught up with two by two
    if (!recorder_->has_just_left()) record_one();
  }

  /// @param is_stopped before the mission's end: what follows is no part of an undisturbed run
  void finish(bool is_stopped) {
    keeps_checkpoints_ = !is_stopped;
    if (is_stopped && is_behind()) return;  // the sink has all that there is
    take(reckoner_.finish());
    waiting_.finish();
    if (!recorder_) begin();
    if (is_behind()) catch_up();
    if (is_behind()) {
      throw InputError(mission_.info().file + ": it has " + std::to_string(recorded_) +
                       " readings, but " + std::to_string(from_->readings) +
                       " had been mapped when the run before was stopped: it is another log, or "
                       "the store is damaged. Remove the store and map again");
    }
    while (record_one()) {
    }
    recorder_->finish();
  }

  void tell(MapSummary& summary) const {
    summary.drives_reversed = reckoner_.drives_reversed();
    if (recorder_) summary.habits = recorder_->habits();
  }

 private:
  void take(std::vector<DeadReckoned> readings) {
    for (DeadReckoned& reading : readings) {
      if (rehearsal_) rehearsal_->add(reading);
      waiting_.add(std::move(reading));
    }
    if (!recorder_ && (!rehearsal_ || rehearsal_->is_over())) begin();
  }

  /// Once the log has told the robot's footprint, and the rehearsal of odometry.
  void begin() {
    std::unique_ptr<RoomLocalizer> localizer;
    if (options_.localize.enabled) {
      localizer = std::make_unique<RoomLocalizer>(options_.localize);
      if (rehearsal_) localizer->resume(rehearsal_->learnt());
    }
    rehearsal_.reset();
    recorder_.emplace(options_.record, mission_.info().footprint, sink_, std::move(localizer));
  }

  bool record_one() {
    const auto habits = recorder_->habits();
    const auto next = waiting_.next(habits ? habits->lag_s : 0.0);
    if (!next) return false;
    ++recorded_;
    const std::int64_t asrs = recorder_->asrs_written();
    recorder_->add(next->reading, next->reckoned_from_robot);
    if (keeps_checkpoints_ && recorder_->asrs_written() > asrs) {
      sink_.set_checkpoint({.events = events_,
                            .readings = recorded_,
                            .odometry = waiting_.state(),
                            .room = recorder_->entered()});
    }
    return true;
  }

  /// Whether what comes had been recorded by the run before this one.
  [[nodiscard]] bool is_behind() const { return from_ && !has_resumed_; }

  /// Lets pass what had been recorded, and goes on where that ends. The event that is at hand then
  /// is done with: after the one in which a room was left nothing more is recorded.
  void catch_up() {
    const std::size_t needed = from_->room.seed.size() + from_->room.path.size();
    while (recorded_ < from_->readings) {
      auto reading = waiting_.skip();
      if (!reading) return;
      ++recorded_;
      last_.push_back(*std::move(reading));
      if (last_.size() > needed) last_.pop_front();
    }
    if (events_ < from_->events) return;
    waiting_.resume(from_->odometry);
    recorder_->resume(from_->room, {last_.begin(), last_.end()});
    last_.clear();
    has_resumed_ = true;
  }

  const MissionSource& mission_;
  CountingSink& sink_;
  const MapOptions& options_;
  DeadReckoner reckoner_;
  LateOdometry waiting_;
  std::optional<Rehearsal> rehearsal_;  ///< until there is a recorder
  std::optional<AsrRecorder> recorder_;
  std::int64_t events_ = 0;
  std::int64_t recorded_ = 0;  ///< readings that the recorder was given
  bool keeps_checkpoints_ = true;
  const std::optional<MapCheckpoint>& from_;
  bool has_resumed_ = false;
  std::deque<RangeReading> last_;  ///< that passed by, with which the room begins
};

MapSummary map_into(MissionSource& mission, CountingSink& sink, const MapOptions& options,
                    const std::optional<MapCheckpoint>& from, const Progress& progress) {
  constexpr int kReportEvery = 256;
  OnlineStage stage(mission, sink, options, from);
  std::int64_t events = 0;
  while (const auto event = mission.next()) {
    stage.add(*event);
    if (progress && ++events % kReportEvery == 0 && !progress("map", mission.progress())) {
      stage.finish(true);
      throw Interrupted("interrupted while mapping");
    }
  }
  stage.finish(false);
  stage.tell(sink.summary);
  require_enough(mission.info(), sink.summary);
  return sink.summary;
}

}  // namespace

MapSummary map_mission(MissionSource& mission, AsrSink& sink, const MapOptions& options,
                       const Progress& progress) {
  CountingSink counting(sink, nullptr);
  return map_into(mission, counting, options, std::nullopt, progress);
}

MapSummary map_mission(MissionSource& mission, CheckpointSink& sink, const MapOptions& options,
                       const std::optional<MapCheckpoint>& from, const Progress& progress) {
  CountingSink counting(sink, &sink);
  return map_into(mission, counting, options, from, progress);
}

}  // namespace roomatlas
