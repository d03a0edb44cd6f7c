// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/plan_figures.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

/// Collects the figures of one plan.
class Lines {
 public:
  void begin(const char* metric) { metric_ = metric; }
  /// Nothing where there is no value.
  void add(const char* quantity, const char* unit, double value) {
    if (std::isfinite(value)) figures_.push_back({metric_, quantity, unit, value, "", 0, 0});
  }
  void add(const char* quantity, double value, std::int64_t covered, std::int64_t of) {
    figures_.push_back({metric_, quantity, "", value, "", covered, of});
  }
  void add_count(const char* quantity, std::int64_t count) {
    add(quantity, "", static_cast<double>(count));
  }
  void add_word(const char* quantity, double value, const char* word) {
    figures_.push_back({metric_, quantity, "", value, word, 0, 0});
  }
  [[nodiscard]] std::vector<PlanFigure> take() { return std::move(figures_); }

 private:
  const char* metric_ = "";
  std::vector<PlanFigure> figures_;
};

double percent(double share) { return 100.0 * share; }

void add_rooms(Lines& lines, const PlanErrors& errors) {
  const std::int64_t matched = std::ssize(errors.room_matches);
  lines.begin("rooms");
  lines.add("precision at IoU 0.5", errors.precision, matched, errors.rooms);
  lines.add("recall at IoU 0.5", errors.recall, matched, errors.true_rooms);
  lines.add("f1 at IoU 0.5", "", errors.f1);
  lines.add("f1 at IoU 0.75", "", errors.strict.f1);
  lines.add("mean IoU of matched rooms", "", errors.mean_iou);
  lines.add("mean IoU of all true rooms", "", errors.mean_true_iou);
  const Segmentation& areas = errors.segmentation;
  lines.add("Matthews correlation", "", areas.matthews);
  lines.add("unlabelled", "%", percent(areas.unlabelled));
  lines.add("invented", "%", percent(areas.invented));
  lines.add("over-segmentation", "%", percent(areas.over_segmentation));
  lines.add("under-segmentation", "%", percent(areas.under_segmentation));
}

void add_doors(Lines& lines, const PlanErrors& errors) {
  if (!errors.doors_known) return;
  const DetectionScore& score = errors.door_score;
  lines.begin("doors");
  lines.add("precision", score.precision, score.matched, errors.doors);
  lines.add("recall", score.recall, score.matched, errors.true_doors);
  lines.add("f1", "", score.f1);
  const std::int64_t used = std::ssize(errors.used_true_doors);
  if (used > 0) {
    const std::int64_t found = used - std::ssize(errors.missed_used_doors);
    lines.add("recall of used doors", static_cast<double>(found) / static_cast<double>(used), found,
              used);
  }
  lines.add("mean distance", "m", errors.mean_door_distance_m);
  lines.add("mean width error", "m", errors.mean_door_width_error_m);
}

void add_graph(Lines& lines, const PlanGraphErrors& graph) {
  lines.begin("graph");
  lines.add_word("isomorphic", graph.isomorphic ? 1.0 : 0.0, graph.isomorphic ? "yes" : "no");
  lines.add_count("edits", graph.edits());
  lines.add_count("missing edges", graph.missing);
  lines.add_count("extra edges", graph.extra);
  lines.add_count("wrong edges", graph.wrong);
}

void add_walls(Lines& lines, const WallErrors& walls) {
  lines.begin("walls");
  lines.add("plan to truth, median", "m", walls.plan_to_truth.median_m);
  lines.add("plan to truth, 95 %", "m", walls.plan_to_truth.percentile_95_m);
  lines.add("truth to plan, median", "m", walls.truth_to_plan.median_m);
  lines.add("truth to plan, 95 %", "m", walls.truth_to_plan.percentile_95_m);
  lines.add("corner precision", walls.corner_score.precision, walls.corner_score.matched,
            walls.corners);
  lines.add("corner recall", walls.corner_score.recall, walls.corner_score.matched,
            walls.true_corners);
  lines.add("angle precision", walls.angle_score.precision, walls.angle_score.matched,
            walls.corners);
  lines.add("angle recall", walls.angle_score.recall, walls.angle_score.matched,
            walls.true_corners);
  lines.add("mean area error", "%", percent(walls.mean_area_error));
  lines.add("stretch", "", walls.stretch.both);
}

void add_room_poses(Lines& lines, const RoomPosesBeforeAfter& poses) {
  lines.begin("room_poses");
  lines.add("mean rotation before", "deg", poses.before.rotation_deg.mean);
  lines.add("mean rotation after", "deg", poses.after.rotation_deg.mean);
  lines.add("mean translation before", "m", poses.before.translation_m.mean);
  lines.add("mean translation after", "m", poses.after.translation_m.mean);
}

void add_consistency(Lines& lines, const ConsistencyComparison& comparison) {
  lines.begin("self");
  for (const ConsistencyValue& figure : comparison.after.figures) {
    lines.add(to_string(figure.figure), unit_of(figure.figure), figure.value);
  }
  lines.add("sum before", "", comparison.before.inconsistency);
  lines.add("sum after", "", comparison.after.inconsistency);
  const Verdict verdict = comparison.verdict;
  lines.add_word("verdict",
                 verdict == Verdict::better  ? 1.0
                 : verdict == Verdict::worse ? -1.0
                                             : 0.0,
                 to_string(verdict));
}

}  // namespace

std::vector<PlanFigure> plan_figures(const Evaluation& evaluation) {
  Lines lines;
  if (evaluation.plan) {
    add_rooms(lines, *evaluation.plan);
    add_doors(lines, *evaluation.plan);
    if (evaluation.plan->graph) add_graph(lines, *evaluation.plan->graph);
  }
  if (evaluation.walls) add_walls(lines, *evaluation.walls);
  if (evaluation.spans) {
    lines.begin("spans");
    lines.add("mean error", "m", evaluation.spans->error_m.mean);
    lines.add("scale", "", evaluation.spans->scale);
  }
  if (evaluation.room_poses) add_room_poses(lines, *evaluation.room_poses);
  if (evaluation.consistency) add_consistency(lines, *evaluation.consistency);
  return lines.take();
}

std::vector<PlanFigure> lines_of(const std::vector<JudgedPlan>& plans) {
  std::vector<PlanFigure> lines;
  for (const JudgedPlan& plan : plans) {
    auto after = lines.begin();  // of the line before, so that the fixed order is kept
    for (const PlanFigure& figure : plan_figures(plan.evaluation)) {
      const auto known = std::find_if(lines.begin(), lines.end(),
                                      [&](const PlanFigure& line) { return line.is_like(figure); });
      after = known != lines.end() ? known + 1 : lines.insert(after, figure) + 1;
    }
  }
  return lines;
}

}  // namespace roomatlas
