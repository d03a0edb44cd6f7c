// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/georeference.hpp"

#include <cmath>

#include "earth_geometry.hpp"
#include "geojson_geometry.hpp"
#include "plan_schema.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

// WGS 84.
constexpr double kSemiMajor_m = 6378137.0;
constexpr double kFlattening = 1.0 / 298.257223563;  // of the ellipsoid

class Features {
 public:
  explicit Features(const GeoReference& reference) : reference_(reference) {}

  void add(Json properties, Json geometry) {
    if (geometry["coordinates"].empty()) return;
    const Json feature = {{"type", "Feature"},
                          {"properties", std::move(properties)},
                          {"geometry", on_earth(reference_, std::move(geometry))}};
    text_ += (text_.empty() ? "\n" : ",\n") + compact(feature);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  const GeoReference& reference_;
  std::string text_;
};

Json tags_of(const PlanRoom& room) {
  Json tags;
  for (const auto& word : plan_schema::kRoomWords) {
    if (word.kind == room.kind) tags["indoor"] = word.indoor;
  }
  tags["level"] = "0";
  tags["ref"] = std::to_string(room.id);
  tags["name"] = room.name;
  tags["area_m2"] = to_millimetre(room.area_m2);
  return tags;
}

Json tags_of(const PlanDoor& door) {
  const auto ref = [](const std::optional<RoomId>& id) {
    return id ? Json(std::to_string(*id)) : Json(nullptr);
  };
  return {{"indoor", "door"},
          {"door", "yes"},
          {"level", "0"},
          {"ref", std::to_string(door.id)},
          {"width", to_millimetre(door.width_m)},
          {"rooms", Json::array({ref(door.room_a), ref(door.room_b)})}};
}

void add_bodies(Features& features, const std::vector<Polygon>& bodies, const Json& tags) {
  for (const Polygon& body : bodies) features.add(tags, to_geometry(std::vector<Polygon>{body}));
}

}  // namespace

GeoPosition position_on_earth(const GeoReference& reference, const Point2& building) {
  const double heading_rad = radians(reference.heading_deg);
  const double east_m = building.x() * std::cos(heading_rad) + building.y() * std::sin(heading_rad);
  const double north_m =
      building.y() * std::cos(heading_rad) - building.x() * std::sin(heading_rad);
  const double latitude_rad = radians(reference.latitude_deg);
  const double eccentricity_2 = kFlattening * (2.0 - kFlattening);  // squared
  const double w_2 = 1.0 - eccentricity_2 * std::pow(std::sin(latitude_rad), 2);
  const double normal_m = kSemiMajor_m / std::sqrt(w_2);
  const double meridian_m = normal_m * (1.0 - eccentricity_2) / w_2;
  return {reference.latitude_deg + degrees(north_m / meridian_m),
          reference.longitude_deg + degrees(east_m / (normal_m * std::cos(latitude_rad)))};
}

std::string to_geojson(const FloorPlan& plan, const GeoReference& reference) {
  Features features(reference);
  for (const PlanRoom& room : plan.rooms) features.add(tags_of(room), to_geometry(room.parts));
  for (const PlanDoor& door : plan.doors) {
    const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
    features.add(tags_of(door), {{"type", "Point"}, {"coordinates", to_json(middle)}});
  }
  add_bodies(features, plan.walls, {{"indoor", "wall"}, {"level", "0"}});
  add_bodies(features, outlines_of(plan.furniture), {{"level", "0"}, {"furniture", "yes"}});
  for (const PlanEdge& edge : plan.edges) {
    features.add({{"evidence", to_string(edge.evidence)},
                  {"level", "0"},
                  {"room", std::to_string(edge.room)}},
                 to_geometry(edge.line));
  }
  const Json header = {{"schema", "plan on earth"},
                       {"title", plan.title},
                       {"origin", position_json(reference, {0.0, 0.0})},
                       {"heading_deg", reference.heading_deg}};
  return "{\"type\":\"FeatureCollection\",\n\"roomatlas\":" + compact(header) +
         ",\n\"features\":[" + features.text() + "\n]}\n";
}

}  // namespace roomatlas
