// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON: worlds and plans of ours, rooms of other programs; corrections by hand.
#include "large.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/io/plans/edits_file.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/plans/rooms_geojson.hpp"
#include "roomatlas/simulate/world.hpp"
#include "target.hpp"

namespace roomatlas::fuzz {
namespace {

constexpr const char* kForeignRooms =
    R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:25832"}},
"features":[{"type":"Feature","properties":{"Name":"Kitchen","room":"kitchen"},"geometry":
{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},{"type":"Feature","properties":
{"ref":12,"indoor":"corridor"},"geometry":{"type":"MultiPolygon","coordinates":[[[[4,0],[8,0],[8,4],
[4,4],[4,0]],[[5,1],[6,1],[6,2],[5,1]]]]}},{"type":"Feature","properties":{"door":"hinged",
"width":"1.0 m"},"geometry":{"type":"Point","coordinates":[4,2]}},{"type":"Feature","properties":
{"indoor":"door"},"geometry":{"type":"LineString","coordinates":[[8.1,1],[8.1,1.8]]}}]})";

constexpr const char* kRoomsOnEarth =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"indoor":"room"},
"geometry":{"type":"Polygon","coordinates":[[[8.4,49.01],[8.40005,49.01],[8.40005,49.01003],
[8.4,49.01003],[8.4,49.01]]]}}]})";

constexpr const char* kEdits =
    R"({"format":"roomatlas-edits","version":1,"frame":"building","edits":[
{"edit":"name_room","room":{"id":3,"at_m":[1.5,2.0],"outline_m":[[0.0,0.0],[3.0,0.0],[3.0,4.0]]},"name":"Kitchen"},
{"edit":"set_room_kind","room":{"at_m":[1.0,2.0]},"kind":"corridor"},
{"edit":"join_rooms","rooms":[{"id":1},{"id":2}]},
{"edit":"split_room","room":{"at_m":[1.0,2.0]},"line_m":[[1.0,0.0],[1.0,4.0]],"thickness_m":0.1},
{"edit":"shut_door","at_m":[1.0,2.0]},{"edit":"open_door","at_m":[1.0,2.0]},
{"edit":"add_door","jambs_m":[[1.0,0.0],[1.0,0.9]]},
{"edit":"move_wall","wall_m":[[1.0,0.0],[1.0,4.0]],"by_m":-0.2},
{"edit":"furniture_to_wall","at_m":[1.0,2.0]},
{"edit":"wall_to_furniture","at_m":[1.0,2.0],"outline_m":[[0.0,0.0],[3.0,0.0],[3.0,4.0]]},
{"edit":"reject_closure","from_time_s":12.5,"to_time_s":80.0},
{"edit":"pin_visits","from_time_s":12.5,"to_time_s":80.0,"from_from_to":{"x_m":1.0,"y_m":0.5,"theta_rad":0.1}}]})";

std::vector<std::string> world_seeds() {
  return {shipped("worlds/two_rooms.geojson"), shipped("worlds/open_hall.geojson"), kForeignRooms,
          kRoomsOnEarth};
}

void read_geojson(const Path& file, const std::string&) {
  const FloorPlan world = read_world(file, {});
  (void)check_world(world);
  (void)to_geojson(world);
}

}  // namespace

std::vector<Target> plan_targets() {
  return {{"worlds", "world.geojson", world_seeds, read_geojson, large_worlds},
          {"plans", "plan.geojson", world_seeds,
           [](const Path& file, const std::string&) { (void)read_plan(file); }},
          {"edits", "edits.json", [] { return std::vector<std::string>{kEdits}; },
           [](const Path& file, const std::string&) { (void)edits_json(read_edits(file)); }}};
}

}  // namespace roomatlas::fuzz
