// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/changes_files.hpp"

#include "geojson_geometry.hpp"
#include "plan_schema.hpp"
#include "results/table_text.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

constexpr const char* kSchema = "changes";
constexpr int kVersion = 1;  // of the layout

Json json_of(const Sighting& sighting) {
  return {{"stood_readings", sighting.stood},
          {"passed_readings", sighting.passed},
          {"visits", sighting.visits},
          {"first_s", sighting.first_s},
          {"last_s", sighting.last_s}};
}

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json properties_of(const Change& change) {
  return {{"kind", to_string(change.kind)}, {"id", change.id},
          {"room", or_null(change.room)},   {"room_name", change.room_name},
          {"door", or_null(change.door)},   {"size_m", to_millimetre(change.size_m)},
          {"at", to_json(change.at)},       {"before", json_of(change.before)},
          {"after", json_of(change.after)}};
}

Json properties_of(const OneSidedRoom& room) {
  return {{"kind", to_string(room)},
          {"room", room.room},
          {"room_name", room.name},
          {"area_m2", to_millimetre(room.area_m2)},
          {"seen_share", to_millimetre(room.seen_share)}};
}

void add_feature(Json properties, const std::vector<Polygon>& polygons, std::string& text) {
  Json geometry = to_geometry(polygons);
  if (geometry["coordinates"].empty()) return;
  const Json feature = {{"type", "Feature"},
                        {"properties", std::move(properties)},
                        {"geometry", std::move(geometry)}};
  text += (text.empty() ? "\n" : ",\n") + compact(feature);
}

/// One half of a change: what is gone, or what is new.
void add_half(const Change& change, const char* state, const std::vector<Polygon>& polygons,
              std::string& text) {
  if (polygons.empty()) return;
  Json properties = properties_of(change);
  properties["state"] = state;
  add_feature(std::move(properties), polygons, text);
}

/// Whose room it is, when both missions are told of in two columns.
std::string row_of(const Sighting& sighting) {
  std::string visits;
  for (const AsrId id : sighting.visits) visits += (visits.empty() ? "" : " ") + std::to_string(id);
  std::string row =
      ',' + std::to_string(sighting.stood) + ',' + std::to_string(sighting.passed) + ',' + visits;
  if (sighting.visits.empty()) return row + ",,";
  io::add_csv(row, sighting.first_s);
  io::add_csv(row, sighting.last_s);
  return row;
}

}  // namespace

const char* to_string(const OneSidedRoom& room) {
  return room.was_before ? "room not visited again" : "room first visited";
}

std::string changes_geojson(const PlanChanges& changes) {
  const Pose2& pose = changes.old_from_new;
  const Json header = {
      {"schema", kSchema},
      {"version", kVersion},
      {"units", plan_schema::kUnits},
      {"frame", "the old plan's building metres, not longitude/latitude"},
      {"old_from_new",
       {to_millimetre(pose.x_m), to_millimetre(pose.y_m), to_millimetre(degrees(pose.theta_rad))}}};
  std::string features;
  for (const Change& change : changes.changes) {
    add_half(change, "gone", change.gone, features);
    add_half(change, "new", change.appeared, features);
  }
  for (const Polygon& piece : changes.not_seen_again) {
    add_feature({{"kind", "not seen again"}}, {piece}, features);
  }
  return "{\"type\":\"FeatureCollection\",\n\"roomatlas\":" + compact(header) +
         ",\n\"features\":[" + features + "\n]}\n";
}

std::string changes_csv(const PlanChanges& changes) {
  std::string text =
      "id,kind,room,room_name,door,x_m,y_m,size_m,before_stood,before_passed,before_visits,"
      "before_first_s,before_last_s,after_stood,after_passed,after_visits,after_first_s,"
      "after_last_s\r\n";
  for (const Change& change : changes.changes) {
    text += std::to_string(change.id) + ',' + to_string(change.kind) + ',' +
            (change.room ? std::to_string(*change.room) : "") + ',' +
            io::csv_text(change.room_name) + ',' +
            (change.door ? std::to_string(*change.door) : "");
    io::add_csv(text, to_millimetre(change.at.x()));
    io::add_csv(text, to_millimetre(change.at.y()));
    io::add_csv(text, to_millimetre(change.size_m));
    text += row_of(change.before) + row_of(change.after) + "\r\n";
  }
  for (const OneSidedRoom& room : changes.rooms) {
    text += std::string(",") + to_string(room) + ',' + std::to_string(room.room) + ',' +
            io::csv_text(room.name) + std::string(14, ',') + "\r\n";
  }
  return text;
}

std::string changes_json(const PlanChanges& changes) {
  const Pose2& pose = changes.old_from_new;
  Json json;
  json["old_from_new"] = {{"x_m", to_millimetre(pose.x_m)},
                          {"y_m", to_millimetre(pose.y_m)},
                          {"theta_deg", to_millimetre(degrees(pose.theta_rad))}};
  json["tells_changes"] = changes.tells_changes;
  json["compared_m2"] = to_millimetre(changes.compared_m2);
  json["changes"] = Json::array();
  for (const Change& change : changes.changes) json["changes"].push_back(properties_of(change));
  json["rooms"] = Json::array();
  for (const OneSidedRoom& room : changes.rooms) json["rooms"].push_back(properties_of(room));
  double unseen_m2 = 0.0;
  for (const Polygon& piece : changes.not_seen_again) unseen_m2 += area(piece);
  json["not_seen_again_m2"] = to_millimetre(unseen_m2);
  return compact(json) + "\n";
}

}  // namespace roomatlas
