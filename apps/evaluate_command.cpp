// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <fstream>

#include "commands.hpp"
#include "console.hpp"
#include "evaluation_report.hpp"
#include "roomatlas/io/formats.hpp"
#include "roomatlas/io/geopackage_store.hpp"
#include "roomatlas/io/label_plan.hpp"
#include "roomatlas/io/spans_file.hpp"
#include "roomatlas/io/summary.hpp"

namespace roomatlas::apps {
namespace {

/// The extension, or the one before `.gz`.
std::string kind_of(const Path& file) {
  const Path name = file.extension() == ".gz" ? file.stem() : file;
  return name.extension().string();
}

/// Adds a truth file, told by its name: .relations, .tum, a plan in .geojson, a label picture in
/// .pgm, or tape-measure spans in .csv.
void add_truth(const Path& file, double pixel_m, Truth& truth) {
  const std::string extension = kind_of(file);
  if (extension == ".relations") {
    truth.relations = read_relations(file);
  } else if (extension == ".tum") {
    truth.poses = read_tum(file);
  } else if (extension == ".geojson" || extension == ".json") {
    truth.plan = read_plan(file);
    truth.plan_has_doors = true;
  } else if (extension == ".pgm") {
    truth.plan = read_label_plan(file, pixel_m);
    truth.plan_has_doors = false;
  } else if (extension == ".csv") {
    truth.spans = read_spans(file);
  } else {
    throw UsageError(file.string() +
                     ": unknown kind of truth: expected .relations, .tum, .geojson, .pgm (labels) "
                     "or .csv (spans)");
  }
}

}  // namespace

Evaluation evaluation_of(const Settings& settings, const Path& store_file,
                         const std::vector<Path>& files) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  if (!store.has_assembly()) {
    throw NotEnoughError(store_file.string() +
                         ": not assembled yet: run `roomatlas assemble` on it first");
  }
  Truth truth;
  for (const TruePose& pose : store.truth()) {
    truth.poses.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  for (const Path& file : files) add_truth(file, settings.label_pixel_m, truth);
  const Correction correction = store.correction();
  const FloorPlan plan = store.plan();
  const PlacedMission placed = place(store, correction);
  Evaluation evaluation = roomatlas::evaluate(placed.odometry, placed.corrected, plan, truth);
  judge_placements(store, correction, plan, truth, evaluation);
  return evaluation;
}

void evaluate(const Settings& settings, const Path& store, const std::vector<Path>& truth) {
  const Evaluation evaluation = evaluation_of(settings, store, truth);
  if (settings.json) {
    fmt::print("{}", to_json(evaluation));
  } else {
    print(evaluation);
  }
}

}  // namespace roomatlas::apps
