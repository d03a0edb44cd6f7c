// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/figures.hpp"

#include <algorithm>
#include <array>

namespace roomatlas {
namespace {

struct Subset {
  const char* name;
  RelationSubset RelationErrors::*errors;
};
constexpr std::array kSubsets = {Subset{"all", &RelationErrors::all},
                                 Subset{"local", &RelationErrors::local},
                                 Subset{"loop", &RelationErrors::loop}};

void add_interval(Figure& figure, const JudgedErrors& judged) {
  figure.interval = judged.interval;
  figure.against_first = judged.against_first;
  figure.shared = judged.shared;
}

Figure relation_figure(const JudgedRun& run, const Subset& subset, bool is_translation) {
  const JudgedRelations& judged = *run.relations;
  const RelationSubset& errors = judged.errors.*subset.errors;
  Figure figure;
  figure.run = run.name;
  figure.metric = "relations";
  figure.subset = subset.name;
  figure.quantity = is_translation ? "translation" : "rotation";
  figure.unit = is_translation ? "m" : "deg";
  figure.statistics = is_translation ? errors.translation_m : errors.rotation_deg;
  figure.covered = figure.statistics.count;
  figure.of = judged.errors.relations;
  if (subset.errors == &RelationErrors::all) {
    add_interval(figure, is_translation ? judged.translation_m : judged.rotation_deg);
  }
  return figure;
}

Figure pose_figure(const JudgedRun& run, const CompareOptions& options, bool is_ape,
                   std::int64_t of) {
  const JudgedPoses& judged = *run.true_poses;
  const PoseRelation relation = is_ape ? options.ape.relation : options.rpe.relation;
  Figure figure;
  figure.run = run.name;
  figure.metric = is_ape ? "ape" : "rpe";
  figure.subset = to_string(relation);
  figure.quantity = "error";
  figure.unit = unit_of(relation);
  figure.statistics = is_ape ? judged.ape.statistics : judged.rpe.statistics;
  figure.covered = std::ssize(judged.matched.timestamps_s);
  figure.of = of;
  add_interval(figure, is_ape ? judged.ape_judged : judged.rpe_judged);
  return figure;
}

}  // namespace

std::vector<Figure> figures(const Comparison& comparison) {
  std::vector<Figure> all;
  for (const Subset& subset : kSubsets) {
    for (const bool is_translation : {true, false}) {
      for (const JudgedRun& run : comparison.runs) {
        if (!run.relations) continue;
        Figure figure = relation_figure(run, subset, is_translation);
        if (figure.statistics.count > 0) all.push_back(std::move(figure));
      }
    }
  }
  for (const bool is_ape : {true, false}) {
    for (const JudgedRun& run : comparison.runs) {
      if (!run.true_poses) continue;
      const std::int64_t of =
          comparison.carried ? run.truth_poses : std::min(run.poses, run.truth_poses);
      Figure figure = pose_figure(run, comparison.options, is_ape, of);
      if (figure.statistics.count > 0) all.push_back(std::move(figure));
    }
  }
  return all;
}

}  // namespace roomatlas
