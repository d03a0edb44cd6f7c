// SPDX-License-Identifier: GPL-3.0-or-later
#include "imdf_rules.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <regex>
#include <set>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;

std::uint32_t number_at(const std::string& bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = count; i-- > 0;) {
    value = (value << 8U) | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
  }
  return value;
}

/// What the specification's tables of properties say: which must be there, and may be null where
/// marked so.
enum class Kind {
  text,
  text_or_null,
  labels,
  labels_or_null,
  point,
  point_or_null,
  id,
  id_or_null,
  ids,
  ids_or_null,
  truth,
  whole,
  category,
  null_or_list,
  door_or_null,
  reference_or_null,
  references_or_null,
};
using Keys = std::map<std::string, Kind>;

struct Type {
  std::set<std::string> geometries;  ///< empty: null
  std::set<std::string> categories;
  Keys keys;
};

const std::set<std::string> kPolygonal = {"Polygon", "MultiPolygon"};

const std::map<std::string, Type>& types() {
  using enum Kind;
  static const std::map<std::string, Type> table = {
      {"address",
       {{},
        {},
        {{"address", text},
         {"unit", text_or_null},
         {"locality", text},
         {"province", text_or_null},
         {"country", text},
         {"postal_code", text_or_null},
         {"postal_code_ext", text_or_null},
         {"postal_code_vanity", text_or_null}}}},
      {"venue",
       {kPolygonal,
        {"airport", "businesscampus", "university", "healthcarefacility", "hotel", "museum"},
        {{"category", category},
         {"restriction", text_or_null},
         {"name", labels},
         {"alt_name", labels_or_null},
         {"hours", text_or_null},
         {"phone", text_or_null},
         {"website", text_or_null},
         {"display_point", point},
         {"address_id", id}}}},
      {"building",
       {{},
        {"parking", "transit", "transit.bus", "transit.train", "unspecified"},
        {{"category", category},
         {"restriction", text_or_null},
         {"name", labels_or_null},
         {"alt_name", labels_or_null},
         {"display_point", point_or_null},
         {"address_id", id_or_null}}}},
      {"footprint",
       {kPolygonal,
        {"aerial", "ground", "subterranean"},
        {{"category", category}, {"name", labels_or_null}, {"building_ids", ids}}}},
      {"level",
       {kPolygonal,
        {"arrivals", "departures", "parking", "transit", "unspecified"},
        {{"category", category},
         {"restriction", text_or_null},
         {"outdoor", truth},
         {"ordinal", whole},
         {"name", labels},
         {"short_name", labels},
         {"display_point", point_or_null},
         {"address_id", id_or_null},
         {"building_ids", ids_or_null}}}},
      {"unit",
       {kPolygonal,
        {"auditorium", "classroom",   "conferenceroom", "elevator", "escalator", "glass",
         "kitchen",    "laboratory",  "library",        "lobby",    "lounge",    "office",
         "restroom",   "room",        "serverroom",     "shower",   "stairs",    "storage",
         "structure",  "unspecified", "walkway"},
        {{"category", category},
         {"restriction", text_or_null},
         {"accessibility", null_or_list},
         {"name", labels_or_null},
         {"alt_name", labels_or_null},
         {"level_id", id},
         {"display_point", point_or_null}}}},
      {"opening",
       {{"LineString"},
        {"automobile", "bicycle", "emergencyexit", "pedestrian", "pedestrian.principal",
         "pedestrian.transit", "service"},
        {{"category", category},
         {"accessibility", null_or_list},
         {"access_control", null_or_list},
         {"door", door_or_null},
         {"name", labels_or_null},
         {"alt_name", labels_or_null},
         {"display_point", point_or_null},
         {"level_id", id}}}},
      {"fixture",
       {kPolygonal,
        {"desk", "equipment", "furniture", "obstruction", "stage", "vegetation", "wall", "water"},
        {{"category", category},
         {"name", labels_or_null},
         {"alt_name", labels_or_null},
         {"anchor_id", id_or_null},
         {"level_id", id},
         {"display_point", point_or_null}}}},
      {"relationship",
       {{},
        {"elevator", "escalator", "movingwalkway", "ramp", "stairs", "traversal", "traversal.path"},
        {{"category", category},
         {"direction", text},
         {"origin", reference_or_null},
         {"intermediary", references_or_null},
         {"destination", reference_or_null},
         {"hours", text_or_null}}}}};
  return table;
}

