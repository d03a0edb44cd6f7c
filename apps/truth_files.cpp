// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_files.hpp"

#include "console.hpp"
#include "roomatlas/io/formats.hpp"
#include "roomatlas/io/label_plan.hpp"
#include "roomatlas/io/spans_file.hpp"
#include "roomatlas/io/trajectory_file.hpp"

namespace roomatlas::apps {

void add_truth(const Path& file, const Settings& settings, Truth& truth) {
  const Path name = file.extension() == ".gz" ? file.stem() : file.filename();
  const std::string extension = name.extension().string();
  if (extension == ".relations") {
    truth.relations = read_relations(file);
    if (truth.relations.empty()) {
      throw InputError(file.string() + ": holds no relation: is it the right file, and whole?");
    }
  } else if (extension == ".geojson" || extension == ".json") {
    truth.plan = read_plan(file);
    truth.plan_has_doors = true;
  } else if (extension == ".pgm") {
    truth.plan = read_label_plan(file, settings.label_pixel_m);
    truth.plan_has_doors = false;
  } else if (extension == ".csv") {
    truth.spans = read_spans(file);
  } else {
    TrajectoryFile read = read_trajectory(file, settings.mission, LogPoses::truth);
    if (read.poses.empty()) {
      throw InputError(file.string() + ": holds no true pose: is it the right file, and whole?");
    }
    show(read.issues);
    truth.poses = std::move(read.poses);
  }
}

std::string names_of(const std::vector<Path>& files) {
  std::string names;
  for (const Path& file : files) names += (names.empty() ? "" : ", ") + file.filename().string();
  return names;
}

}  // namespace roomatlas::apps
