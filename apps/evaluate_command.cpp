// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <fstream>

#include "commands.hpp"
#include "console.hpp"
#include "evaluation_report.hpp"
#include "roomatlas/io/formats.hpp"
#include "roomatlas/io/geopackage_store.hpp"
#include "roomatlas/io/summary.hpp"

namespace roomatlas::apps {
namespace {

/// Adds a truth file, told by its name: .relations, .tum, or a plan in .geojson.
void add_truth(const Path& file, Truth& truth) {
  const std::string extension = file.extension().string();
  if (extension == ".relations") {
    truth.relations = read_relations(file);
  } else if (extension == ".tum") {
    truth.poses = read_tum(file);
  } else if (extension == ".geojson" || extension == ".json") {
    truth.plan = read_plan(file);
  } else {
    throw UsageError(file.string() +
                     ": unknown kind of truth: expected .relations, .tum or .geojson");
  }
}

}  // namespace

std::optional<Evaluation> evaluation_of(const Path& store_file, const std::vector<Path>& files) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  if (!store.has_assembly()) {
    throw NotEnoughError(store_file.string() +
                         ": not assembled yet: run `roomatlas assemble` on it first");
  }
  Truth truth;
  for (const TruePose& pose : store.truth()) {
    truth.poses.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  for (const Path& file : files) add_truth(file, truth);
  if (truth.poses.empty() && files.empty()) return std::nullopt;
  const PlacedMission placed = place(store, store.correction());
  return roomatlas::evaluate(placed.odometry, placed.corrected, store.plan(), truth);
}

void evaluate(const Settings& settings, const Path& store, const std::vector<Path>& truth) {
  const auto evaluation = evaluation_of(store, truth);
  if (!evaluation) {
    throw UsageError("nothing to evaluate against: give --truth FILE (relations, TUM or plan)");
  }
  if (settings.json) {
    fmt::print("{}", to_json(*evaluation));
  } else {
    print(*evaluation);
  }
}

}  // namespace roomatlas::apps
