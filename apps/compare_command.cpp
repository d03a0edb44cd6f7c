// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "console.hpp"
#include "output_places.hpp"
#include "plugin_formats.hpp"
#include "printable.hpp"
#include "roomatlas/changes/find_changes.hpp"
#include "roomatlas/changes/lay_on.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/draw/changes.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/plans/changes_files.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/pipeline/mission_map.hpp"
#include "store_metadata.hpp"
#include "usable_store.hpp"

namespace roomatlas::apps {
namespace {

constexpr SearchWindow kAroundGiven{1.0, radians(5.0)};  // of a pose that somebody measured

/// Refuses a store that holds no mission that can be compared.
AssembledMission mission_of(const GeoPackageStore& store) {
  require_assembled(store);
  require_readings(store, "changes are told by what both missions' readings saw");
  return {&store, placement_of(store.correction()), store.plan(), store.mission().footprint};
}

/// Errors of a map look like changes.
void warn_of_doubts(const GeoPackageStore& store, const Path& file) {
  const std::optional<Judgement> judgement = store.judgement();
  if (!judgement || judgement->probability >= kTrusted) return;
  spdlog::warn("{}: right with a probability of {:.0f} % alone: what is told may be its errors",
               file.string(), 100.0 * judgement->probability);
}

/// Where the new mission's frame lies in the old one's, by its rooms; nothing where that is not
/// sure.
std::optional<Pose2> found_in(const AssembledMission& before, const AssembledMission& after,
                              const Settings& settings, const Progress& progress) {
  const MissionMap old_map = mission_map_of(*before.source, before.placement, settings);
  const MissionMap new_map = mission_map_of(*after.source, after.placement, settings);
  const BuildingIndex index(sketch_of(old_map), settings.join.place.locate);
  const MissionSearch search =
      place_mission(new_map, index, settings.join.place, progress, settings.jobs);
  if (search.verdict != PlaceVerdict::placed) return std::nullopt;
  return search.places[0].building_from_mission;
}

/// The new mission in the old one's frame.
AssembledMission laid_on(const AssembledMission& before, const AssembledMission& after,
                         const CompareArguments& arguments, const Settings& settings,
                         const Progress& progress, Pose2& old_from_new) {
  std::vector<Pose2> guesses = quarter_turns();
  LayOnOptions options;
  if (arguments.old_from_new.empty()) {
    if (const std::optional<Pose2> found = found_in(before, after, settings, progress)) {
      guesses = {*found};
      options.around = kAroundGiven;
    }
  } else {
    guesses = {{arguments.old_from_new[0], arguments.old_from_new[1],
                wrap_angle(radians(arguments.old_from_new[2]))}};
    options.around = kAroundGiven;
  }
  const std::optional<LaidOn> laid = lay_on(before, after, guesses, options, progress);
  if (!laid) {
    throw NotEnoughError(
        fmt::format("{} and {}: nothing in common within {:.0f} m and {:.0f} deg: give where the "
                    "new building's "
                    "frame lies in the old one with --old-from-new X,Y,DEG",
                    arguments.before.string(), arguments.after.string(), options.around.reach_m,
                    degrees(options.around.reach_rad)));
  }
  old_from_new = laid->old_from_new;
  const std::size_t left_out = after.placement.size() - laid->placement.size();
  if (left_out > 0) {
    spdlog::warn(
        "{}: {} of {} visits contradict the old map wherever they are laid, and are left "
        "out: what they saw counts as not seen again",
        arguments.after.string(), left_out, after.placement.size());
  }
  return {after.source, laid->placement, moved(after.plan, old_from_new), after.footprint};
}

std::string place_of(const Change& change) {
  return change.room ? "room " + change.room_name : std::string("no room");
}

void print_changes(const PlanChanges& found) {
  say("new building in the old one: {:.2f} m, {:.2f} m, {:.2f} deg; {:.0f} m2 seen by both\n",
      found.old_from_new.x_m, found.old_from_new.y_m, degrees(found.old_from_new.theta_rad),
      found.compared_m2);
  if (!found.tells_changes) {
    say("sonars: what stands where is not told by echoes, rooms alone are compared\n");
  }
  for (const Change& change : found.changes) {
    say("{:4}  {:<17} {:5.2f} m  at {:7.2f}, {:7.2f}  in {}; readings {} then, {} now\n", change.id,
        to_string(change.kind), change.size_m, change.at.x(), change.at.y(), place_of(change),
        change.before.readings(), change.after.readings());
  }
  for (const OneSidedRoom& room : found.rooms) {
    say("      {}: {}, {:.1f} m2, {:.0f} % of it seen from outside\n", to_string(room), room.name,
        room.area_m2, 100.0 * room.seen_share);
  }
  if (found.tells_changes && found.changes.empty()) say("nothing changed\n");
}

}  // namespace

void compare(const Settings& settings, const CompareArguments& arguments) {
  const GeoPackageStore old_store(arguments.before, GeoPackageStore::Mode::read);
  const GeoPackageStore new_store(arguments.after, GeoPackageStore::Mode::read);
  const AssembledMission before = mission_of(old_store);
  const AssembledMission after = mission_of(new_store);
  warn_of_doubts(old_store, arguments.before);
  warn_of_doubts(new_store, arguments.after);
  make_folder(arguments.out);
  const PlaceLock lock(arguments.out);

  const Progress progress = console_progress(settings);
  Pose2 old_from_new;
  const AssembledMission laid = laid_on(before, after, arguments, settings, progress, old_from_new);
  PlanChanges found = find_changes(before, laid, {}, progress, settings.jobs);
  found.old_from_new = old_from_new;

  const std::string svg = draw_changes(before.plan, laid.plan, found,
                                       {old_store.mission().file, date_of(old_store.metadata()),
                                        new_store.mission().file, date_of(new_store.metadata())},
                                       settings.draw);
  write_file(arguments.out / "changes.svg", svg);
  write_picture(arguments.out / "changes.png", svg, settings.png_dpi);
  write_file(arguments.out / "changes.geojson", changes_geojson(found));
  write_file(arguments.out / "changes.csv", changes_csv(found));
  if (settings.json) {
    fmt::print("{}", changes_json(found));
  } else {
    print_changes(found);
  }
}

}  // namespace roomatlas::apps
