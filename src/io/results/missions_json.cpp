// SPDX-License-Identifier: GPL-3.0-or-later
#include "missions_json.hpp"

#include "errors_json.hpp"
#include "store/stored_names.hpp"
#include "text/json.hpp"
#include "text/json_number.hpp"

namespace roomatlas::io {
namespace {

Json share_of(double some, double all) { return all > 0.0 ? Json(some / all) : Json(nullptr); }

Json json_of(const RoomOfMission& room) {
  const bool was_in = room.visits > 0;
  return {{"room", room.room},
          {"visits", room.visits},
          {"first_s", was_in ? Json(room.first_s) : Json(nullptr)},
          {"last_s", was_in ? Json(room.last_s) : Json(nullptr)},
          {"seen_share", share_of(room.seen_m2, room.floor_m2)}};
}

Json json_of(const MissionFigures& mission, double floor_m2) {
  Json rooms = Json::array();
  for (const RoomOfMission& room : mission.rooms) rooms.push_back(json_of(room));
  return {{"name", mission.name},
          {"sensor", stored_name(kSensorKinds, mission.sensor)},
          {"path_length_m", mission.path_length_m},
          {"first_s", mission.first_s},
          {"last_s", mission.last_s},
          {"seen_m2", mission.seen_m2},
          {"seen_share", share_of(mission.seen_m2, floor_m2)},
          {"walls_compared_m", mission.walls_compared_m},
          {"walls_rms_m", finite(mission.walls_rms_m)},
          {"rooms", rooms}};
}

/// Of each kind what there is.
void add_errors(const MissionErrors& errors, Json& json) {
  if (errors.relations) {
    json["relations"] = {{"before", io::json_of(errors.relations->before)},
                         {"after", io::json_of(errors.relations->after)}};
  }
  if (!errors.true_poses) return;
  json["true_poses"] = {{"before", io::json_of(errors.true_poses->before)},
                        {"after", io::json_of(errors.true_poses->after)}};
  json["in_building"] = {{"position_m", io::json_of(errors.in_building_m)},
                         {"heading_deg", io::json_of(errors.in_building_deg)}};
}

Json json_of(const MissionPair& pair) {
  return {{"missions", {pair.first + 1, pair.second + 1}},
          {"accepted", pair.accepted},
          {"refused", pair.refused},
          {"rms_m", finite(pair.rms_m)},
          {"rms_deg", finite(pair.rms_deg)}};
}

}  // namespace

Json json_of(const MissionsEvaluation& missions) {
  const MissionsFigures& figures = missions.figures;
  Json list = Json::array();
  for (std::size_t i = 0; i < figures.missions.size(); ++i) {
    list.push_back(json_of(figures.missions[i], figures.floor_m2));
    add_errors(missions.errors.at(i), list.back());
  }
  Json json = {{"floor_m2", figures.floor_m2}, {"list", list}};
  json["pairs"] = Json::array();
  for (const MissionPair& pair : figures.pairs) json["pairs"].push_back(json_of(pair));
  if (missions.between) json["between"] = io::json_of(*missions.between);
  return json;
}

}  // namespace roomatlas::io
