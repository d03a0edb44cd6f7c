// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "console.hpp"
#include "new_store.hpp"
#include "output_places.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/logs/mission_writer.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/results/summary.hpp"

namespace roomatlas::apps {
namespace {

/// Takes a mission's events into another log, which is made at the first reading.
class ConvertedMission {
 public:
  ConvertedMission(const MissionSource& mission, const Path& out) : mission_(mission), out_(out) {}

  void write(const MissionEvent& event) {
    if (const auto* reading = std::get_if<RangeReading>(&event)) return write(*reading);
    // truth before the first reading is of a time that is not mapped
    if (writer_) writer_->write(at_its_time(std::get<TruePose>(event)));
  }

  void finish() {
    if (writer_) writer_->finish();
  }

 private:
  /// Recordings take a stamp of zero for none: where the log has no times, its readings, a second
  /// apart, start at one.
  template <typename Event>
  [[nodiscard]] Event at_its_time(Event event) const {
    if (!mission_.info().has_times) event.timestamp_s += 1.0;
    return event;
  }

  void write(const RangeReading& as_read) {
    const RangeReading reading = at_its_time(as_read);
    const MissionInfo& info = mission_.info();
    const bool has_odometry = info.odometry != "none";
    if (!has_odometry && !is_recording_name(out_)) {
      throw NotEnoughError(info.file +
                           ": has no odometry, without which there is no CARMEN log; write a "
                           "recording: .mcap, .bag or .db3");
    }
    if (!writer_) writer_ = create_mission(out_, *reading.sensor, info.footprint);
    const OdometryStep odometry{reading.timestamp_s, reading.odom_from_robot, 0.0, 0.0};
    const bool is_new = !last_ || last_->timestamp_s != odometry.timestamp_s ||
                        last_->odom_from_robot != odometry.odom_from_robot;
    if (has_odometry && is_new) writer_->write(odometry);
    writer_->write(reading);
    last_ = odometry;
  }

  const MissionSource& mission_;
  Path out_;
  std::unique_ptr<MissionWriter> writer_;
  std::optional<OdometryStep> last_;
};

void tell_what_is_lost(const MissionInfo& info, const Path& out) {
  if (!info.has_times)
    spdlog::warn("the log has no times: its readings are written a second apart");
  const RobotFootprint usual;
  const bool is_usual =
      info.footprint.length_m == usual.length_m && info.footprint.width_m == usual.width_m;
  if (is_recording_name(out) && !is_usual) {
    spdlog::warn(
        "{} has no place for the robot's size: map it with --robot-length {} --robot-width {}",
        out.filename().string(), info.footprint.length_m, info.footprint.width_m);
  }
}

bool is_new_folder(const Path& out) { return is_recording_name(out) && !out.has_extension(); }

/// True for what a run left that was killed, and which the next one writes over.
bool is_left_over(const std::filesystem::directory_entry& entry) {
  return entry.path().filename().string().find(".part") != std::string::npos;
}

/// A folder of a rosbag2 is not mixed with what is there.
void require_new_recording(const Path& out, const Path& log) {
  if (!is_new_folder(out)) return require_output_file(out, {log});
  std::error_code missing;
  if (!std::filesystem::exists(out, missing)) return;
  if (std::filesystem::is_directory(out, missing)) {
    const std::filesystem::directory_iterator entries(out, missing);
    if (std::all_of(begin(entries), end(entries), is_left_over)) return;
  }
  throw InputError(out.string() +
                   ": is there already: give a new folder's name with -o, or a file that ends in "
                   ".mcap, .bag, .db3 or .clf");
}

}  // namespace

void convert(const Settings& settings, const Path& log, const Path& out) {
  // Beside the folder, which is not there yet.
  const auto lock = is_new_folder(out) ? std::make_optional<PlaceLock>(place_beside(out))
                                       : std::optional<PlaceLock>();
  require_new_recording(out, log);
  const auto mission = open_mission_to_map(log, settings.mission);
  ConvertedMission converted(*mission, out);
  const Progress progress = console_progress(settings);
  while (const auto event = mission->next()) {
    converted.write(*event);
    if (!progress("converting", mission->progress())) {
      throw Interrupted("interrupted: nothing was written");
    }
  }
  const MissionInfo& info = mission->info();
  require_lines_that_could_be_read(info);
  if (info.readings == 0) throw NotEnoughError(log.string() + ": has no range readings");
  converted.finish();
  show(info.issues, info.issues_not_listed);
  if (settings.json) fmt::print("{}", to_json(info));
  tell_what_is_lost(info, out);
  spdlog::info("{}: {}, {:.0f} m, {} -> {}", log.filename().string(),
               counted(info.readings, "reading"), info.path_length_m,
               counted(info.true_poses, "true pose"), out.string());
}

}  // namespace roomatlas::apps
