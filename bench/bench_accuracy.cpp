// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of docs/evaluation.md: all recorded logs and worlds, mapped in every variant by the
// built program itself. Markdown on stdout, times and what is going on on stderr.
//
//   bench_accuracy [--slow] [--full] [NAME...]
//     NAME    cases that begin so; without any all that are not slow
//     --full  the full variant alone
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "accuracy/cases.hpp"
#include "accuracy/program.hpp"
#include "accuracy/tables.hpp"
#include "recorded_data.hpp"

namespace {

using namespace roomatlas::bench;
namespace fs = std::filesystem;

const fs::path kSource = ROOMATLAS_SOURCE_DIR;
const fs::path kOut = kSource / "out" / "accuracy";

struct Choice {
  bool with_slow = false;
  bool full_alone = false;
  std::vector<std::string> names;

  [[nodiscard]] bool includes(const Case& one) const {
    if (names.empty()) return with_slow || !one.is_slow;
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return one.name.starts_with(name); });
  }
};

/// For a folder: letters and digits.
std::string plain(std::string name) {
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

Mapped not_measured(const Case& one, const std::string& variant, const std::string& why) {
  Mapped mapped{one.name, variant, false, {}, nullptr};
  mapped.run.complaint = why;
  return mapped;
}

/// The log to map and the truth that stands beside it.
struct Mission {
  fs::path log;
  std::vector<fs::path> truth;
  std::string failure;  ///< why there is none; empty where there is one
};

Mission recorded_mission(const Case& one) {
  Mission mission{recorded_data() / one.log, {}, ""};
  for (const std::string& file : one.truth) mission.truth.push_back(recorded_data() / file);
  for (const fs::path& file : mission.truth) {
    if (!fs::exists(file)) mission.failure = file.filename().string() + " is not there";
  }
  if (!fs::exists(mission.log)) mission.failure = one.log + " is not there";
  return mission;
}

/// What names the world to `roomatlas simulate`.
Words world_of(const Case& one, const fs::path& worlds) {
  if (one.map.empty()) return {(worlds / (one.world + ".geojson")).string()};
  const fs::path map = recorded_data() / "rooms" / one.map / one.map;
  return {map.string() + ".pgm.gz", "--room-labels", map.string() + "_gt_labels.pgm.gz",
          "--resolution", "0.05"};
}

Mission simulated_mission(const Case& one, const fs::path& folder) {
  const fs::path worlds = kSource / "data" / "worlds";
  Words arguments = world_of(one, worlds);
  arguments.insert(arguments.begin(), "simulate");
  for (const std::string& flag : one.simulation) {
    arguments.push_back(flag.ends_with(".drive") ? (worlds / flag).string() : flag);
  }
  arguments.insert(arguments.end(), {"-q", "-o", folder.string()});
  const Finished run = run_roomatlas(arguments, folder / "messages.txt");
  return {folder / "mission.clf", {folder / "truth.geojson"}, run.complaint};
}

Mapped mapped(const Case& one, const Variant& variant, const Mission& mission,
              const fs::path& folder) {
  Words arguments = {"build", mission.log.string(), "-q", "-o", folder.string()};
  for (const fs::path& file : mission.truth) {
    arguments.insert(arguments.end(), {"--truth", file.string()});
  }
  arguments.insert(arguments.end(), one.flags.begin(), one.flags.end());
  arguments.insert(arguments.end(), variant.flags.begin(), variant.flags.end());
  fs::create_directories(folder.parent_path());
  Mapped result{one.name, variant.name, false, run_roomatlas(arguments, folder.string() + ".txt"),
                nullptr};
  if (result.run.exit_code != 0) return result;
  std::ifstream summary(folder / "summary.json");
  result.summary = nlohmann::json::parse(summary, nullptr, false);
  return result;
}

/// Every variant of one case; what cannot be measured says why, and the rest goes on.
void measure(const Case& one, bool full_alone, std::vector<Mapped>& all) {
  const fs::path folder = kOut / plain(one.name);
  fs::remove_all(folder);  // `build` would go on with an older map
  fs::create_directories(folder / "mission");
  const Mission mission =
      one.log.empty() ? simulated_mission(one, folder / "mission") : recorded_mission(one);
  if (!mission.failure.empty()) {
    all.push_back(not_measured(one, "", mission.failure));
    std::fprintf(stderr, "%s: %s\n", one.name.c_str(), mission.failure.c_str());
    return;
  }
  bool is_first = true;
  for (const Variant& variant : variants()) {
    if (full_alone && &variant != &variants().front()) break;
    all.push_back(mapped(one, variant, mission, folder / plain(variant.name)));
    Mapped& latest = all.back();
    std::fprintf(stderr, "%s, %s: %.1f s %s\n", one.name.c_str(), variant.name.c_str(),
                 latest.run.elapsed_s, latest.run.complaint.c_str());
    latest.is_first_variant = is_first && !latest.summary.is_null();
    is_first = is_first && latest.summary.is_null();
  }
}

}  // namespace

int main(int argc, char** argv) {
  Choice choice;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--slow") {
      choice.with_slow = true;
    } else if (word == "--full") {
      choice.full_alone = true;
    } else {
      choice.names.push_back(word);
    }
  }
  std::vector<Mapped> all;
  for (const Case& one : cases()) {
    if (choice.includes(one)) measure(one, choice.full_alone, all);
  }
  if (all.empty()) {
    std::fprintf(stderr, "no case begins with that; bench/accuracy/cases.hpp has their names\n");
    return 2;
  }
  std::printf("%s", accuracy_tables(all).c_str());
  std::fprintf(stderr, "\n%s", cost_table(all).c_str());
  return 0;
}
