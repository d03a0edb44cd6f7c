// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/results/report_data.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plans/geojson_geometry.hpp"
#include "roomatlas/draw/assumed_walls.hpp"
#include "roomatlas/draw/plots.hpp"
#include "roomatlas/evaluate/plan_accuracy.hpp"
#include "roomatlas/io/results/judgement_json.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/merge/unexplored.hpp"
#include "store/stored_names.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

constexpr double kPathStep_m = 0.1;  // nearer points of a path are left out: they swell the page

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

Json leaf_of(const PlanDoor& door) {
  return door.leaf ? json_of(Polyline{door.leaf->a, door.leaf->b}) : Json(nullptr);
}

Json furniture_of(const FloorPlan& plan) {
  Json furniture = Json::array();
  for (const PlanFurniture& piece : plan.furniture) {
    furniture.push_back({{"kind", to_string(piece.kind)}, {"rings", json_of(piece.outline)}});
  }
  return furniture;
}

Json edges_of(const FloorPlan& plan) {
  Json edges = Json::array();
  for (const PlanEdge& edge : plan.edges) {
    edges.push_back(
        {{"room", edge.room},
         {"evidence", to_string(edge.evidence)},
         {"deviation_m", edge.deviation_m ? Json(to_millimetre(*edge.deviation_m)) : Json(nullptr)},
         {"line", json_of(Polyline{edge.line.a, edge.line.b})}});
  }
  return edges;
}

Json accuracy_of(const PlanAccuracy& accuracy) {
  const auto rounded = [](const std::optional<double>& value_m) {
    return value_m ? Json(to_millimetre(*value_m)) : Json(nullptr);
  };
  return {{"within_room_m", rounded(accuracy.within_room_m)},
          {"between_rooms_m", rounded(accuracy.between_rooms_m)},
          {"over_building_m", rounded(accuracy.over_building_m)},
          {"extent_m", to_millimetre(accuracy.extent_m)},
          {"probability", accuracy.probability ? Json(*accuracy.probability) : Json(nullptr)}};
}

Json doors_of(const FloorPlan& plan) {
  Json doors = Json::array();
  for (const PlanDoor& door : plan.doors) {
    doors.push_back({{"id", door.id},
                     {"kind", to_string(door.kind)},
                     {"width_m", to_millimetre(door.width_m)},
                     {"a", json_of(door.room_a)},
                     {"b", json_of(door.room_b)},
                     {"at", to_json((door.jambs.a + door.jambs.b) / 2.0)},
                     {"opening", json_of(door.opening)},
                     {"jambs", json_of(Polyline{door.jambs.a, door.jambs.b})},
                     {"leaf", leaf_of(door)}});
  }
  return doors;
}

/// The ellipse that holds the place with a probability of 95 %: radii in metres, and the angle of
/// the first, counter-clockwise from x.
Json ellipse_of(const Eigen::Matrix2d& covariance_m2) {
  constexpr double kQuantile95 = 2.4477;  // sigmas, of two coordinates together
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance_m2);
  const Eigen::Vector2d radii = kQuantile95 * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Vector2d longest = axes.eigenvectors().col(1);
  return Json::array({to_millimetre(radii[1]), to_millimetre(radii[0]),
                      to_millimetre(std::atan2(longest.y(), longest.x()))});
}

Json cause_of(const AsrCorrection& asr) {
  if (!asr.cause) return nullptr;
  return {{"kind", to_string(*asr.cause)}, {"asr", asr.cause_asr}};
}

/// When and where the robot was in the middle of a visit: what statements on closures speak of.
Json middle_of(const std::map<AsrId, StampedPose>& middles, AsrId asr) {
  const auto middle = middles.find(asr);
  if (middle == middles.end()) return nullptr;
  return {{"time_s", middle->second.timestamp_s}, {"at", to_json(middle->second.pose.position())}};
}

Json closures_of(const std::vector<Closure>& closures) {
  Json list = Json::array();
  for (const Closure& closure : closures) {
    if (closure.verdict != ClosureVerdict::accepted) continue;
    list.push_back({{"from", closure.from}, {"to", closure.to}, {"score", closure.score()}});
  }
  return list;
}

Json visits_of(const ReportSources& from) {
  const Correction& correction = from.correction;
  std::map<AsrId, Json> ellipse;
  for (const VisitEstimate& visit : from.uncertainty.visits) {
    ellipse[visit.asr] = ellipse_of(visit.covariance_m2);
  }
  std::map<AsrId, RoomId> room_of;
  for (const AsrVertex& vertex : from.graph.vertices) room_of[vertex.asr] = vertex.room;
  Json visits = Json::array();
  for (const AsrCorrection& asr : correction.asrs) {
    visits.push_back({{"asr", asr.asr},
                      {"room", room_of[asr.asr]},
                      {"before", to_json(asr.building_from_asr_before.position())},
                      {"after", to_json(asr.building_from_asr.position())},
                      {"heading_rad", asr.building_from_asr.theta_rad},
                      {"middle", middle_of(from.middles, asr.asr)},
                      {"moved_m", to_millimetre(asr.moved_m)},
                      {"turned_deg", degrees(asr.turned_rad)},
                      {"chi_square_before", asr.chi_square_before},
                      {"chi_square_after", asr.chi_square_after},
                      {"cause", cause_of(asr)},
                      {"ellipse", ellipse[asr.asr]}});
  }
  return visits;
}

