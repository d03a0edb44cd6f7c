// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of `roomatlas map` against the length of a mission: logs of rows of equal rooms, of a
// robot with sonars and of one with a laser, mapped by the program itself.
//
//   bench_memory [sonar|laser|both [READINGS [ROOMS...]]]
// READINGS a room. Default: both, 1000, of 100 and 1000 rooms.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "accuracy/program.hpp"
#include "roomatlas/io/logs/carmen_writer.hpp"
#include "row_of_rooms.hpp"

namespace {

namespace fs = std::filesystem;
using namespace roomatlas;
using namespace roomatlas::bench;

/// Made in a process of its own: what it holds would count as that of the program it runs next.
int write_log(const fs::path& file, const std::string& sensor, double readings_a_room, int rooms) {
  SimulationOptions options;
  if (sensor == "laser") options.sensor = SensorKind::laser;
  options.rate_hz *= readings_a_room / static_cast<double>(Row(options).steps_in(1).size());
  const Row row(options);
  RowDrive drive(row, 1.0 / options.rate_hz);
  CarmenWriter writer(file, *row.steps_in(1).front().reading.sensor, RobotFootprint{});
  std::int64_t readings = 0;
  while (drive.room() <= rooms) {
    const RangeReading reading = drive.next();
    writer.write(OdometryStep{reading.timestamp_s, reading.odom_from_robot});
    writer.write(reading);
    ++readings;
  }
  writer.finish();
  std::printf("%-6s %6d %9lld", sensor.c_str(), rooms, static_cast<long long>(readings));
  return 0;
}

/// Rows of rooms of one sensor, the shortest first: each against that.
void compare(const std::string& own, const std::string& sensor, const std::string& readings_a_room,
             const std::vector<std::string>& rooms, const fs::path& folder) {
  double first_mb = 0.0;
  for (const std::string& count : rooms) {
    const fs::path log = folder / "mission.clf";
    const fs::path said = folder / "log.txt";
    if (run_program(own, {"--write", log.string(), sensor, readings_a_room, count}, said)
            .exit_code != 0) {
      std::printf("%s: cannot be written\n", log.c_str());
      return;
    }
    std::string line;
    std::getline(std::ifstream(said), line);
    const fs::path out = folder / "out";
    const Finished mapped = run_roomatlas({"-q", "map", log.string(), "-o", out.string()}, said);
    if (first_mb == 0.0) first_mb = mapped.peak_mb;
    std::printf("%s %9.1f %9.1f %9.1f %7.2f  %s\n", line.c_str(),
                static_cast<double>(fs::file_size(log)) / 1024.0 / 1024.0, mapped.processor_s,
                mapped.peak_mb, mapped.peak_mb / first_mb,
                mapped.exit_code == 0 ? "" : mapped.complaint.c_str());
    std::fflush(stdout);
    fs::remove_all(out);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 5 && words[0] == "--write") {
    return write_log(words[1], words[2], std::stod(words[3]), std::stoi(words[4]));
  }
  const std::string sensor = words.empty() ? "both" : words[0];
  const std::string readings_a_room = words.size() > 1 ? words[1] : "1000";
  std::vector<std::string> rooms = {"100", "1000"};
  if (words.size() > 2) rooms.assign(words.begin() + 2, words.end());
  const fs::path folder = fs::temp_directory_path() / "roomatlas_bench_memory";
  fs::create_directories(folder);
  std::printf("%-6s %6s %9s %9s %9s %9s %7s\n", "sensor", "rooms", "readings", "log (MB)",
              "time (s)", "peak (MB)", "ratio");
  for (const char* one : {"sonar", "laser"}) {
    if (sensor == "both" || sensor == one) compare(argv[0], one, readings_a_room, rooms, folder);
  }
  fs::remove_all(folder);
}
