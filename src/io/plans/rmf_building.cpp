// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/rmf_building.hpp"

#include <map>
#include <set>

#include "plans/geojson_geometry.hpp"
#include "roomatlas/io/plans/route_graph.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

constexpr const char* kLevel = "L1";

// Parameters say their type by a number before the value.
Json word(const std::string& value) { return Json::array({1, value}); }
Json whole(int value) { return Json::array({2, value}); }
Json real(double value) { return Json::array({3, value}); }
Json yes_or_no(bool value) { return Json::array({4, value}); }

class Level {
 public:
  /// Corners of walls, doors and floors are shared; places that lanes join are not.
  std::size_t corner(const Point2& at) {
    const std::pair<double, double> key{to_millimetre(at.x()), to_millimetre(at.y())};
    const auto [entry, is_new] = corners_.try_emplace(key, vertices_.size());
    if (is_new) vertices_.push_back(Json::array({key.first, key.second, 0.0, "", Json::object()}));
    return entry->second;
  }
  /// Names are what tasks are sent to, so none stands twice.
  std::size_t place(const Point2& at, std::string name) {
    const std::string asked = name;
    for (int i = 2; !name.empty() && !names_.insert(name).second; ++i) {
      name = asked + " (" + std::to_string(i) + ")";
    }
    vertices_.push_back(
        Json::array({to_millimetre(at.x()), to_millimetre(at.y()), 0.0, name, Json::object()}));
    return vertices_.size() - 1;
  }
  void wall(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t from = corner(ring[i]);
      const std::size_t to = corner(ring[(i + 1) % ring.size()]);
      if (from == to) continue;
      walls_.push_back(
          Json::array({from, to, {{"alpha", real(1.0)}, {"texture_name", word("default")}}}));
    }
  }
  void door(const PlanDoor& door) {
    doors_.push_back(Json::array({corner(door.jambs.a),
                                  corner(door.jambs.b),
                                  {{"motion_axis", word("start")},
                                   {"motion_degrees", real(90.0)},
                                   {"motion_direction", whole(1)},
                                   {"name", word("door_" + std::to_string(door.id))},
                                   {"plugin", word("normal")},
                                   {"right_left_ratio", real(1.0)},
                                   {"type", word("hinged")}}}));
  }
  void floor(const Ring& ring) {
    Json vertices = Json::array();
    for (const Point2& at : ring) {
      const std::size_t vertex = corner(at);
      if (vertices.empty() || vertices.back() != vertex) vertices.push_back(vertex);
    }
    floors_.push_back({{"parameters",
                        {{"indoor", whole(1)},
                         {"texture_name", word("blue_linoleum")},
                         {"texture_rotation", real(0.0)},
                         {"texture_scale", real(1.0)}}},
                       {"vertices", std::move(vertices)}});
  }
  void lane(std::size_t from, std::size_t to) {
    lanes_.push_back(Json::array({from,
                                  to,
                                  {{"bidirectional", yes_or_no(true)},
                                   {"graph_idx", whole(0)},
                                   {"orientation", word("")},
                                   {"speed_limit", real(0.0)}}}));
  }
  [[nodiscard]] std::string yaml() const {
    return list("doors", doors_) + "    elevation: 0\n" + list("fiducials", {}) +
           list("floors", floors_) + list("lanes", lanes_) + list("measurements", {}) +
           list("models", {}) + list("vertices", vertices_) + list("walls", walls_);
  }

 private:
  static std::string list(const char* name, const std::vector<Json>& items) {
    std::string text = std::string("    ") + name + ":";
    if (items.empty()) return text + " []\n";
    for (const Json& item : items) text += "\n      - " + compact(item);  // YAML has JSON within it
    return text + "\n";
  }

  std::vector<Json> vertices_, walls_, doors_, floors_, lanes_;
  std::map<std::pair<double, double>, std::size_t> corners_;
  std::set<std::string> names_;
};

void add_lanes(const FloorPlan& plan, Level& level) {
  const RouteGraph graph = route_graph_of(plan);
  std::vector<std::size_t> vertex_of;
  for (const RouteNode& node : graph.nodes) {
    std::string name;
    for (const PlanRoom& room : plan.rooms) {
      if (node.room == room.id) name = room.name;
    }
    vertex_of.push_back(level.place(node.at, std::move(name)));
  }
  for (const RouteEdge& edge : graph.edges) level.lane(vertex_of[edge.from], vertex_of[edge.to]);
}

}  // namespace

std::string rmf_building_yaml(const FloorPlan& plan) {
  Level level;
  for (const Polygon& wall : plan.walls) {
    level.wall(wall.outer);
    for (const Ring& hole : wall.holes) level.wall(hole);
  }
  for (const PlanDoor& door : plan.doors) {
    if (door.kind == DoorKind::door) level.door(door);
  }
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) level.floor(part.outer);
  }
  for (const PlanDoor& door : plan.doors) {
    if (door.kind != DoorKind::window && door.opening.size() > 2) level.floor(door.opening);
  }
  add_lanes(plan, level);
  const std::string title = plan.title.empty() ? "building" : plan.title;
  return "coordinate_system: cartesian_meters\ngraphs: {}\nlevels:\n  " + std::string(kLevel) +
         ":\n" + level.yaml() + "lifts: {}\nname: " + compact(title) +
         "\nparameters: {}\nreference_level_name: " + kLevel + "\n";
}

}  // namespace roomatlas
