// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "console.hpp"
#include "output_places.hpp"
#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/trajectories/tum.hpp"
#include "roomatlas/mission/borrowed_mission.hpp"
#include "roomatlas/pipeline/locate_mission.hpp"
#include "roomatlas/pipeline/map_mission.hpp"

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

void print_json(const LocatedMission& located, const FloorPlan& plan) {
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
  fmt::print("{}\n", json.dump(2));
}

void print(const LocatedMission& located, const FloorPlan& plan) {
  constexpr std::size_t kShown = 5;
  if (located.verdict == PlaceVerdict::nothing_in_common) {
    fmt::print("nowhere in this building, as far as these readings tell\n");
  } else if (located.verdict == PlaceVerdict::ambiguous) {
    fmt::print("not sure: several places fit nearly as well; a longer way would tell\n");
  }
  for (std::size_t i = 0; i < std::min(kShown, located.places.size()); ++i) {
    const Told place = told(located, i, plan);
    if (i > 0 && place.odds < 0.001) break;
    fmt::print(
        "{:5.1f} %  {:8.2f} m {:8.2f} m {:7.1f} deg  {}; {:.0f} % of what can be compared agrees\n",
        100.0 * place.odds, place.pose.x_m, place.pose.y_m, degrees(place.pose.theta_rad),
        place.room.empty() ? "in no room" : "room " + place.room,
        100.0 * located.places[i].agreement());
  }
  fmt::print("{:5.1f} %  nowhere\n", 100.0 * located.nowhere_odds);
}

}  // namespace

void locate(const Settings& settings, const LocateArguments& arguments) {
  const GeoPackageStore building(arguments.building, GeoPackageStore::Mode::read);
  const auto mission = open_mission_to_map(arguments.log, settings.mission);
  TimeSpan span(*mission, arguments);
  MemoryStore asked;
  (void)map_mission(span, asked, settings.map, console_progress(settings));
  const LocatedMission located = locate_mission(building, asked, mission->info().footprint,
                                                settings, console_progress(settings));
  const FloorPlan plan = building.plan();
  if (settings.json) {
    print_json(located, plan);
  } else {
    print(located, plan);
  }
  if (arguments.out.empty()) return;
  require_output_file(arguments.out, {arguments.building, arguments.log});
  if (located.verdict != PlaceVerdict::placed) {
    throw NotEnoughError(arguments.out.string() +
                         ": not written: where the robot was is not sure enough");
  }
  write_tum(arguments.out, located.building_from_robot);
}

}  // namespace roomatlas::apps
