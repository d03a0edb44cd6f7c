// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_evaluation_json.hpp"
#include "text/json_number.hpp"

#include "roomatlas/evaluate/figures.hpp"
#include "roomatlas/io/results/comparison_text.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

using io::finite;

Json json_of(const ConfidenceInterval& interval) {
  return {{"mean", finite(interval.mean)},
          {"low", finite(interval.low)},
          {"high", finite(interval.high)}};
}

Json json_of(const Figure& figure) {
  Json json = {{"metric", figure.metric},     {"subset", figure.subset},
               {"quantity", figure.quantity}, {"unit", figure.unit},
               {"covered", figure.covered},   {"of", figure.of}};
  json["count"] = figure.statistics.count;
  for (const auto& [name, value] : named(figure.statistics)) json[name] = finite(value);
  json["squared"] = finite(figure.statistics.mean_square);
  if (figure.interval) json["interval"] = json_of(*figure.interval);
  if (figure.against_first) {
    json["less_first"] = json_of(*figure.against_first);
    json["less_first"]["shared"] = figure.shared;
  }
  return json;
}

Json json_of(const MatchUse& use) {
  return {{"exact", use.exact},
          {"nearest", use.nearest},
          {"interpolated", use.interpolated},
          {"carried", use.carried},
          {"largest_gap_s", finite(use.largest_gap_s)}};
}

Json used(const Comparison& comparison) {
  const CompareOptions& options = comparison.options;
  return {{"times", describe(options.match, comparison.carried)},
          {"match", to_string(options.match.match)},
          {"max_gap_s", finite(max_gap_s(options.match, comparison.carried))},
          {"carried", comparison.carried},
          {"split_s", options.split_s},
          {"alignment", to_string(options.ape.alignment)},
          {"pose_relation", to_string(options.ape.relation)},
          {"delta", options.rpe.delta},
          {"delta_unit", to_string(options.rpe.unit)},
          {"all_pairs", options.rpe.all_pairs},
          {"bootstrap",
           {{"method", "circular block, block length the root of the count"},
            {"resamples", options.bootstrap.resamples},
            {"confidence", options.bootstrap.confidence},
            {"seed", options.bootstrap.seed}}}};
}

Json json_of(const JudgedRun& run, const std::vector<Figure>& all) {
  Json json = {{"name", run.name}, {"poses", run.poses}};
  if (run.relations) json["relation_poses"] = json_of(run.relations->errors.use);
  if (run.true_poses) {
    const Pose2& aligned = run.true_poses->ape.truth_from_estimate;
    json["true_poses"] = json_of(run.true_poses->matched.use);
    json["truth_from_run"] = {aligned.x_m, aligned.y_m, aligned.theta_rad};
  }
  json["figures"] = Json::array();
  for (const Figure& figure : all) {
    if (figure.run == run.name) json["figures"].push_back(json_of(figure));
  }
  json["issues"] = Json::array();
  for (const Issue& issue : run.issues) json["issues"].push_back(to_string(issue));
  return json;
}

Json json_of(const JudgedPlan& plan) {
  Json json = {{"name", plan.name}};
  io::add_plan_evaluation(json, plan.evaluation);
  json["issues"] = Json::array();
  for (const Issue& issue : plan.evaluation.issues) json["issues"].push_back(to_string(issue));
  return json;
}

}  // namespace

std::string to_json(const Comparison& comparison, const std::vector<JudgedPlan>& plans) {
  const std::vector<Figure> all = figures(comparison);
  Json json = {{"truth", comparison.truth},
               {"relations", comparison.relations},
               {"true_poses", comparison.true_poses},
               {"used", used(comparison)}};
  json["runs"] = Json::array();
  for (const JudgedRun& run : comparison.runs) json["runs"].push_back(json_of(run, all));
  json["plans"] = Json::array();
  for (const JudgedPlan& plan : plans) json["plans"].push_back(json_of(plan));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace roomatlas