/// A path before and after, point for point, thinned alike.
Json path_of(const Polyline& before, const Polyline& after) {
  Polyline was;
  Polyline is;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!before[i].allFinite() || !after[i].allFinite()) continue;
    const bool is_far = is.empty() || (after[i] - is.back()).norm() >= kPathStep_m ||
                        (before[i] - was.back()).norm() >= kPathStep_m;
    if (!is_far && i + 1 < before.size()) continue;
    was.push_back(before[i]);
    is.push_back(after[i]);
  }
  return {{"before", json_of(was)}, {"after", json_of(is)}};
}

/// Walls and paths, before and after.
void add_mission(const ReportSources& from, Json& data) {
  const PlacedMission& placed = from.placed;
  Json walls_before = Json::array();
  Json walls_after = Json::array();
  for (std::size_t i = 0; i < placed.walls_before.size(); ++i) {
    if (!is_finite(placed.walls_before[i]) || !is_finite(placed.walls_after[i])) continue;
    walls_before.push_back(json_of(placed.walls_before[i]));
    walls_after.push_back(json_of(placed.walls_after[i]));
  }
  Json paths = Json::array();
  for (const ReportedPath& mission : from.missions) {
    paths.push_back(path_of(mission.before, mission.after));
    paths.back()["name"] = mission.name;
  }
  if (from.missions.empty()) {
    Polyline after;
    for (const StampedPose& pose : placed.corrected) after.push_back(pose.pose.position());
    paths.push_back(path_of(placed.path_before, after));
  }
  data["walls_before"] = walls_before;
  data["walls_after"] = walls_after;
  data["paths"] = paths;
}

Json issues_of(const Issues& issues) {
  Json list = Json::array();
  for (const Issue& issue : issues) {
    list.push_back(
        {{"severity", stored_name(kSeverities, issue.severity)}, {"text", to_string(issue)}});
  }
  return list;
}

PlotSeries series_of(const char* name, const RelationErrors& errors) {
  PlotSeries series{name, {}, {}};
  double first_s = std::numeric_limits<double>::infinity();
  for (const RelationError& error : errors.errors) first_s = std::min(first_s, error.t2_s);
  for (const RelationError& error : errors.errors) {
    series.x.push_back(error.t2_s - first_s);
    series.y.push_back(error.translation_m);
  }
  return series;
}

/// At most about two thousand of the poses: a chart is not finer.
PlotSeries series_of(const char* name, const TruePoseErrors& errors) {
  constexpr std::size_t kMost = 2000;  // poses
  PlotSeries series{name, {}, {}};
  const std::size_t stride = errors.errors.size() / kMost + 1;
  for (std::size_t i = 0; i < errors.errors.size(); i += stride) {
    series.x.push_back(errors.errors[i].timestamp_s - errors.errors.front().timestamp_s);
    series.y.push_back(errors.errors[i].position_m);
  }
  return series;
}

/// Errors over time and how they are spread, where there is truth for single ones.
Json charts_of(const std::optional<Evaluation>& evaluation) {
  Json charts = Json::array();
  const auto add = [&](const std::string& what, const std::vector<PlotSeries>& series) {
    charts.push_back(
        {{"title", what + " over time"},
         {"svg", plot_over({what + " over time", "time (s)", "error (m)"}, series, false)}});
    charts.push_back(
        {{"title", what + ", how often"},
         {"svg", plot_histogram({what + ", how often", "error (m)", "share (%)"}, series)}});
  };
  if (!evaluation) return charts;
  if (evaluation->relations && !evaluation->relations->after.errors.empty()) {
    add("Translation error of relations", {series_of("odometry", evaluation->relations->before),
                                           series_of("corrected", evaluation->relations->after)});
  }
  if (evaluation->true_poses && !evaluation->true_poses->after.errors.empty()) {
    add("Position error", {series_of("odometry", evaluation->true_poses->before),
                           series_of("corrected", evaluation->true_poses->after)});
  }
  return charts;
}

}  // namespace

std::string report_data(const ReportSources& from) {
  const auto text = [&](const char* key) {
    const auto entry = from.metadata.find(key);
    return entry == from.metadata.end() ? std::string() : entry->second;
  };
  Json data;
  data["summary"] = Json::parse(
      summary_json(from.metadata, from.correction, from.plan, from.graph, from.evaluation));
  data["date"] = from.date;
  data["tool_version"] = text("tool_version");
  data["configuration"] = text("configuration");
  const std::string edits = text("edits_json");
  data["edits"] = edits.empty() ? Json::array() : Json::parse(edits)["edits"];
  data["rooms"] = rooms_of(from.plan);
  data["doors"] = doors_of(from.plan);
  data["walls"] = json_of(from.plan.walls);
  data["furniture"] = furniture_of(from.plan);
  data["edges"] = edges_of(from.plan);
  data["assumed"] = Json::array();
  for (const Ring& wall : assumed_walls(from.plan)) data["assumed"].push_back(json_of(wall));
  data["issues"] = issues_of(from.plan.issues);
  data["unexplored"] = Json::array();
  if (from.plan.edges.empty()) {  // else these say it
    for (const Polyline& line : unexplored_boundary(from.plan, from.placed.walls_after)) {
      data["unexplored"].push_back(json_of(line));
    }
  }
  data["visits"] = visits_of(from);
  data["closures"] = closures_of(from.closures);
  data["accuracy"] = accuracy_of(plan_accuracy(from.plan, judgement_of(text("judgement_json"))));
  data["charts"] = charts_of(from.evaluation);
  add_mission(from, data);
  return compact(data);
}

}  // namespace roomatlas
