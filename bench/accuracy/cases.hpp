// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured, as two tables: the missions, and the ways to map each of them. To add a row to
// docs/evaluation.md, add a line here.
#pragma once

#include <string>
#include <vector>

namespace roomatlas::bench {

using Words = std::vector<std::string>;

/// A way to map a mission: flags of `roomatlas build` that stand beside the mission's own.
struct Variant {
  std::string name;
  Words flags;
};

/// A recorded log, or a world that is simulated first.
struct Case {
  std::string name;
  std::string log;    ///< below the folder of recorded data; empty for a world
  std::string world;  ///< in data/worlds, without ending
  Words simulation;   ///< flags of `roomatlas simulate`; a drive is named below data/worlds
  Words truth;        ///< files below the folder of recorded data
  Words flags;        ///< of `roomatlas build`: how truth and mission are brought together
  bool is_slow = false;
  std::string map{};  ///< a labelled map in rooms/ of the recorded data, instead of a world
};

inline const std::vector<Variant>& variants() {
  static const std::vector<Variant> all = {
      {"full", {}},
      {"paper's method", {"--no-localize", "--no-correct-sonars", "--model", "rotation"}},
  };
  return all;
}

inline Case recorded(std::string name, std::string log, Words truth = {}, Words flags = {}) {
  return {std::move(name), std::move(log), "", {}, std::move(truth), std::move(flags)};
}

inline Case simulated(const std::string& world, const std::string& sensor, bool is_slow = false) {
  return {world + ", " + sensor,
          "",
          world,
          {"--odometry", "typical", "--sensor", sensor, "--seed", "1"},
          {},
          {},
          is_slow,
          ""};
}

/// A building of the labelled maps of rooms/, as it is or furnished, on a tour of its rooms.
inline Case labelled_building(const std::string& map, const std::string& sensor, bool furnished) {
  Case one = simulated("", sensor, true);
  one.name = "building " + map + (furnished ? ", furnished, " : ", ") + sensor;
  one.map = map;
  one.simulation.push_back("--tour");
  if (furnished) one.simulation.insert(one.simulation.end(), {"--furnish", "1"});
  return one;
}

/// In the order of the tables.
inline std::vector<Case> cases() {
  std::vector<Case> all = {
      recorded(
          "fr079", "logs/fr079/fr079.clf.gz",
          {"logs/fr079/fr079.relations", "rooms/Freiburg79_scan/Freiburg79_scan_gt_labels.pgm.gz"},
          {"--label-pixel", "0.05"}),
      recorded("aces", "logs/aces/aces.clf.gz", {"logs/aces/aces.relations"}),
      recorded("mit-killian", "logs/mit-killian/mit-killian.reconstructed.clf.gz",
               {"logs/mit-killian/mit-killian.relations"},
               {"--match", "nearest", "--max-gap", "0.03"}),
      recorded("mit-csail", "logs/mit-csail/mit-csail.clf.gz",
               {"logs/mit-csail/mit-csail.corrected-poses.txt"}),
      recorded("wean", "logs/wean/robotdata1.log.gz"),
      recorded("duke-loop5", "logs/duke-loop5/loop5.log.gz"),
      recorded("mines exp1", "logs/mines-rover/exp1.dat.gz"),
      recorded("mines exp2", "logs/mines-rover/exp2.dat.gz"),
      recorded("mines test_lab", "logs/mines-rover/test_lab.dat.gz"),
      {"eight_rooms, its drive", "", "eight_rooms", {"--drive", "eight_rooms.drive"}, {}, {}},
  };
  for (std::size_t log = 0; log < 4; ++log) {  // the CARMEN logs, as a ring of sonars
    Case thinned = all[log];
    thinned.name += ", 8 sonars";
    thinned.flags.push_back("--as-sonar");
    all.push_back(std::move(thinned));
  }
  for (const char* sensor : {"sonar", "laser"}) {
    for (const char* world : {"two_rooms", "eight_rooms", "nine_rooms", "identical_rooms",
                              "slanted_and_curved", "open_hall"}) {
      all.push_back(simulated(world, sensor));
    }
  }
  all.push_back(simulated("afit_floor", "sonar", true));
  all.push_back(simulated("afit_floor", "laser", true));
  for (const char* map :
       {"Freiburg52_scan", "Freiburg79_scan", "NLB", "lab_a_scan", "lab_b_scan", "lab_c_scan",
        "lab_d_scan", "office_a", "office_c", "office_d", "office_f", "office_g", "office_i"}) {
    for (const bool furnished : {false, true}) {
      for (const char* sensor : {"laser", "sonar"}) {
        all.push_back(labelled_building(map, sensor, furnished));
      }
    }
  }
  return all;
}

}  // namespace roomatlas::bench
