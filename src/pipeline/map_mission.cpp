// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/map_mission.hpp"
#include "roomatlas/odometry/dead_reckoner.hpp"
#include "roomatlas/odometry/late_odometry.hpp"

namespace roomatlas {
namespace {

/// Passes ASRs on and counts what they hold.
class CountingSink : public AsrSink {
 public:
  explicit CountingSink(AsrSink& sink) : sink_(sink) {}
  void put(const Asr& asr) override {
    ++summary.asrs;
    summary.wall_vertices += asr.counters.vertices;
    sink_.put(asr);
  }
  void put(const TruePose& truth) override { sink_.put(truth); }

  MapSummary summary;

 private:
  AsrSink& sink_;
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

}  // namespace

MapSummary map_mission(MissionSource& mission, AsrSink& sink, const MapOptions& options,
                       const Progress& progress) {
  constexpr int kReportEvery = 256;
  CountingSink counting(sink);
  DeadReckoner reckoner(options.directions);
  std::optional<AsrRecorder> recorder;  // made once the log has told the robot's footprint
  LateOdometry waiting;
  const auto take = [&](std::vector<DeadReckoned> readings) {
    if (!recorder) {
      recorder.emplace(
          options.record, mission.info().footprint, counting,
          options.localize.enabled ? std::make_unique<RoomLocalizer>(options.localize) : nullptr);
    }
    for (DeadReckoned& reading : readings) waiting.add(std::move(reading));
  };
  const auto record_one = [&] {
    const auto habits = recorder->habits();
    const auto next = waiting.next(habits ? habits->lag_s : 0.0);
    if (next) recorder->add(next->reading, next->reckoned_from_robot);
    return next.has_value();
  };
  const auto finish = [&] {
    take(reckoner.finish());
    waiting.finish();
    while (record_one()) {
    }
    recorder->finish();
  };

  std::int64_t events = 0;
  while (const auto event = mission.next()) {
    if (const auto* truth = std::get_if<TruePose>(&*event)) {
      counting.put(*truth);
    } else {
      take(reckoner.add(std::get<RangeReading>(*event)));
      record_one();
      // the reckoner hands over many at once where it had to wait: caught up with two by two
      if (!recorder->has_just_left()) record_one();
    }
    if (progress && ++events % kReportEvery == 0 && !progress("map", mission.progress())) {
      finish();
      throw Interrupted("interrupted while mapping");
    }
  }
  finish();
  counting.summary.drives_reversed = reckoner.drives_reversed();
  if (recorder) counting.summary.habits = recorder->habits();
  require_enough(mission.info(), counting.summary);
  return counting.summary;
}

}  // namespace roomatlas
