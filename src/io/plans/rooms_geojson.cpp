// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/rooms_geojson.hpp"
#include "roomatlas/io/files/input_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "geojson_geometry.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/plans/georeference.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "text/json.hpp"
#include "text/parse_json.hpp"
#include "walls_of_rooms.hpp"

namespace roomatlas {
namespace {

constexpr double kUsualDoor_m = 0.9;

std::string lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// A feature's properties, by their names in any case, as text; empty where there is none.
class Tags {
 public:
  explicit Tags(const Json& feature) {
    const auto properties = feature.find("properties");
    if (properties == feature.end() || !properties->is_object()) return;
    for (const auto& [key, value] : properties->items()) {
      if (value.is_string()) tags_[lower(key)] = value.get<std::string>();
      if (value.is_number()) tags_[lower(key)] = value.dump();
    }
  }
  [[nodiscard]] std::string first(std::initializer_list<const char*> keys) const {
    for (const char* key : keys) {
      const auto found = tags_.find(key);
      if (found != tags_.end() && !found->second.empty()) return found->second;
    }
    return "";
  }

 private:
  std::map<std::string, std::string> tags_;
};

/// What a feature is of a building.
enum class Part { room, door, wall, furniture, other };

Part part_of(const Tags& tags, const std::string& geometry) {
  const std::string word = lower(tags.first({"kind", "indoor"}));
  const std::string door = lower(tags.first({"door", "entrance"}));
  const bool is_area = geometry == "Polygon" || geometry == "MultiPolygon";
  if (word == "door" || (!is_area && !door.empty() && door != "no")) return Part::door;
  if (!is_area || word == "level" || word == "edge") return Part::other;
  if (word == "wall") return Part::wall;
  const std::string furniture = lower(tags.first({"furniture"}));
  if (word == "furniture" || (!furniture.empty() && furniture != "no")) return Part::furniture;
  const bool is_outline = word.empty() && !tags.first({"building"}).empty();
  return is_outline ? Part::other : Part::room;
}

RoomKind kind_of(const Tags& tags) {
  const std::string word = lower(tags.first({"kind", "indoor", "room"}));
  if (word == "corridor") return RoomKind::corridor;
  return word == "hall" || word == "area" ? RoomKind::hall : RoomKind::room;
}

/// "0.9", "0.9 m"; as usual where the file says nothing that is a width.
double width_of(const Tags& tags) {
  constexpr double kNarrowest_m = 0.01;
  constexpr double kWidest_m = 20.0;
  const double width_m = std::strtod(tags.first({"width_m", "width"}).c_str(), nullptr);
  return width_m >= kNarrowest_m && width_m < kWidest_m ? width_m : kUsualDoor_m;
}

/// All positions, of any depth.
void add_positions(const Json& coordinates, Polyline& points) {
  if (!coordinates.is_array() || coordinates.empty()) return;
  if (coordinates[0].is_number()) {
    if (coordinates.size() >= 2 && coordinates[1].is_number()) {
      points.emplace_back(coordinates[0].get<double>(), coordinates[1].get<double>());
    }
    return;
  }
  for (const Json& inner : coordinates) add_positions(inner, points);
}

/// From a file's coordinates to metres.
struct ToMetres {
  Point2 origin = Point2::Zero();   ///< in the file's units
  Point2 scale = Point2(1.0, 1.0);  ///< metres a unit
  [[nodiscard]] Point2 operator()(const Point2& at) const {
    return (at - origin).cwiseProduct(scale);
  }
  [[nodiscard]] Ring operator()(Ring ring) const {
    for (Point2& point : ring) point = (*this)(point);
    return ring;
  }
};

std::string crs_of(const Json& json) {
  const auto name = json.contains("/crs/properties/name"_json_pointer)
                        ? json.at("/crs/properties/name"_json_pointer)
                        : Json(nullptr);
  return name.is_string() ? name.get<std::string>() : "";
}

std::string degrees_text(double value_deg) {
  std::string text = std::to_string(value_deg);  // six decimals: a decimetre
  return text;
}

/// Decided by what a building can be: one of less than a fifth of a degree is on the earth, and
/// none is smaller than that in metres.
ToMetres metres_of(const Json& json, const Box2& box, const Path& file, Issues& issues) {
  constexpr double kLargest_deg = 0.2;
  constexpr double kFar_m = 10000.0;
  const std::string crs = crs_of(json);
  for (const char* mercator : {"EPSG::3857", "EPSG:3857", "EPSG::900913", "EPSG:900913"}) {
    if (crs.find(mercator) == std::string::npos) continue;
    throw InputError(file.string() + ": crs " + crs +
                     ": Web Mercator's metres are too long away from the equator: save it in the "
                     "UTM zone of the place, or in longitude and latitude (EPSG:4326)");
  }
  ToMetres metres;
  const Point2 middle = (box.min + box.max) / 2.0;
  const bool is_small = box.size().maxCoeff() < kLargest_deg;
  if (is_small && std::abs(middle.x()) <= 180.0 && std::abs(middle.y()) <= 85.0) {
    const GeoReference here{middle.y(), middle.x(), 0.0};
    constexpr double kFar = 1000.0;
    metres.origin = middle;
    metres.scale = {kFar / (position_on_earth(here, {kFar, 0.0}).longitude_deg - middle.x()),
                    kFar / (position_on_earth(here, {0.0, kFar}).latitude_deg - middle.y())};
    issues.push_back({Severity::warning, file.filename().string(), 0, "coordinates",
                      "taken for longitude and latitude, and laid out in metres east and north of "
                      "longitude " +
                          degrees_text(middle.x()) + ", latitude " + degrees_text(middle.y())});
    return metres;
  }
  if (box.min.cwiseAbs().maxCoeff() > kFar_m) {
    metres.origin = box.min.array().floor();
    issues.push_back({Severity::warning, file.filename().string(), 0, "coordinates",
                      "taken for metres, of which " +
                          std::to_string(std::llround(metres.origin.x())) + " east and " +
                          std::to_string(std::llround(metres.origin.y())) +
                          " north are taken off"});
  }
  return metres;
}

/// Takes up features one after the other.
class Building {
 public:
  Building(const ToMetres& metres, std::string file) : metres_(metres), file_(std::move(file)) {}