bool is_uuid(const Json& value) {
  static const std::regex form(
      "[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}");
  return value.is_string() && std::regex_match(value.get<std::string>(), form);
}

class Rules {
 public:
  explicit Rules(const ImdfFiles& files) : files_(files) {
    for (const auto& [name, content] : files) {
      if (name != "manifest.json") read_collection(name, content);
    }
  }

  std::vector<std::string> broken() {
    check_manifest();
    for (const char* needed : {"address", "venue", "building", "footprint", "level", "unit"}) {
      require(!imdf_features(files_, needed).empty(), std::string("there is no ") + needed);
    }
    for (const Json& feature : features_) check(feature);
    check_places();
    return broken_;
  }

 private:
  void require(bool holds, const std::string& sentence) {
    if (!holds) broken_.push_back(sentence);
  }

  void read_collection(const std::string& name, const Json& content) {
    const std::string type = name.substr(0, name.rfind(".geojson"));
    require(name.ends_with(".geojson") && types().contains(type), name + " is no type's file");
    require(content.value("type", "") == "FeatureCollection", name + " is no FeatureCollection");
    for (const Json& feature : content["features"]) {
      require(feature.value("feature_type", "") == type, name + " holds another type");
      require(is_uuid(feature["id"]), name + ": an id is no UUID of version 4");
      const std::string id = feature["id"];
      require(type_of_.emplace(id, type).second, name + ": id " + id + " stands twice");
      features_.push_back(feature);
    }
  }

  void check_manifest() {
    if (!files_.contains("manifest.json")) return require(false, "there is no manifest");
    const Json& manifest = files_.at("manifest.json");
    require(manifest.value("version", "") == "1.0.0", "the manifest's version is not 1.0.0");
    static const std::regex time(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(Z|[+-]\d\d:\d\d))");
    require(std::regex_match(manifest.value("created", ""), time), "created is no date-time");
    language_ = manifest.value("language", "");
    require(!language_.empty(), "the manifest has no language");
  }

  void check(const Json& feature) {
    const std::string type = feature["feature_type"];
    const Type& rules = types().at(type);
    const std::string name = type + " " + feature["id"].get<std::string>();
    require(feature.value("type", "") == "Feature", name + " is no Feature");
    const Json& geometry = feature.at("geometry");
    if (rules.geometries.empty()) {
      require(geometry.is_null(), name + " has a geometry");
    } else {
      const std::string kind = geometry.is_object() ? geometry.value("type", "") : "null";
      require(rules.geometries.contains(kind), name + " has a geometry of type " + kind);
    }
    const Json& properties = feature.at("properties");
    for (const auto& [key, kind] : rules.keys) {
      if (!properties.contains(key)) {
        require(false, name + " lacks " + key);
      } else {
        require(is(kind, properties[key], rules),
                name + ": " + key + " is " + properties[key].dump());
      }
    }
    for (const auto& [key, value] : properties.items()) {
      require(rules.keys.contains(key), name + " has " + key);
      if (key.ends_with("_id") && value.is_string())
        refer(name, value, key.substr(0, key.size() - 3));
      if (key.ends_with("_ids") && value.is_array()) {
        for (const Json& one : value) refer(name, one, key.substr(0, key.size() - 4));
      }
      if (key == "country") {
        require(std::regex_match(value.get<std::string>(), std::regex("[A-Z]{2}")),
                name + ": country is no code");
      }
    }
  }

  void refer(const std::string& from, const Json& id, const std::string& type) {
    const auto found = type_of_.find(id.is_string() ? id.get<std::string>() : "");
    require(found != type_of_.end() && found->second == type, from + " names no " + type);
  }

