// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "console.hpp"
#include "printable.hpp"
#include "roomatlas/core/counted.hpp"

namespace roomatlas::apps {
namespace {

void print_score(const char* what, const DetectionScore& score, std::int64_t found,
                 std::int64_t wanted) {
  say("  {:<22} {:>4} of {:>4} found, {:>4} true  precision {:.2f}  recall {:.2f}  F1 {:.2f}\n",
      what, score.matched, found, wanted, score.precision, score.recall, score.f1);
}

void print(const Segmentation& areas) {
  say("  areas: recall {:.3f}, precision {:.3f}, Matthews {:.3f}; unlabelled {:.1f} %, invented "
      "{:.1f} %, over-segmented {:.1f} %, under-segmented {:.1f} %\n",
      areas.area_recall, areas.area_precision, areas.matthews, 100.0 * areas.unlabelled,
      100.0 * areas.invented, 100.0 * areas.over_segmentation, 100.0 * areas.under_segmentation);
  if (!areas.split_true_rooms.empty()) {
    say("  true rooms that were split: {}\n",
        fmt::format("{}", fmt::join(areas.split_true_rooms, ", ")));
  }
  if (!areas.merged_rooms.empty()) {
    say("  rooms that are several true ones: {}\n",
        fmt::format("{}", fmt::join(areas.merged_rooms, ", ")));
  }
}

void print(const PlanGraphErrors& graph) {
  say("  graph: {} between rooms, {} true; {}; {} missing, {} extra, {} wrong\n",
      counted(graph.edges, "door"), graph.true_edges,
      graph.as_matched   ? "the same, room by room"
      : graph.isomorphic ? "isomorphic, but not as the rooms were matched"
                         : "not isomorphic",
      graph.missing, graph.extra, graph.wrong);
}

void print(const PlanErrors& plan, const PlanAlignment& alignment) {
  say("plan: laid on the truth by {}\n", to_string(alignment.by));
  print_score("rooms at IoU 0.5",
              {std::ssize(plan.room_matches), plan.precision, plan.recall, plan.f1}, plan.rooms,
              plan.true_rooms);
  print_score("rooms at IoU 0.75", plan.strict, plan.rooms, plan.true_rooms);
  say("  mean IoU: {:.3f} of matched rooms, {:.3f} of all true rooms\n", plan.mean_iou,
      plan.mean_true_iou);
  print(plan.segmentation);
  if (!plan.doors_known) {
    say("  doors: not judged, the truth shows none\n");
    return;
  }
  print_score("doors within 0.5 m", plan.door_score, plan.doors, plan.true_doors);
  say("  doors that the robot used: {} of {} found\n",
      plan.used_true_doors.size() - plan.missed_used_doors.size(), plan.used_true_doors.size());
  for (const DoorMatch& match : plan.door_matches) {
    say("  door {:>3} is true door {:>3}, {:.2f} m apart, {:.2f} m {}\n", match.door,
        match.true_door, match.distance_m, std::abs(match.width_error_m),
        match.width_error_m < 0.0 ? "narrower" : "wider");
  }
  if (!plan.door_matches.empty()) {
    say("  mean error of a door's width: {:.3f} m\n", plan.mean_door_width_error_m);
  }
  if (plan.graph) print(*plan.graph);
}

void print(const WallErrors& walls) {
  say("walls: median, 95 %\n");
  say("  from plan to truth     {:>8.3f} {:>8.3f} m\n", walls.plan_to_truth.median_m,
      walls.plan_to_truth.percentile_95_m);
  say("  from truth to plan     {:>8.3f} {:>8.3f} m (walls of matched rooms)\n",
      walls.truth_to_plan.median_m, walls.truth_to_plan.percentile_95_m);
  print_score("corners within 0.3 m", walls.corner_score, walls.corners, walls.true_corners);
  print_score("... and 15 degrees", walls.angle_score, walls.corners, walls.true_corners);
  say("  mean error of a room's area: {:.1f} %\n", 100.0 * walls.mean_area_error);
  say("  stretch: x {:.4f}, y {:.4f}, both {:.4f} (of {} {})\n", walls.stretch.x, walls.stretch.y,
      walls.stretch.both, walls.stretch.pairs, walls.stretch.of_doors ? "doors" : "corners");
}

void print(const SpanErrors& errors) {
  say("spans: plan, tape, difference\n");
  for (const MeasuredSpan& span : errors.spans) {
    say("  {:<28} {:>8.3f} {:>8.3f} {:>8.3f} m\n", span.name, span.plan_m, span.true_m,
        span.plan_m - span.true_m);
  }
  say("  mean error {:.3f} m, scale {:.4f}\n", errors.error_m.mean, errors.scale);
  show(errors.issues);
}

void print_pair(const char* what, const char* unit, const Statistics& before,
                const Statistics& after) {
  say("  {:<28} {:>8.3f} {:>8.3f} {}\n", what, before.mean, after.mean, unit);
}

void print(const RoomPosesBeforeAfter& poses) {
  if (poses.after.rooms.empty()) return;  // no true pose at their times: there are no means
  say("poses of {}, mean: before, after\n", counted(poses.after.rooms.size(), "room"));
  print_pair("rotation", "deg", poses.before.rotation_deg, poses.after.rotation_deg);
  print_pair("translation", "m", poses.before.translation_m, poses.after.translation_m);
  print_pair("rotation, to the first", "deg", poses.before.relative_rotation_deg,
             poses.after.relative_rotation_deg);
  print_pair("translation, to the first", "m", poses.before.relative_translation_m,
             poses.after.relative_translation_m);
}

void print(const ConsistencyComparison& comparison) {
  say("without truth, each figure better when smaller: before, after, vote\n");
  for (std::size_t i = 0; i < comparison.before.figures.size(); ++i) {
    const ConsistencyValue& before = comparison.before.figures[i];
    const ConsistencyValue& after = comparison.after.figures[i];
    const char* vote = std::isfinite(before.value) && std::isfinite(after.value)
                           ? "none"  // a figure that cannot judge odometry
                           : "not measured";
    for (const FigureVote& cast : comparison.votes) {
      if (cast.figure == before.figure) vote = to_string(cast.vote);
    }
    say("  {:<20} {:>3} {:>9.4f} {:>9.4f}  {}\n", to_string(before.figure), unit_of(before.figure),
        before.value, after.value, vote);
  }
  say("  {:<24} {:>9.4f} {:>9.4f}\n", "sum, over typical sizes", comparison.before.inconsistency,
      comparison.after.inconsistency);
  say("  the corrected map agrees with itself {} than odometry's\n",
      comparison.verdict == Verdict::undecided ? "neither better nor worse"
                                               : to_string(comparison.verdict));
}

std::string label_of(const PlanFigure& figure) {
  return figure.metric + ": " + figure.quantity +
         (figure.unit.empty() ? "" : " (" + figure.unit + ")");
}

std::size_t column_width(const JudgedPlan& plan) {
  constexpr std::size_t kLeast = 16;
  return std::max(kLeast, plan.name.size());
}

std::string cell_of(const PlanFigure& line, const JudgedPlan& plan) {
  for (const PlanFigure& figure : plan_figures(plan.evaluation)) {
    if (!figure.is_like(line)) continue;
    if (!figure.word.empty()) return figure.word;
    const bool is_count = figure.metric == "graph";
    const std::string value = fmt::format("{:.{}f}", figure.value, is_count ? 0 : 3);
    return figure.of > 0 ? fmt::format("{} of {}  {}", figure.covered, figure.of, value) : value;
  }
  return "-";
}

}  // namespace

void print_side_by_side(const std::vector<JudgedPlan>& plans) {
  const std::vector<PlanFigure> lines = lines_of(plans);
  std::size_t width = 0;
  for (const PlanFigure& line : lines) width = std::max(width, label_of(line).size());
  say("plans\n  {:<{}}", "", width);
  for (const JudgedPlan& plan : plans) say("  {:>{}}", plan.name, column_width(plan));
  say("\n");
  for (const PlanFigure& line : lines) {
    say("  {:<{}}", label_of(line), width);
    for (const JudgedPlan& plan : plans) {
      say("  {:>{}}", cell_of(line, plan), column_width(plan));
    }
    say("\n");
  }
  for (const JudgedPlan& plan : plans) {
    if (plan.evaluation.plan) {
      say("{}: laid on the truth by {}\n", plan.name, to_string(plan.evaluation.plan_alignment.by));
    }
    Issues issues = plan.evaluation.issues;
    for (Issue& issue : issues) issue.file = plan.name;
    show(issues);
  }
}

void print_plan_evaluation(const Evaluation& evaluation) {
  if (evaluation.plan) print(*evaluation.plan, evaluation.plan_alignment);
  if (evaluation.walls) print(*evaluation.walls);
  if (evaluation.spans) print(*evaluation.spans);
  if (evaluation.room_poses) print(*evaluation.room_poses);
  if (evaluation.consistency) print(*evaluation.consistency);
}

}  // namespace roomatlas::apps
