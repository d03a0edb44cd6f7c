// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_cases.hpp"

#include <algorithm>
#include <sstream>

namespace roomatlas::bench {
namespace {

namespace fs = std::filesystem;

Words words_of(const std::string& text) {
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

Words flags_for(const std::string& sensor) {
  return {"--odometry", "typical", "--seed", "1", "--sensor", sensor};
}

/// The robot explores each of these by itself.
void add_worlds(std::vector<PlanCase>& cases, const fs::path& worlds, const std::string& state,
                const std::string& sensor) {
  for (const char* world : {"two_rooms", "eight_rooms", "nine_rooms", "identical_rooms",
                            "slanted_and_curved", "open_hall", "afit_floor"}) {
    PlanCase one{"worlds " + state + " " + sensor,
                 std::string(world) + " " + state + " " + sensor,
                 worlds / (std::string(world) + ".geojson"),
                 flags_for(sensor),
                 {}};
    if (state == "furnished") one.simulation.insert(one.simulation.end(), {"--furnish", "1"});
    cases.push_back(std::move(one));
  }
}

/// The robot tours each of these as somebody who knows it.
void add_maps(std::vector<PlanCase>& cases, const fs::path& maps, const std::string& sensor) {
  for (const char* map : {"Freiburg52_scan", "lab_b_scan", "lab_c_scan", "lab_d_scan", "lab_a_scan",
                          "Freiburg79_scan", "NLB", "office_a", "office_c", "office_d", "office_f",
                          "office_g", "office_i"}) {
    const fs::path stem = maps / map / map;
    PlanCase one{
        "maps " + sensor,
        std::string(map) + " " + sensor,
        stem.string() + ".pgm.gz",
        {"--room-labels", stem.string() + "_gt_labels.pgm.gz", "--resolution", "0.05", "--tour"},
        {}};
    const Words more = flags_for(sensor);
    one.simulation.insert(one.simulation.end(), more.begin(), more.end());
    cases.push_back(std::move(one));
  }
}

}  // namespace

std::vector<PlanCase> plan_cases(const fs::path& worlds, const fs::path& data) {
  std::vector<PlanCase> cases;
  for (const char* state : {"plain", "furnished"}) {
    for (const char* sensor : {"laser", "sonar"}) add_worlds(cases, worlds, state, sensor);
  }
  for (const char* sensor : {"laser", "sonar"}) add_maps(cases, data / "rooms", sensor);
  cases.push_back({"fr079",
                   "fr079 laser",
                   data / "logs" / "fr079" / "fr079.clf.gz",
                   {},
                   data / "rooms" / "Freiburg79_scan" / "Freiburg79_scan_gt_labels.pgm.gz"});
  return cases;
}

bool is_wished(const PlanCase& one, const std::string& wish) {
  const Words own = words_of(one.group + " " + one.name);
  const Words wished = words_of(wish);
  return std::all_of(wished.begin(), wished.end(), [&](const std::string& word) {
    return std::find(own.begin(), own.end(), word) != own.end();
  });
}

}  // namespace roomatlas::bench