  void add(const Json& feature, std::size_t number) {
    const std::string place = "features[" + std::to_string(number) + "]";
    const auto geometry = feature.find("geometry");
    const bool has_geometry = geometry != feature.end() && geometry->is_object() &&
                              geometry->contains("type") && geometry->at("type").is_string();
    if (!has_geometry) return leave_out();
    const Tags tags(feature);
    const JsonField field(*geometry, file_, place + ".geometry");
    switch (part_of(tags, geometry->at("type").get<std::string>())) {
      case Part::room:
        return add_room(tags, polygons(field));
      case Part::door:
        return add_door(tags, *geometry);
      case Part::wall:
        for (Polygon& body : polygons(field)) plan_.walls.push_back(std::move(body));
        return;
      case Part::furniture:
        for (Polygon& body : polygons(field)) {
          plan_.furniture.push_back({std::move(body), FurnitureKind::free_standing});
        }
        return;
      case Part::other:
        return leave_out();
    }
  }

  FloorPlan finished() {
    if (plan_.rooms.empty()) {
      throw InputError(file_ +
                       ": holds no polygon that is a room: is it the right file, and whole?");
    }
    if (levels_.size() > 1) {
      std::string names;
      for (const std::string& level : levels_) names += (names.empty() ? "" : ", ") + level;
      throw InputError(file_ + ": has rooms of " + counted(levels_.size(), "level") + " (" + names +
                       "), expected one: save each level as a file of its own");
    }
    add_doors();
    if (plan_.walls.empty()) {
      plan_.walls = io::walls_of_rooms(plan_);
      say(Severity::note, "walls", "the file has none: thin ones stand along the rooms' edges");
    }
    if (left_out_ > 0) {
      say(Severity::warning, "features",
          counted(left_out_, "feature") + " left out: neither room, door, wall nor furniture");
    }
    return std::move(plan_);
  }

 private:
  void leave_out() { ++left_out_; }
  void say(Severity severity, const char* what, const std::string& text) {
    plan_.issues.push_back({severity, Path(file_).filename().string(), 0, what, text});
  }

  std::vector<Polygon> polygons(const JsonField& geometry) const {
    std::vector<Polygon> all = read_polygons(geometry);
    for (Polygon& polygon : all) {
      polygon.outer = metres_(std::move(polygon.outer));
      for (Ring& hole : polygon.holes) hole = metres_(std::move(hole));
    }
    return all;
  }

