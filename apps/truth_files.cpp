// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_files.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "console.hpp"
#include "roomatlas/io/files/input_file.hpp"
#include "roomatlas/io/maps/label_plan.hpp"
#include "roomatlas/io/plans/rooms_geojson.hpp"
#include "roomatlas/io/plans/spans_file.hpp"
#include "roomatlas/io/trajectories/relations.hpp"
#include "roomatlas/io/trajectories/trajectory_file.hpp"

namespace roomatlas::apps {
namespace {

void require_content(const Path& file) {
  std::error_code unreadable;  // the reader says what is wrong then
  if (std::filesystem::file_size(file, unreadable) == 0) {
    throw InputError(file.string() + ": is empty: is it the right file, and whole?");
  }
}

/// What a JSON file is, as far as its outside tells.
/// A plan on the earth is features, as of any program: its frame is no robot's.
enum class JsonKind { plan, features, other, broken };

JsonKind json_kind(const Path& file) {
  const auto json = nlohmann::json::parse(read_text_file(file), nullptr, false);
  if (json.is_discarded()) return JsonKind::broken;
  if (!json.is_object()) return JsonKind::other;
  const auto own = json.find("roomatlas");
  const bool is_plan = own != json.end() && !(own->is_object() && own->contains("origin"));
  if (is_plan) return JsonKind::plan;
  return json.value("type", nlohmann::json()) == "FeatureCollection" ? JsonKind::features
                                                                     : JsonKind::other;
}

FloorPlan plan_in(const Path& file) {
  if (json_kind(file) != JsonKind::other) return read_any_plan(file);
  throw InputError(
      file.string() +
      ": is neither a plan of this program nor a FeatureCollection of rooms (GeoJSON); known are "
      "plans (plan.local.geojson of `roomatlas export`), rooms of QGIS and OpenStreetMap "
      "(.geojson), room labels (.pgm, .pgm.gz), spans (.csv), .relations, and trajectories (TUM, "
      "g2o, CARMEN logs with TRUEPOS)");
}

void require_rooms(const FloorPlan& plan, const Path& file) {
  if (!plan.rooms.empty()) return;
  throw InputError(file.string() + ": holds no room: is it the right file, and whole?");
}

}  // namespace

std::string kind_of(const Path& file) {
  const Path name = file.extension() == ".gz" ? file.stem() : file.filename();
  return name.extension().string();
}

void add_truth(const Path& file, const Settings& settings, Truth& truth) {
  require_regular_file(file);
  require_content(file);
  const std::string extension = kind_of(file);
  if (extension == ".relations") {
    truth.relations = read_relations(file);
    if (truth.relations.empty()) {
      throw InputError(file.string() + ": holds no relation: is it the right file, and whole?");
    }
  } else if (extension == ".geojson" || extension == ".json") {
    truth.plan = plan_in(file);
    truth.plan_is_of_poses = json_kind(file) == JsonKind::plan;
    truth.plan_has_doors = truth.plan_is_of_poses || !truth.plan->doors.empty();
    require_rooms(*truth.plan, file);
    show(truth.plan->issues);
  } else if (extension == ".pgm") {
    truth.plan = read_label_plan(file, settings.label_pixel_m);
    truth.plan_has_doors = false;
    require_rooms(*truth.plan, file);
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

NamedTruth named_truth(const Path& argument) {
  const std::string text = argument.string();
  const std::size_t sign = text.find('=');
  std::error_code unreadable;
  if (sign == std::string::npos || std::filesystem::exists(argument, unreadable)) {
    return {"", argument};
  }
  return {text.substr(0, sign), text.substr(sign + 1)};
}

Truth read_truth(const std::vector<Path>& files, const Settings& settings) {
  Truth truth;
  for (const Path& argument : files) {
    const auto [mission, file] = named_truth(argument);
    if (mission.empty()) {
      add_truth(file, settings, truth);
      continue;
    }
    Truth own;
    add_truth(file, settings, own);
    if (own.plan || !own.spans.empty()) {
      throw UsageError(argument.string() +
                       ": a plan or spans are of the building, not of a mission: leave out " +
                       mission + "=");
    }
    truth.missions.push_back({mission, std::move(own.relations), std::move(own.poses)});
  }
  return truth;
}

void require_truth_files(const std::vector<Path>& files) {
  for (const Path& argument : files) {
    const Path file = named_truth(argument).file;
    std::error_code unreadable;
    if (std::filesystem::exists(file, unreadable)) continue;
    throw InputError(file.string() + ": there is no such file: check the path after --truth");
  }
}

std::string names_of(const std::vector<Path>& files) {
  std::string names;
  for (const Path& argument : files) {
    const auto [mission, file] = named_truth(argument);
    names += (names.empty() ? "" : ", ") + (mission.empty() ? "" : mission + "=") +
             file.filename().string();
  }
  return names;
}

}  // namespace roomatlas::apps