  bool is_reference(const Json& value) {
    if (!value.is_object()) return false;
    refer("a relationship", value.value("id", ""), value.value("feature_type", ""));
    return value.size() == 2;
  }
  bool is_labels(const Json& value) const {
    if (!value.is_object() || !value.contains(language_)) return false;
    return std::all_of(value.begin(), value.end(), [](const Json& one) {
      return one.is_string() && !one.get<std::string>().empty();
    });
  }
  static bool is_point(const Json& value) {
    return value.is_object() && value.value("type", "") == "Point" &&
           value["coordinates"].size() == 2;
  }

  bool is(Kind kind, const Json& value, const Type& rules) {
    const bool is_null = value.is_null();
    switch (kind) {
      case Kind::text:
        return value.is_string() && !value.get<std::string>().empty();
      case Kind::text_or_null:
        return is_null || (value.is_string() && !value.get<std::string>().empty());
      case Kind::labels:
        return is_labels(value);
      case Kind::labels_or_null:
        return is_null || is_labels(value);
      case Kind::point:
        return is_point(value);
      case Kind::point_or_null:
        return is_null || is_point(value);
      case Kind::id:
        return is_uuid(value);
      case Kind::id_or_null:
        return is_null || is_uuid(value);
      case Kind::ids:
        return value.is_array() && !value.empty();
      case Kind::ids_or_null:
        return is_null || (value.is_array() && !value.empty());
      case Kind::truth:
        return value.is_boolean();
      case Kind::whole:
        return value.is_number_integer();
      case Kind::category:
        return value.is_string() && rules.categories.contains(value.get<std::string>());
      case Kind::null_or_list:
        return is_null || value.is_array();
      case Kind::door_or_null:
        return is_null || (value.is_object() && value.value("type", "") == "swinging");
      case Kind::reference_or_null:
        return is_null || is_reference(value);
      case Kind::references_or_null:
        return is_null || (value.is_array() && !value.empty() &&
                           std::all_of(value.begin(), value.end(),
                                       [&](const Json& one) { return is_reference(one); }));
    }
    return false;
  }

  // --- places, in metres about the first position of the venue ---

