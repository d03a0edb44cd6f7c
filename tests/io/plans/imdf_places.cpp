// SPDX-License-Identifier: GPL-3.0-or-later
#include "imdf_places.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas::test::imdf {
namespace {

using Json = nlohmann::json;

/// In metres about the first position of the venue.
class Places {
 public:
  Places(const ImdfFiles& files, std::vector<std::string>& broken)
      : files_(files), broken_(broken) {}

  void check() {
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

 private:
  void require(bool holds, const std::string& sentence) {
    if (!holds) broken_.push_back(sentence);
  }

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
  std::vector<std::string>& broken_;
  Point2 origin_ = Point2::Zero();
  bool has_origin_ = false;
};

}  // namespace

void check_imdf_places(const ImdfFiles& files, std::vector<std::string>& broken) {
  Places(files, broken).check();
}

}  // namespace roomatlas::test::imdf
