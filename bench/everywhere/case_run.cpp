// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_run.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "accuracy/program.hpp"
#include "judge.hpp"
#include "recorded_data.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

namespace roomatlas::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kNoRoom = 4;  // exit code of a build whose plan has none; all else is there
constexpr std::size_t kLinesKept = 60;  // of what the program said

std::string line_of(const Words& words) {
  std::string line = "roomatlas";
  for (const std::string& word : words) line += " " + word;
  return line;
}

Json json_of(const LogChange& change) {
  if (change.log.empty()) return nullptr;
  return {{"log", change.log},
          {"every_beam", change.every_beam},
          {"view_deg", change.view_deg},
          {"max_range_m", change.max_range_m},
          {"range_noise_m", change.range_noise_m},
          {"bias_deg_per_m", change.odometry.bias_deg_per_m},
          {"turn_gain", change.odometry.turn_gain},
          {"length_scale", change.odometry.length_scale},
          {"noise_deg_per_sqrt_m", change.odometry.noise_deg_per_sqrt_m},
          {"lag_s", change.odometry.lag_s}};
}

/// What the program told and warned of, without its progress.
Json said(const fs::path& log) {
  Json lines = Json::array();
  std::ifstream stream(log);
  for (std::string line; std::getline(stream, line) && lines.size() < kLinesKept;) {
    const bool is_told =
        line.starts_with("info:") || line.starts_with("warning:") || line.starts_with("error:");
    if (is_told) lines.push_back(line);
  }
  return lines;
}

Json json_in(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) return nullptr;
  return Json::parse(std::string(std::istreambuf_iterator<char>(stream), {}), nullptr, false);
}

/// Whether the program gives the map 95 % or more.
bool is_trusted(const Json& row) {
  constexpr double kSure = 0.95;
  if (row.contains("failure")) return false;
  const Json::json_pointer probability("/judgement/probability");
  const Json& summary = row.at("summary");
  return summary.is_object() && summary.contains(probability) &&
         summary.at(probability).get<double>() >= kSure;
}

bool simulate(const DrawnCase& drawn, const fs::path& mission, Json& row) {
  Words words = {"simulate"};
  words.insert(words.end(), drawn.simulate.begin(), drawn.simulate.end());
  words.insert(words.end(), {"--format=" + drawn.format, "-o", mission.string()});
  row["commands"] = {line_of(words)};
  const Finished finished = run_roomatlas(words, mission.string() + ".messages");
  row["simulate_s"] = finished.processor_s;
  row["drawn"] = finished.exit_code == 0;
  if (finished.exit_code == 0) return true;
  row["failure"] = "simulate: " + std::to_string(finished.exit_code) + " " + finished.complaint;
  return false;
}

/// Where the log as it is says that the robot was: mapped once a run.
Trajectory reference_of(const fs::path& log, const fs::path& folder) {
  const fs::path kept = folder / "reference.gpkg";
  if (!fs::exists(kept)) {
    const fs::path own = folder / (std::to_string(getpid()) + ".gpkg");
    fs::create_directories(folder);
    for (const Words& words : {Words{"map", log.string(), "-q", "-o", own.string()},
                               Words{"assemble", own.string(), "-q"}}) {
      const Finished finished = run_roomatlas(words, own.string() + ".messages");
      if (finished.exit_code != 0) throw std::runtime_error("reference: " + finished.complaint);
    }
    fs::rename(own, kept);
  }
  const GeoPackageStore store(kept, GeoPackageStore::Mode::read);
  return place(store, store.correction()).corrected;
}

void change_log(const DrawnCase& drawn, const fs::path& folder, Json& row) {
  const fs::path log = recorded_data() / drawn.change.log;
  const Trajectory reference = reference_of(log, folder.parent_path() / drawn.building);
  const fs::path mission = folder / "mission";
  fs::create_directories(mission);
  write_changed_log(log, drawn.change, mission / "mission.clf");
  write_tum(mission / "truth.tum", reference);
  row["drawn"] = true;
}

void build(const DrawnCase& drawn, const fs::path& folder, Json& row) {
  const fs::path mission = folder / "mission";
  const fs::path map = folder / "map";
  const fs::path world = mission / "truth.geojson";
  Words words = {"build", (mission / ("mission." + drawn.format)).string()};
  words.insert(words.end(), {"--truth", (mission / "truth.tum").string()});
  if (drawn.has_rooms) words.insert(words.end(), {"--truth", world.string()});
  words.insert(words.end(), drawn.build.begin(), drawn.build.end());
  words.insert(words.end(), {"-o", map.string()});
  row["commands"].push_back(line_of(words));
  const Finished finished = run_roomatlas(words, folder / "build.messages");
  row["exit_code"] = finished.exit_code;
  row["processor_s"] = finished.processor_s;
  row["peak_mb"] = finished.peak_mb;
  row["said"] = said(folder / "build.messages");
  row["summary"] = json_in(map / "summary.json");
  if (finished.exit_code != 0) {
    row["failure"] = "build: " + std::to_string(finished.exit_code) + " " + finished.complaint;
    if (finished.exit_code != kNoRoom) return;
  }
  const GeoPackageStore store(map / "building.gpkg", GeoPackageStore::Mode::read);
  row["truth"] = judged_by_truth(store, read_tum(mission / "truth.tum"),
                                 drawn.has_rooms ? read_plan(world) : FloorPlan{});
  row["own"] = own_figures(store);
  row["right"] = finished.exit_code == 0 && row["truth"]["right"].get<bool>();
}

}  // namespace

Json description_of(const DrawnCase& drawn) {
  return {{"change", json_of(drawn.change)},
          {"case", drawn.number},
          {"seed", drawn.seed},
          {"stratum", to_string(drawn.stratum)},
          {"building", drawn.building},
          {"sensor", drawn.sensor},
          {"faults", drawn.faults},
          {"simulate", drawn.simulate},
          {"right", false},
          {"trusted", false},
          {"commands", Json::array()}};
}

Json run_case(const DrawnCase& drawn, const fs::path& folder) {
  Json row = description_of(drawn);
  try {
    fs::remove_all(folder);
    fs::create_directories(folder);
    if (drawn.stratum == Stratum::recorded) {
      change_log(drawn, folder, row);
      build(drawn, folder, row);
    } else if (simulate(drawn, folder / "mission", row)) {
      build(drawn, folder, row);
    }
  } catch (const std::exception& error) {
    row["failure"] = std::string("judging: ") + error.what();
  }
  row["trusted"] = is_trusted(row);
  return row;
}

}  // namespace roomatlas::bench
