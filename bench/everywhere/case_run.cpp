// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_run.hpp"

#include <fstream>
#include <iterator>
#include <string>

#include "accuracy/program.hpp"
#include "judge.hpp"
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

bool says(const Json& lines, const std::string& text) {
  for (const Json& line : lines) {
    if (line.get<std::string>().find(text) != std::string::npos) return true;
  }
  return false;
}

/// Whether the program speaks for the map today: all ran, its own comparison is "better", and its
/// loops hold: verified ones of sonars, one at least of a laser.
bool is_trusted(const Json& row) {
  if (row.contains("failure")) return false;
  const Json::json_pointer verdict("/evaluation/consistency/verdict");
  const Json& summary = row.at("summary");
  if (!summary.is_object() || !summary.contains(verdict)) return false;
  if (summary.at(verdict) != "better") return false;
  if (row.at("sensor") == "sonar") return !says(row.at("said"), "loops not verified");
  return row.at("own").at("loops").get<int>() > 0;
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

void build(const DrawnCase& drawn, const fs::path& folder, Json& row) {
  const fs::path mission = folder / "mission";
  const fs::path map = folder / "map";
  const Words words = {"build",   (mission / ("mission." + drawn.format)).string(),
                       "--truth", (mission / "truth.tum").string(),
                       "--truth", (mission / "truth.geojson").string(),
                       "-o",      map.string()};
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
  row["truth"] =
      judged_by_truth(store, read_tum(mission / "truth.tum"), read_plan(mission / "truth.geojson"));
  row["own"] = own_figures(store);
  row["right"] = finished.exit_code == 0 && row["truth"]["right"].get<bool>();
}

}  // namespace

Json description_of(const DrawnCase& drawn) {
  return {
      {"case", drawn.number},       {"seed", drawn.seed},     {"stratum", to_string(drawn.stratum)},
      {"building", drawn.building}, {"sensor", drawn.sensor}, {"faults", drawn.faults},
      {"simulate", drawn.simulate}, {"right", false},         {"trusted", false},
      {"commands", Json::array()}};
}

Json run_case(const DrawnCase& drawn, const fs::path& folder) {
  Json row = description_of(drawn);
  try {
    fs::remove_all(folder);
    fs::create_directories(folder);
    if (simulate(drawn, folder / "mission", row)) build(drawn, folder, row);
  } catch (const std::exception& error) {
    row["failure"] = std::string("judging: ") + error.what();
  }
  row["trusted"] = is_trusted(row);
  return row;
}

}  // namespace roomatlas::bench
