// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/report_data.hpp"

#include <algorithm>

#include "geojson_geometry.hpp"
#include "roomatlas/io/summary.hpp"

namespace roomatlas {
namespace {

constexpr double kPathStep_m = 0.1;

bool is_finite(const Polyline& line) {
  return std::all_of(line.begin(), line.end(),
                     [](const Point2& point) { return point.allFinite(); });
}

Json json_of(const Polyline& line) {
  Json points = Json::array();
  for (const Point2& point : line) points.push_back(to_json(point));
  return points;
}

/// Rings, the outer one first.
Json json_of(const Polygon& polygon) {
  Json rings = Json::array({json_of(polygon.outer)});
  for (const Ring& hole : polygon.holes) rings.push_back(json_of(hole));
  return rings;
}

Json json_of(const std::vector<Polygon>& polygons) {
  Json list = Json::array();
  for (const Polygon& polygon : polygons) list.push_back(json_of(polygon));
  return list;
}

Json json_of(const std::optional<RoomId>& id) { return id ? Json(*id) : Json(nullptr); }

Json rooms_of(const FloorPlan& plan) {
  Json rooms = Json::array();
  for (const PlanRoom& room : plan.rooms) {
    const auto doors = std::count_if(
        plan.doors.begin(), plan.doors.end(),
        [&](const PlanDoor& door) { return door.room_a == room.id || door.room_b == room.id; });
    rooms.push_back({{"id", room.id},
                     {"name", room.name},
                     {"kind", to_string(room.kind)},
                     {"area_m2", to_millimetre(room.area_m2)},
                     {"doors", doors},
                     {"label", to_json(room.label_point)},
                     {"parts", json_of(room.parts)}});
  }
  return rooms;
}

Json doors_of(const FloorPlan& plan) {
  Json doors = Json::array();
  for (const PlanDoor& door : plan.doors) {
    doors.push_back({{"id", door.id},
                     {"width_m", to_millimetre(door.width_m)},
                     {"a", json_of(door.room_a)},
                     {"b", json_of(door.room_b)},
                     {"at", to_json((door.jambs.a + door.jambs.b) / 2.0)},
                     {"opening", json_of(door.opening)}});
  }
  return doors;
}

Json visits_of(const Correction& correction, const RoomGraph& graph) {
  std::map<AsrId, RoomId> room_of;
  for (std::size_t i = 0; i < boost::num_vertices(graph); ++i)
    room_of[graph[i].asr] = graph[i].room;
  Json visits = Json::array();
  for (const AsrCorrection& asr : correction.asrs) {
    visits.push_back({{"asr", asr.asr},
                      {"room", room_of[asr.asr]},
                      {"before", to_json(asr.building_from_asr_before.position())},
                      {"after", to_json(asr.building_from_asr.position())},
                      {"moved_m", to_millimetre(asr.moved_m)},
                      {"turned_deg", degrees(asr.turned_rad)}});
  }
  return visits;
}

/// Walls and path, before and after, point for point.
void add_mission(const PlacedMission& placed, Json& data) {
  Json walls_before = Json::array();
  Json walls_after = Json::array();
  for (std::size_t i = 0; i < placed.walls_before.size(); ++i) {
    if (!is_finite(placed.walls_before[i]) || !is_finite(placed.walls_after[i])) continue;
    walls_before.push_back(json_of(placed.walls_before[i]));
    walls_after.push_back(json_of(placed.walls_after[i]));
  }
  Polyline before;
  Polyline after;
  for (std::size_t i = 0; i < placed.path_before.size(); ++i) {
    const Point2& was = placed.path_before[i];
    const Point2 is = placed.corrected[i].pose.position();
    if (!was.allFinite() || !is.allFinite()) continue;
    const bool is_far = after.empty() || (is - after.back()).norm() >= kPathStep_m ||
                        (was - before.back()).norm() >= kPathStep_m;
    if (!is_far && i + 1 < placed.path_before.size()) continue;
    before.push_back(was);
    after.push_back(is);
  }
  data["before"] = {{"walls", walls_before}, {"path", json_of(before)}};
  data["after"] = {{"walls", walls_after}, {"path", json_of(after)}};
}

}  // namespace

std::string report_data(const std::map<std::string, std::string>& metadata, const std::string& date,
                        const Correction& correction, const FloorPlan& plan, const RoomGraph& graph,
                        const PlacedMission& placed, const std::optional<Evaluation>& evaluation) {
  const auto text = [&](const char* key) {
    const auto entry = metadata.find(key);
    return entry == metadata.end() ? std::string() : entry->second;
  };
  Json data;
  data["summary"] = Json::parse(summary_json(metadata, correction, plan, graph, evaluation));
  data["date"] = date;
  data["tool_version"] = text("tool_version");
  data["configuration"] = text("configuration");
  data["rooms"] = rooms_of(plan);
  data["doors"] = doors_of(plan);
  data["walls"] = json_of(plan.walls);
  data["furniture"] = json_of(plan.furniture);
  data["visits"] = visits_of(correction, graph);
  add_mission(placed, data);
  return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace roomatlas
