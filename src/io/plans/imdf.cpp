// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/imdf.hpp"

#include <map>
#include <set>
#include <utility>

#include "door_sides.hpp"
#include "earth_geometry.hpp"
#include "files/zip_writer.hpp"
#include "geojson_geometry.hpp"
#include "roomatlas/io/plans/feature_ids.hpp"
#include "roomatlas/plan/door_keys.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

constexpr const char* kLanguage = "en";

Json labels(const std::string& name) {
  return name.empty() ? Json(nullptr) : Json{{kLanguage, name}};
}

Json unless_empty(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

std::string or_unknown(const std::string& text, const char* unknown) {
  return text.empty() ? unknown : text;
}

/// The features of the archive, a collection for each type.
class Archive {
 public:
  Archive(const FloorPlan& plan, const ImdfOptions& options)
      : plan_(plan), options_(options), ids_(options.building), covered_(io::covered_by(plan)) {
    for (const PlanDoor& door : plan.doors) sides_.push_back(io::sides_of(door, plan));
  }

  std::string bytes() {
    add_address();
    add_venue();
    add_building();
    add_level();
    add_units();
    add_walls();
    add_openings();
    add_fixtures();
    io::ZipWriter zip;
    zip.add("manifest.json", manifest());
    for (const auto& [type, features] : features_) {
      zip.add(type + ".geojson",
              R"({"type":"FeatureCollection","features":[)" + features + "\n]}\n");
    }
    return zip.finish();
  }

 private:
  [[nodiscard]] std::string manifest() const {
    const std::string date = options_.date.empty() ? "1970-01-01" : options_.date;
    const Json manifest = {{"version", "1.0.0"},
                           {"created", date + "T00:00:00Z"},
                           {"generated_by", "Roomatlas"},
                           {"language", kLanguage},
                           {"extensions", nullptr}};
    return manifest.dump(2) + "\n";
  }
  [[nodiscard]] std::string id(const std::string& thing) const { return ids_.of(thing).text(); }
  [[nodiscard]] Json point(const Point2& at) const {
    return on_earth(options_.on_earth, {{"type", "Point"}, {"coordinates", to_json(at)}});
  }
  [[nodiscard]] Json middle() const {
    return covered_.empty() ? Json(nullptr) : point(interior_point(covered_.front()));
  }
  [[nodiscard]] std::string title() const { return plan_.title.empty() ? "Building" : plan_.title; }

  void add(const std::string& type, const std::string& thing, Json geometry, Json properties) {
    std::string& features = features_[type];
    const Json feature = {{"id", id(thing)},
                          {"type", "Feature"},
                          {"feature_type", type},
                          {"geometry", on_earth(options_.on_earth, std::move(geometry))},
                          {"properties", std::move(properties)}};
    features += (features.empty() ? "\n" : ",\n") + compact(feature);
  }

  void add_address() {
    const PostalAddress& address = options_.address;
    add("address", "address", nullptr,
        {{"address", or_unknown(address.street, "unknown")},
         {"unit", nullptr},
         {"locality", or_unknown(address.locality, "unknown")},
         {"province", nullptr},
         {"country", or_unknown(address.country, "ZZ")},
         {"postal_code", unless_empty(address.postal_code)},
         {"postal_code_ext", nullptr},
         {"postal_code_vanity", nullptr}});
  }

  void add_venue() {
    add("venue", "venue", to_geometry(covered_),
        {{"category", "businesscampus"},
         {"restriction", nullptr},
         {"name", labels(title())},
         {"alt_name", nullptr},
         {"hours", nullptr},
         {"phone", nullptr},
         {"website", nullptr},
         {"display_point", middle()},
         {"address_id", id("address")}});
  }

  void add_building() {
    add("building", "building", nullptr,
        {{"name", labels(title())},
         {"alt_name", nullptr},
         {"category", "unspecified"},
         {"restriction", nullptr},
         {"display_point", middle()},
         {"address_id", id("address")}});
    add("footprint", "footprint", to_geometry(covered_),
        {{"category", "ground"},
         {"name", nullptr},
         {"building_ids", Json::array({id("building")})}});
  }

  void add_level() {
    add("level", "level", to_geometry(covered_),
        {{"category", "unspecified"},
         {"restriction", nullptr},
         {"outdoor", false},
         {"ordinal", 0},
         {"name", labels("Level 0")},
         {"short_name", labels("0")},
         {"display_point", middle()},
         {"address_id", nullptr},
         {"building_ids", Json::array({id("building")})}});
  }

  void add_unit(const std::string& thing, const std::string& category,
                const std::vector<Polygon>& shape, const std::string& name, Json display_point) {
    Json geometry = to_geometry(shape);
    if (geometry["coordinates"].empty()) return;  // too small for the millimetres
    units_.insert(thing);
    add("unit", thing, std::move(geometry),
        {{"category", category},
         {"restriction", nullptr},
         {"accessibility", nullptr},
         {"name", labels(name)},
         {"alt_name", nullptr},
         {"level_id", id("level")},
         {"display_point", std::move(display_point)}});
  }

  static std::string unit_of(RoomId room) { return "room/" + std::to_string(room); }

  void add_units() {
    for (const PlanRoom& room : plan_.rooms) {
      add_unit(unit_of(room.id), imdf_category(room), io::up_to_doors(room, plan_, sides_),
               room.name, point(room.label_point));
    }
  }

  /// What is solid: bodies of walls, and glass where one looks through.
  void add_walls() {
    for (std::size_t i = 0; i < plan_.walls.size(); ++i) {
      add_unit("wall/" + std::to_string(i + 1), "structure",
               io::without_holes_of_doors(plan_.walls[i], plan_), "", nullptr);
    }
    const std::vector<std::string> keys = door_keys(plan_);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const PlanDoor& door = plan_.doors[i];
      if (door.kind != DoorKind::window || door.opening.size() < 3) continue;
      add_unit("window/" + keys[i], "glass", {{door.opening, {}}}, "", nullptr);
    }
  }

  void add_openings() {
    const std::vector<std::string> keys = door_keys(plan_);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const PlanDoor& door = plan_.doors[i];
      if (door.kind == DoorKind::window) continue;
      const Json line = to_geometry(door.jambs);
      if (line.is_null()) continue;
      const Json leaf = door.leaf ? Json{{"type", "swinging"}} : Json(nullptr);
      add("opening", "door/" + keys[i], line,
          {{"category", "pedestrian"},
           {"accessibility", nullptr},
           {"access_control", nullptr},
           {"door", leaf},
           {"name", nullptr},
           {"alt_name", nullptr},
           {"display_point", point((door.jambs.a + door.jambs.b) / 2.0)},
           {"level_id", id("level")}});
      add_traversal(keys[i], door);
    }
  }

  /// From room to room by a door, either way.
  void add_traversal(const std::string& key, const PlanDoor& door) {
    if (!door.room_a || !door.room_b) return;
    const std::string from = unit_of(*door.room_a);
    const std::string to = unit_of(*door.room_b);
    if (!units_.contains(from) || !units_.contains(to)) return;
    const auto reference = [&](const std::string& thing, const char* type) {
      return Json{{"id", id(thing)}, {"feature_type", type}};
    };
    add("relationship", "traversal/" + key, nullptr,
        {{"category", "traversal"},
         {"direction", "undirected"},
         {"origin", reference(from, "unit")},
         {"intermediary", Json::array({reference("door/" + key, "opening")})},
         {"destination", reference(to, "unit")},
         {"hours", nullptr}});
  }

  void add_fixtures() {
    for (std::size_t i = 0; i < plan_.furniture.size(); ++i) {
      Json geometry = to_geometry(std::vector<Polygon>{plan_.furniture[i].outline});
      if (geometry["coordinates"].empty()) continue;
      add("fixture", "fixture/" + std::to_string(i + 1), std::move(geometry),
          {{"category", "furniture"},
           {"name", nullptr},
           {"alt_name", nullptr},
           {"anchor_id", nullptr},
           {"level_id", id("level")},
           {"display_point", nullptr}});
    }
  }

  const FloorPlan& plan_;
  const ImdfOptions& options_;
  FeatureIds ids_;
  std::vector<Polygon> covered_;
  std::vector<io::DoorSides> sides_;
  std::set<std::string> units_;
  std::map<std::string, std::string> features_;  ///< by type, one a line
};

}  // namespace

std::string imdf_archive(const FloorPlan& plan, const ImdfOptions& options) {
  return Archive(plan, options).bytes();
}

}  // namespace roomatlas
