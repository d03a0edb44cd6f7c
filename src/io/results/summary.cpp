// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/results/summary.hpp"

#include <algorithm>

#include "errors_json.hpp"
#include "plan_evaluation_json.hpp"
#include "plans/geojson_geometry.hpp"
#include "roomatlas/io/results/judgement_json.hpp"
#include "store/stored_habits.hpp"
#include "text/json.hpp"
#include "text/json_number.hpp"

namespace roomatlas {
namespace {

using io::finite;
using io::json_of;

Json json_of(const Issues& issues) {
  Json list = Json::array();
  for (const Issue& issue : issues) list.push_back(to_string(issue));
  return list;
}

Json json_of(const Evaluation& evaluation) {
  Json json = Json::object();
  if (evaluation.relations) {
    json["relations"] = {{"before", json_of(evaluation.relations->before)},
                         {"after", json_of(evaluation.relations->after)}};
  }
  if (evaluation.true_poses) {
    json["true_poses"] = {{"before", json_of(evaluation.true_poses->before)},
                          {"after", json_of(evaluation.true_poses->after)}};
  }
  io::add_plan_evaluation(json, evaluation);
  json["issues"] = json_of(evaluation.issues);
  return json;
}

Json json_of(const FloorPlan& plan) {
  Json rooms = Json::array();
  double area_m2 = 0.0;
  for (const PlanRoom& room : plan.rooms) {
    area_m2 += room.area_m2;
    rooms.push_back({{"id", room.id},
                     {"name", room.name},
                     {"kind", to_string(room.kind)},
                     {"area_m2", room.area_m2},
                     {"asrs", room.asrs}});
  }
  return {{"area_m2", area_m2},
          {"rooms", rooms},
          {"doors", count_of(plan, DoorKind::door)},
          {"passages", count_of(plan, DoorKind::passage)},
          {"windows", count_of(plan, DoorKind::window)},
          {"issues", json_of(plan.issues)}};
}

Json json_of(const RoomGraph& graph) {
  const std::vector<int> component = components_of(graph);
  const std::vector<PassageEdge>& edges = graph.edges;
  const auto recognised = std::count_if(edges.begin(), edges.end(), [](const PassageEdge& edge) {
    return edge.source == EdgeSource::recognised;
  });
  const int components =
      component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
  return {{"asrs", component.size()},
          {"edges", edges.size()},
          {"recognised_doorways", recognised},
          {"components", components},
          {"cycles", cycle_basis(graph).size()}};
}

Json json_of(const Correction& correction) {
  Json asrs = Json::array();
  for (const AsrCorrection& asr : correction.asrs) {
    asrs.push_back({{"asr", asr.asr},
                    {"component", asr.component},
                    {"moved_m", asr.moved_m},
                    {"turned_deg", degrees(asr.turned_rad)},
                    {"chi_square_before", asr.chi_square_before},
                    {"chi_square_after", asr.chi_square_after},
                    {"cause", asr.cause ? Json(to_string(*asr.cause)) : Json(nullptr)},
                    {"cause_asr", asr.cause_asr}});
  }
  Json factors = Json::array();
  for (const FactorReport& factor : correction.factors) {
    factors.push_back({{"kind", to_string(factor.kind)},
                       {"from", factor.from},
                       {"to", factor.to},
                       {"chi_square_before", factor.chi_square_before},
                       {"chi_square_after", factor.chi_square_after},
                       {"weight", factor.weight}});
  }
  const StoredHabits habits = stored(correction.odometry.habits);
  return {{"model", correction.model},
          {"converged", correction.converged},
          {"message", correction.message},
          {"initial_cost", finite(correction.initial_cost)},
          {"final_cost", finite(correction.final_cost)},
          {"iterations", correction.iterations},
          {"odometry_bias",
           {{"heading_deg_per_m", degrees(habits.drift_rad_per_m)},
            {"heading_per_turn", habits.turns_more_per_rad},
            {"asrs", correction.odometry.asrs}}},
          {"asrs", asrs},
          {"factors", factors}};
}

Json json_of(const RecordingInfo& recording) {
  Json topics = Json::array();
  for (const RecordedTopic& topic : recording.topics) {
    topics.push_back({{"name", topic.name},
                      {"type", topic.type},
                      {"messages", topic.messages ? Json(*topic.messages) : Json(nullptr)},
                      {"rate_hz", topic.rate_hz > 0.0 ? Json(topic.rate_hz) : Json(nullptr)},
                      {"frames", topic.frames},
                      {"use", topic.use.empty() ? Json(nullptr) : Json(topic.use)}});
  }
  Json frames = Json::array();
  for (const RecordedFrame& frame : recording.frames) {
    frames.push_back({{"parent", frame.parent},
                      {"child", frame.child},
                      {"fixed", frame.is_fixed},
                      {"transforms", frame.transforms}});
  }
  return {{"topics", topics},
          {"frames", frames},
          {"mapped", recording.choice},
          {"base_frame", recording.base_frame},
          {"odometry_frame", recording.odometry_frame}};
}

Json json_of(const MissionInfo& info) {
  const auto optional = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  Json sensors = Json::array();
  for (const auto& sensor : info.sensors) {
    sensors.push_back({{"kind", sensor->kind == SensorKind::laser ? "laser" : "sonar"},
                       {"beams", sensor->robot_from_beam.size()},
                       {"max_range_m", sensor->max_range_m},
                       {"cone_deg", degrees(2.0 * sensor->half_cone_rad)}});
  }
  return {{"file", std::filesystem::path(info.file).filename().string()},
          {"format", info.format},
          {"lines", info.line_counts},
          {"ignored_lines", info.ignored_line_counts},
          {"malformed_lines", info.malformed_lines},
          {"readings", info.readings},
          {"true_poses", info.true_poses},
          {"odometry", info.odometry},
          {"path_length_m", info.path_length_m},
          {"has_times", info.has_times},
          {"first_timestamp_s", optional(info.first_timestamp_s)},
          {"last_timestamp_s", optional(info.last_timestamp_s)},
          {"steps_back_in_time", info.steps_back_in_time},
          {"robot_length_m", info.footprint.length_m},
          {"robot_width_m", info.footprint.width_m},
          {"sensors", sensors},
          {"issues_not_listed", info.issues_not_listed}};
}

/// Names of files may be no UTF-8: U+FFFD stands for such bytes.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string to_json(const MissionInfo& info) {
  Json json = json_of(info);
  if (info.recording) json["recording"] = json_of(*info.recording);
  json["issues"] = json_of(info.issues);
  return text_of(json);
}

std::string to_json(const OdometryHabits& habits) {
  return text_of({{"lag_s", habits.lag_s},
                  {"bias_deg_per_m", degrees(habits.bias_rad_per_m)},
                  {"turn_gain", habits.turn_gain},
                  {"length_scale", habits.length_scale}});
}

std::string to_json(const Answers& answers) {
  return Json({{"drawn", answers.drawn},
               {"count", answers.count},
               {"first_score_m", answers.first_score},
               {"second_score_m", answers.second_score},
               {"second", answers.second},
               {"text", words(answers)}})
      .dump();
}

std::string to_json(const std::vector<SeenLast>& seen_last) {
  Json missions = Json::array();
  for (const SeenLast& seen : seen_last) {
    Json things = Json::array();
    for (const ThingSeenLast& thing : seen.things) {
      things.push_back({{"kind", to_string(thing.kind)},
                        {"at", {thing.at.x(), thing.at.y()}},
                        {"size_m", thing.size_m}});
    }
    missions.push_back({{"mission", seen.mission}, {"text", words(seen)}, {"things", things}});
  }
  return compact({{"missions", missions}});
}

std::string to_json(const Evaluation& evaluation, const std::optional<Judgement>& judgement,
                    const std::string& answers) {
  Json json = json_of(evaluation);
  if (!answers.empty()) json["answers"] = Json::parse(answers);
  if (judgement) json["judgement"] = Json::parse(to_json(*judgement));
  return text_of(json);
}

Answers answers_in(const std::map<std::string, std::string>& metadata) {
  const auto text = metadata.find("answers_json");
  if (text == metadata.end() || text->second.empty()) return {};
  try {
    const Json json = Json::parse(text->second);
    return {json.at("drawn"), json.at("count"), json.at("first_score_m"), json.at("second_score_m"),
            json.at("second")};
  } catch (const Json::exception& error) {
    throw InputError(std::string("the answers are damaged (") + error.what() +
                     "): assemble the store again");
  }
}

std::string to_json(const Placement& placement) {
  Json visits = Json::array();
  for (const auto& [id, pose] : placement) {
    visits.push_back({id, pose.x_m, pose.y_m, pose.theta_rad});
  }
  return Json({{"visits", visits}}).dump();
}

Placement other_answer_in(const std::map<std::string, std::string>& metadata) {
  const auto text = metadata.find("other_answer_json");
  if (text == metadata.end() || text->second.empty()) return {};
  Placement placement;
  try {
    const Json json = Json::parse(text->second);
    for (const Json& visit : json.at("visits")) {
      const Pose2 pose{visit.at(1), visit.at(2), visit.at(3)};
      if (pose.position().norm() > kFarthest_m)
        throw InputError("metadata.other_answer_json: visit " + visit.at(0).dump() +
                         " lies farther than 1e8 m: assemble the store again");
      placement[visit.at(0)] = pose;
    }
  } catch (const Json::exception& error) {
    throw InputError(std::string("metadata.other_answer_json is damaged (") + error.what() +
                     "): assemble the store again");
  }
  return placement;
}

std::string summary_json(const std::map<std::string, std::string>& metadata,
                         const Correction& correction, const FloorPlan& plan,
                         const RoomGraph& graph, const std::optional<Evaluation>& evaluation) {
  Json json;
  const auto mission = metadata.find("mission_json");
  if (mission != metadata.end()) json["mission"] = Json::parse(mission->second);
  const auto hash = metadata.find("mission_sha256");
  if (hash != metadata.end()) json["mission"]["sha256"] = hash->second;
  const auto habits = metadata.find("odometry_json");
  if (habits != metadata.end()) json["odometry"] = Json::parse(habits->second);
  const auto judgement = metadata.find("judgement_json");
  if (judgement != metadata.end() && !judgement->second.empty()) {
    json["judgement"] = Json::parse(judgement->second);
  }
  const auto answers = metadata.find("answers_json");
  if (answers != metadata.end() && !answers->second.empty()) {
    json["answers"] = Json::parse(answers->second);
  }
  const auto seen_last = metadata.find("seen_last_json");
  if (seen_last != metadata.end() && !seen_last->second.empty()) {
    json["seen_last"] = Json::parse(seen_last->second);
  }
  json["plan"] = json_of(plan);
  json["room_graph"] = json_of(graph);
  json["correction"] = json_of(correction);
  if (evaluation) json["evaluation"] = json_of(*evaluation);
  return text_of(json);
}

}  // namespace roomatlas
