// SPDX-License-Identifier: GPL-3.0-or-later
// Mission logs of text: CARMEN's and the small formats, plain and gzip, and the poses in them.
#include <zlib.h>

#include "large.hpp"
#include "mission.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/trajectories/trajectory_file.hpp"
#include "target.hpp"

namespace roomatlas::fuzz {
namespace {

std::string repeated(int count, const std::string& field) {
  std::string text;
  for (int i = 0; i < count; ++i) text += " " + field;
  return text;
}

std::string carmen_lines() {
  return "# CARMEN Logfile\n"
         "PARAM robot_length 0.47 1071078718.4 merci 1071078718.4\n"
         "PARAM robot_frontlaser_offset 0.15 0 h 0\n"
         "PARAM robot_max_sonar 3 0 h 0\n"
         "ODOM 1 2 0.5 0.1 0.2 0 10 h 0\n"
         "FLASER 5 1 2 3 81.91 nan 1.2 2 0 1 2 0 11 magnum 0.01\n"
         "RLASER 1 1 4 5 1 4 5 1 11.5 h 0\n"
         "RAWLASER1 0 -0.1 0.2 0.1 8 0.01 0 3 1 2 3 2 7 8 12 h 0\n"
         "ROBOTLASER1 4 -0.5 1.0 0.25 20 0.01 0 3 1 2 3 2 7 8 1.1 2 0.5 1 2 0.4 0.3 0.02 0.1 0.1 "
         "1e6 13 host 0.1\n"
         "SONAR 0.5236 2 1.25 3 0.1 0.2 1.571 0.3 -0.2 0 14 h 0\n"
         "TRUEPOS 1 2 3 4 5 6 99.5 h 0\n"
         "NEFF 8.4\nSYNC start 1 h 0\n";
}

std::string wean_lines() {
  return "O 100 0 1.57 0.1\nL 100 200 1.57 100 225 1.57" + repeated(180, "66") +
         " 0.5\nL 100 300 1.57 100 325 1.57" + repeated(180, "8183") + " 1.5\n";
}

std::string duke_lines() {
  return "Odometry 1 2 0.5 \nLaser 181" + repeated(181, "3.5") + " \nOdometry 2 2 0.5\nLaser 181" +
         repeated(181, "8.19") + "\n";
}

std::string mines_lines() {
  return "1000000 7 500 700" + repeated(21, "0") + repeated(682, "20") + "\n2000000 7 2500 2700" +
         repeated(21, "0") + repeated(682, "7") + "\n";
}

std::vector<std::string> text_seeds() {
  std::vector<std::string> seeds = {carmen_lines(), wean_lines(), duke_lines(), mines_lines()};
  for (const SensorKind kind : {SensorKind::laser, SensorKind::sonar}) {
    seeds.push_back(written("mission.clf", [&](const Path& file) { write_mission(file, kind); }));
  }
  return seeds;
}

std::string packed(const std::string& text) {
  return written("text.gz", [&](const Path& file) {
    const gzFile out = gzopen(file.c_str(), "wb");
    gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
    gzclose(out);
  });
}

std::vector<std::string> packed_seeds() {
  std::vector<std::string> seeds;
  for (const std::string& text : text_seeds()) seeds.push_back(packed(text));
  return seeds;
}

void read_log(const Path& file, const std::string&) {
  read_whole(*open_mission_to_map(file, {}));
  MissionOptions options;
  options.as_sonar.enabled = true;
  read_whole(*open_mission(file, options));
}

void read_poses(const Path& file, const std::string&) {
  (void)read_clock(file);
  (void)read_trajectory(file, {}, LogPoses::truth);
  (void)read_trajectory(file, {}, LogPoses::recorded);
}

}  // namespace

std::vector<Target> log_targets() {
  return {{"logs", "mission.clf", text_seeds, read_log, large_logs},
          {"trajectory", "poses.txt", pose_seeds, read_poses},
          {"packed_logs", "mission.clf.gz", packed_seeds, read_log}};
}

}  // namespace roomatlas::fuzz
