// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "console.hpp"
#include "mission_parts.hpp"
#include "output_places.hpp"
#include "printable.hpp"
#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/trajectories/tum.hpp"
#include "roomatlas/mission/borrowed_mission.hpp"
#include "roomatlas/pipeline/locate_mission.hpp"
#include "roomatlas/pipeline/map_mission.hpp"
#include "usable_store.hpp"

namespace roomatlas::apps {
namespace {

using Json = nlohmann::ordered_json;

/// The events of a span of time alone.
class TimeSpan : public BorrowedMission {
 public:
  TimeSpan(MissionSource& mission, const LocateArguments& arguments)
      : BorrowedMission(mission), arguments_(arguments) {}

  std::optional<MissionEvent> next() override {
    while (std::optional<MissionEvent> event = BorrowedMission::next()) {
      const double time_s = std::visit([](const auto& one) { return one.timestamp_s; }, *event);
      if (time_s < arguments_.from_s || time_s > arguments_.to_s) continue;
      is_empty_ = is_empty_ && !std::holds_alternative<RangeReading>(*event);
      return event;
    }
    if (is_empty_) throw InputError(why_empty());
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::string why_empty() const {
    return fmt::format("{}: no reading between --from {} and --to {}; the log runs from {} to {} s",
                       arguments_.log.string(), arguments_.from_s, arguments_.to_s,
                       info().first_timestamp_s.value_or(0.0),
                       info().last_timestamp_s.value_or(0.0));
  }

  const LocateArguments& arguments_;
  bool is_empty_ = true;
};

/// The room of a plan that a point lies in; empty where it is in none.
std::string room_at(const FloorPlan& plan, const Point2& at) {
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) {
      if (contains(part, at)) return room.name;
    }
  }
  return "";
}

struct Told {
  Pose2 pose;  ///< of the robot at its last reading, in the building
  std::string room;
  double odds = 0.0;
};

Told told(const LocatedMission& located, std::size_t i, const FloorPlan& plan) {
  Told result;
  result.odds = located.odds[i];
  const Pose2 best_from_other =
      located.places[i].building_from_mission * inverse(located.places[0].building_from_mission);
  result.pose = best_from_other * located.building_from_robot.back().pose;
  result.room = room_at(plan, result.pose.position());
  return result;
}

/// A stretch of the log between two kidnappings, and where it was.
struct LocatedPart {
  double from_s = 0.0;
  double to_s = 0.0;
  LocatedMission located;
};

Json json_of(const LocatedMission& located, const FloorPlan& plan) {
  Json json;
  json["verdict"] = to_string(located.verdict);
  json["nowhere_odds"] = located.nowhere_odds;
  json["places"] = Json::array();
  for (std::size_t i = 0; i < located.places.size(); ++i) {
    const Told place = told(located, i, plan);
    json["places"].push_back({{"odds", place.odds},
                              {"score", located.places[i].score},
                              {"agreement", located.places[i].agreement()},
                              {"room", place.room},
                              {"x_m", place.pose.x_m},
                              {"y_m", place.pose.y_m},
                              {"theta_rad", place.pose.theta_rad}});
  }
  return json;
}

void print_json(const std::vector<LocatedPart>& parts, const FloorPlan& plan) {
  Json json;
  if (parts.size() == 1) {
    json = json_of(parts.front().located, plan);
  } else {
    json["parts"] = Json::array();
    for (const LocatedPart& part : parts) {
      Json one = {{"from_s", part.from_s}, {"to_s", part.to_s}};
      one.update(json_of(part.located, plan));
      json["parts"].push_back(std::move(one));
    }
  }
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print_places(const LocatedMission& located, const FloorPlan& plan) {
  constexpr std::size_t kShown = 5;
  if (located.verdict == PlaceVerdict::nothing_in_common) {
    say("nowhere in this building, as far as these readings tell\n");
  } else if (located.verdict == PlaceVerdict::ambiguous) {
    say("not sure: several places fit nearly as well; a longer way would tell\n");
  }
  for (std::size_t i = 0; i < std::min(kShown, located.places.size()); ++i) {
    const Told place = told(located, i, plan);
    if (i > 0 && place.odds < 0.001) break;
    say("{:5.1f} %  {:8.2f} m {:8.2f} m {:7.1f} deg  {}; {:.0f} % of what can be compared agrees\n",
        100.0 * place.odds, place.pose.x_m, place.pose.y_m, degrees(place.pose.theta_rad),
        place.room.empty() ? "in no room" : "room " + place.room,
        100.0 * located.places[i].agreement());
  }
  say("{:5.1f} %  nowhere\n", 100.0 * located.nowhere_odds);
}

/// Where the robot was in one part of the span. A part in which no wall was seen was nowhere.
LocatedPart located_part(const Settings& settings, const LocateArguments& arguments,
                         const AssemblyStore& building, const MissionPart& part) {
  const auto mission = open_mission_to_map(arguments.log, settings.mission);
  TimeSpan span(*mission, arguments);
  PartOfMission cut(span, part);
  MemoryStore asked;
  LocatedPart result;
  result.located.nowhere_odds = 1.0;
  try {
    (void)map_mission(cut, asked, settings.map, console_progress(settings));
    result.located = locate_mission(building, asked, mission->info().footprint, settings,
                                    console_progress(settings));
  } catch (const NotEnoughError& error) {
    if (part.is_whole()) throw;
    spdlog::warn("{}", error.what());
  }
  result.from_s = cut.info().first_timestamp_s.value_or(0.0);
  result.to_s = cut.info().last_timestamp_s.value_or(0.0);
  return result;
}

std::vector<MissionPart> parts_of_span(const Settings& settings, const LocateArguments& arguments) {
  const auto mission = open_mission_to_map(arguments.log, settings.mission);
  TimeSpan span(*mission, arguments);
  return parts_between(kidnappings_in(settings, span));
}

/// The paths of all parts whose place is sure.
Trajectory sure_paths(const std::vector<LocatedPart>& parts) {
  Trajectory paths;
  for (const LocatedPart& part : parts) {
    if (part.located.verdict != PlaceVerdict::placed) continue;
    const Trajectory& path = part.located.building_from_robot;
    paths.insert(paths.end(), path.begin(), path.end());
  }
  return paths;
}

}  // namespace

void locate(const Settings& settings, const LocateArguments& arguments) {
  const GeoPackageStore building(arguments.building, GeoPackageStore::Mode::read);
  require_assembled(building);
  require_readings(building, "a robot is found by what the building's readings saw");
  std::vector<LocatedPart> parts;
  for (const MissionPart& part : parts_of_span(settings, arguments)) {
    parts.push_back(located_part(settings, arguments, building, part));
  }
  const FloorPlan plan = building.plan();
  if (settings.json) {
    print_json(parts, plan);
  } else {
    for (const LocatedPart& part : parts) {
      if (parts.size() > 1) say("from {} to {} s:\n", part.from_s, part.to_s);
      print_places(part.located, plan);
    }
  }
  if (arguments.out.empty()) return;
  require_output_file(arguments.out, {arguments.building, arguments.log});
  const Trajectory paths = sure_paths(parts);
  if (paths.empty()) {
    throw NotEnoughError(arguments.out.string() +
                         ": not written: where the robot was is not sure enough");
  }
  write_tum(arguments.out, paths);
}

}  // namespace roomatlas::apps