  void add_room(const Tags& tags, std::vector<Polygon> parts) {
    if (parts.empty()) return leave_out();
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
    PlanRoom room;
    room.id = static_cast<RoomId>(plan_.rooms.size()) + 1;
    room.kind = kind_of(tags);
    room.name = tags.first({"name", "ref", "label", "title"});
    if (room.name.empty()) room.name = std::to_string(room.id);
    for (const Polygon& part : parts) room.area_m2 += area(part);
    room.label_point = label_point_in(parts.front());
    room.parts = std::move(parts);
    plan_.rooms.push_back(std::move(room));
    levels_.insert(tags.first({"level"}));
  }

  void add_door(const Tags& tags, const Json& geometry) {
    Polyline points;
    if (geometry.contains("coordinates")) add_positions(geometry.at("coordinates"), points);
    if (points.empty()) return leave_out();
    for (Point2& point : points) point = metres_(point);
    io::ShownDoor door{points.front(), width_of(tags)};
    if (geometry.at("type") == "LineString" && points.size() > 1) {
      door = {(points.front() + points.back()) / 2.0, (points.back() - points.front()).norm()};
    } else if (points.size() > 1) {
      points.pop_back();  // of a closed ring
      Point2 sum = Point2::Zero();
      for (const Point2& point : points) sum += point;
      door.at = sum / static_cast<double>(points.size());
    }
    if (!(door.width_m > 0.0)) return leave_out();
    shown_.push_back(door);
  }

  void add_doors() {
    std::size_t astray = 0;
    for (const io::ShownDoor& shown : shown_) {
      const auto id = static_cast<DoorId>(plan_.doors.size()) + 1;
      if (auto door = io::door_of_rooms(plan_.rooms, shown, id)) {
        plan_.doors.push_back(std::move(*door));
      } else {
        ++astray;
      }
    }
    if (astray > 0) {
      say(Severity::warning, "doors",
          counted(astray, "door") + " left out: no room's edge is within 0.6 m");
    }
    if (plan_.doors.empty() && plan_.rooms.size() > 1) {
      say(Severity::warning, "doors",
          "the file shows none, so no room leads to another: add points or lines with the "
          "property door=yes, and width in metres");
    }
  }

  ToMetres metres_;
  std::string file_;
  FloorPlan plan_;
  std::vector<io::ShownDoor> shown_;
  std::set<std::string> levels_;
  std::size_t left_out_ = 0;
};

FloorPlan read_rooms(const Json& json, const Path& file) {
  const auto features = json.find("features");
  if (features == json.end() || !features->is_array()) {
    throw InputError(file.string() + ": features: expected a list, found none");
  }
  Box2 box;
  Polyline points;
  for (const Json& feature : *features) {
    if (!feature.is_object() || !feature.contains("geometry")) continue;
    const Json& geometry = feature.at("geometry");
    if (geometry.is_object() && geometry.contains("coordinates")) {
      add_positions(geometry.at("coordinates"), points);
    }
  }
  for (const Point2& point : points) {
    if (!(point.cwiseAbs().maxCoeff() <= kFarthest_m)) {
      throw InputError(file.string() +
                       ": coordinates: expected places within 100,000 km, found one beyond: is the "
                       "file damaged?");
    }
    box.extend(point);
  }
  Issues issues;
  const ToMetres metres = points.empty() ? ToMetres{} : metres_of(json, box, file, issues);
  Building building(metres, file.string());
  for (std::size_t i = 0; i < features->size(); ++i) building.add((*features)[i], i);
  FloorPlan plan = building.finished();
  plan.title = file.stem().string();
  plan.issues.insert(plan.issues.begin(), issues.begin(), issues.end());
  return plan;
}

}  // namespace

FloorPlan read_any_plan(const Path& file) {
  const std::string text = read_text_file(file);
  const bool is_deep = io::nests_too_deep(text);
  const Json json = is_deep ? Json(nullptr) : Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("type", Json()) != "FeatureCollection") {
    return read_plan(file);  // which says what is wrong
  }
  const Json schema = json.contains("/roomatlas/schema"_json_pointer)
                          ? json.at("/roomatlas/schema"_json_pointer)
                          : Json(nullptr);
  const bool is_plain = !json.contains("roomatlas") || schema == "plan on earth";
  return is_plain ? read_rooms(json, file) : read_plan(file);
}

}  // namespace roomatlas
