// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_evaluation_json.hpp"

#include "missions_json.hpp"
#include "text/json.hpp"
#include "text/json_number.hpp"

namespace roomatlas::io {
namespace {

Json json_of(const DetectionScore& score) {
  return {{"matched", score.matched},
          {"precision", score.precision},
          {"recall", score.recall},
          {"f1", score.f1}};
}

Json json_of(const Segmentation& segmentation) {
  return {{"area_recall", segmentation.area_recall},
          {"area_precision", segmentation.area_precision},
          {"matthews", segmentation.matthews},
          {"unlabelled", segmentation.unlabelled},
          {"invented", segmentation.invented},
          {"over_segmentation", segmentation.over_segmentation},
          {"under_segmentation", segmentation.under_segmentation},
          {"split_true_rooms", segmentation.split_true_rooms},
          {"merged_rooms", segmentation.merged_rooms}};
}

Json json_of(const PlanGraphErrors& graph) {
  return {{"edges", graph.edges},
          {"true_edges", graph.true_edges},
          {"isomorphic", graph.isomorphic},
          {"as_matched", graph.as_matched},
          {"missing", graph.missing},
          {"extra", graph.extra},
          {"wrong", graph.wrong}};
}

Json json_of(const PlanAlignment& alignment) {
  const Pose2& pose = alignment.truth_from_building;
  return {{"by", to_string(alignment.by)},
          {"x_m", pose.x_m},
          {"y_m", pose.y_m},
          {"theta_deg", degrees(pose.theta_rad)}};
}

Json json_of(const WallDistances& distances) {
  return {{"samples", distances.samples},
          {"median_m", finite(distances.median_m)},
          {"percentile_95_m", finite(distances.percentile_95_m)}};
}

Json json_of(const WallErrors& walls) {
  Json areas = Json::array();
  for (const RoomAreaError& area : walls.areas) {
    areas.push_back({{"room", area.room},
                     {"true_room", area.true_room},
                     {"area_m2", area.area_m2},
                     {"true_area_m2", area.true_area_m2}});
  }
  return {{"plan_to_truth", json_of(walls.plan_to_truth)},
          {"truth_to_plan", json_of(walls.truth_to_plan)},
          {"corners", walls.corners},
          {"true_corners", walls.true_corners},
          {"corner_score", json_of(walls.corner_score)},
          {"angle_score", json_of(walls.angle_score)},
          {"areas", areas},
          {"mean_area_error", finite(walls.mean_area_error)},
          {"stretch",
           {{"x", finite(walls.stretch.x)},
            {"y", finite(walls.stretch.y)},
            {"both", finite(walls.stretch.both)},
            {"pairs", walls.stretch.pairs},
            {"of", walls.stretch.of_doors ? "doors" : "corners"}}}};
}

Json json_of(const SpanErrors& errors) {
  Json spans = Json::array();
  for (const MeasuredSpan& span : errors.spans) {
    spans.push_back(
        {{"name", span.name}, {"true_m", span.true_m}, {"plan_m", finite(span.plan_m)}});
  }
  return {{"spans", spans},
          {"mean_error_m", finite(errors.error_m.mean)},
          {"max_error_m", finite(errors.error_m.maximum)},
          {"scale", finite(errors.scale)}};
}

Json json_of(const RoomPoseErrors& errors) {
  Json rooms = Json::array();
  for (const RoomPoseError& room : errors.rooms) {
    rooms.push_back({{"room", room.room},
                     {"visits", room.visits},
                     {"rotation_deg", degrees(room.rotation_rad)},
                     {"translation_m", room.translation_m},
                     {"relative_rotation_deg", degrees(room.relative_rotation_rad)},
                     {"relative_translation_m", room.relative_translation_m}});
  }
  return {{"mean_rotation_deg", finite(errors.rotation_deg.mean)},
          {"mean_translation_m", finite(errors.translation_m.mean)},
          {"mean_relative_rotation_deg", finite(errors.relative_rotation_deg.mean)},
          {"mean_relative_translation_m", finite(errors.relative_translation_m.mean)},
          {"rooms", rooms}};
}

Json json_of(const ConsistencyComparison& comparison) {
  Json figures = Json::array();
  for (std::size_t i = 0; i < comparison.before.figures.size(); ++i) {
    const ConsistencyValue& before = comparison.before.figures[i];
    const ConsistencyValue& after = comparison.after.figures[i];
    Json entry = {{"figure", to_string(before.figure)},
                  {"unit", unit_of(before.figure)},
                  {"before", finite(before.value)},
                  {"after", finite(after.value)},
                  {"measured_before", before.measured},
                  {"measured_after", after.measured},
                  {"vote", nullptr}};
    for (const FigureVote& vote : comparison.votes) {
      if (vote.figure == before.figure) entry["vote"] = to_string(vote.vote);
    }
    figures.push_back(entry);
  }
  return {{"verdict", to_string(comparison.verdict)},
          {"inconsistency_before", comparison.before.inconsistency},
          {"inconsistency_after", comparison.after.inconsistency},
          {"figures", figures}};
}

Json json_of(const PlanErrors& errors) {
  Json rooms = Json::array();
  for (const RoomMatch& match : errors.room_matches) {
    rooms.push_back({{"room", match.room}, {"true_room", match.true_room}, {"iou", match.iou}});
  }
  Json doors = Json::array();
  for (const DoorMatch& match : errors.door_matches) {
    doors.push_back({{"door", match.door},
                     {"true_door", match.true_door},
                     {"distance_m", match.distance_m},
                     {"width_error_m", match.width_error_m}});
  }
  Json json = {{"rooms", errors.rooms},
               {"true_rooms", errors.true_rooms},
               {"precision", finite(errors.precision)},
               {"recall", finite(errors.recall)},
               {"f1", finite(errors.f1)},
               {"mean_iou", finite(errors.mean_iou)},
               {"room_matches", rooms},
               {"door_matches", doors},
               {"used_true_doors", errors.used_true_doors},
               {"missed_used_doors", errors.missed_used_doors},
               {"strict", json_of(errors.strict)},
               {"mean_true_iou", errors.mean_true_iou},
               {"segmentation", json_of(errors.segmentation)}};
  if (errors.doors_known) {
    json["doors"] = json_of(errors.door_score);
    json["mean_door_distance_m"] = finite(errors.mean_door_distance_m);
    json["mean_door_width_error_m"] = finite(errors.mean_door_width_error_m);
  }
  if (errors.graph) json["graph"] = json_of(*errors.graph);
  return json;
}

}  // namespace

void add_plan_evaluation(Json& json, const Evaluation& evaluation) {
  if (evaluation.missions) json["missions"] = json_of(*evaluation.missions);
  if (evaluation.plan) {
    json["plan"] = json_of(*evaluation.plan);
    json["plan"]["alignment"] = json_of(evaluation.plan_alignment);
  }
  if (evaluation.walls) json["walls"] = json_of(*evaluation.walls);
  if (evaluation.spans) json["spans"] = json_of(*evaluation.spans);
  if (evaluation.room_poses) {
    json["room_poses"] = {{"before", json_of(evaluation.room_poses->before)},
                          {"after", json_of(evaluation.room_poses->after)}};
  }
  if (evaluation.consistency) json["consistency"] = json_of(*evaluation.consistency);
}

}  // namespace roomatlas::io