  Point2 metres(const Json& position) {
    const double longitude = position[0];
    const double latitude = position[1];
    if (!has_origin_) {
      origin_ = {longitude, latitude};
      has_origin_ = true;
    }
    constexpr double kDegree_m = 111320.0;
    return {(longitude - origin_.x()) * kDegree_m * std::cos(radians(origin_.y())),
            (latitude - origin_.y()) * kDegree_m};
  }
  Polygon polygon(const Json& rings, const std::string& name) {
    Polygon shape;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      Ring ring;
      for (const Json& position : rings[i]) ring.push_back(metres(position));
      require(ring.size() >= 4 && rings[i].front() == rings[i].back(), name + ": a ring is open");
      ring.pop_back();
      require((signed_area(ring) > 0.0) == (i == 0), name + ": a ring winds the wrong way");
      if (i == 0) {
        shape.outer = ring;
      } else {
        shape.holes.push_back(ring);
      }
    }
    return shape;
  }
  std::vector<Polygon> shape_of(const Json& feature) {
    const Json& geometry = feature["geometry"];
    const std::string name = feature["feature_type"];
    std::vector<Polygon> shape;
    if (geometry["type"] == "Polygon") {
      shape.push_back(polygon(geometry["coordinates"], name));
    } else {
      for (const Json& rings : geometry["coordinates"]) shape.push_back(polygon(rings, name));
    }
    return shape;
  }
  static double area_of(const std::vector<Polygon>& shape) {
    double sum = 0.0;
    for (const Polygon& part : shape) sum += area(part);
    return sum;
  }
  static double distance_to(const std::vector<Polygon>& shape, const Point2& point) {
    double least = 1e9;
    for (const Polygon& part : shape) {
      least = std::min(least, distance_to_boundary(part.outer, point));
      for (const Ring& hole : part.holes)
        least = std::min(least, distance_to_boundary(hole, point));
    }
    return least;
  }

  void require_inside(const std::vector<Polygon>& inner, const std::vector<Polygon>& outer,
                      const std::string& sentence) {
    constexpr double kSliver_m2 = 2e-3;  // of coordinates that were rounded to a millimetre
    const double beyond_m2 = area_of(difference_of(inner, outer));
    require(beyond_m2 < kSliver_m2 * (1.0 + std::sqrt(area_of(inner))),
            sentence + " by " + std::to_string(beyond_m2) + " m2");
  }

  void check_places() {
    const std::vector<Json> venues = imdf_features(files_, "venue");
    const std::vector<Json> levels = imdf_features(files_, "level");
    if (venues.empty() || levels.empty()) return;
    const std::vector<Polygon> venue = shape_of(venues.front());
    const std::vector<Polygon> level = shape_of(levels.front());
    require_inside(level, venue, "the level is not inside the venue");
    for (const Json& footprint : imdf_features(files_, "footprint")) {
      require_inside(shape_of(footprint), venue, "the footprint is not inside the venue");
    }
    std::map<std::string, std::vector<Polygon>> units;
    for (const Json& unit : imdf_features(files_, "unit")) {
      const std::string id = unit["id"];
      units[id] = shape_of(unit);
      require_inside(units[id], level, "unit " + id + " is not inside the level");
      const Json& at = unit["properties"]["display_point"];
      if (!at.is_object()) continue;
      const Point2 point = metres(at["coordinates"]);
      require(std::any_of(units[id].begin(), units[id].end(),
                          [&](const Polygon& part) { return contains(part, point); }),
              "unit " + id + " has its display point outside");
    }
    for (const auto& [id, shape] : units) {
      for (const auto& [other, its] : units) {
        if (id < other) {
          require(overlap_area(shape, its) < 0.02, "units " + id + " and " + other + " overlap");
        }
      }
    }
    check_openings(units);
  }

  void check_openings(const std::map<std::string, std::vector<Polygon>>& units) {
    constexpr double kOn_m = 0.005;
    std::map<std::string, std::vector<Point2>> openings;
    const auto is_on = [&](const std::string& opening, const std::vector<Polygon>& unit) {
      return std::all_of(openings[opening].begin(), openings[opening].end(),
                         [&](const Point2& point) { return distance_to(unit, point) < kOn_m; });
    };
    for (const Json& opening : imdf_features(files_, "opening")) {
      const Json& line = opening["geometry"]["coordinates"];
      const std::string id = opening["id"];
      const Point2 from = metres(line[0]);
      const Point2 to = metres(line[1]);
      openings[id] = {from, to, (from + to) / 2.0};
      require(std::any_of(units.begin(), units.end(),
                          [&](const auto& unit) { return is_on(id, unit.second); }),
              "opening " + id + " lies on no unit's boundary");
    }
    for (const Json& way : imdf_features(files_, "relationship")) {
      const Json& properties = way["properties"];
      for (const char* end : {"origin", "destination"}) {
        const std::string unit = properties[end]["id"];
        require(units.contains(unit) && is_on(properties["intermediary"][0]["id"], units.at(unit)),
                std::string("a traversal's opening is not on the boundary of its ") + end);
      }
    }
  }

  const ImdfFiles& files_;
  std::vector<Json> features_;
  std::map<std::string, std::string> type_of_;
  std::string language_;
  std::vector<std::string> broken_;
  Point2 origin_ = Point2::Zero();
  bool has_origin_ = false;
};

}  // namespace

std::map<std::string, std::string> unzipped(const std::string& zip) {
  std::map<std::string, std::string> files;
  for (std::size_t at = 0; number_at(zip, at, 4) == 0x04034b50U;) {
    const std::size_t size = number_at(zip, at + 22, 4);
    const std::size_t name = number_at(zip, at + 26, 2);
    const std::size_t extra = number_at(zip, at + 28, 2);
    const std::size_t content = at + 30 + name + extra;
    files[zip.substr(at + 30, name)] = zip.substr(content, size);
    at = content + size;
  }
  return files;
}

ImdfFiles imdf_files(const std::string& zip) {
  ImdfFiles files;
  for (const auto& [name, content] : unzipped(zip)) files[name] = Json::parse(content);
  return files;
}

std::vector<Json> imdf_features(const ImdfFiles& files, const std::string& type) {
  const auto found = files.find(type + ".geojson");
  if (found == files.end()) return {};
  return found->second["features"].get<std::vector<Json>>();
}

std::vector<std::string> broken_imdf_rules(const ImdfFiles& files) { return Rules(files).broken(); }

}  // namespace roomatlas::test
