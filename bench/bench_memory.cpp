// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of `roomatlas map` against the length of a mission: logs of rows of equal rooms, of a
// robot with sonars and of one with a laser, mapped by the program itself.
//
//   bench_memory [sonar|laser|both [READINGS [ROOMS...]]]
// READINGS a room. Default: both, 1000, of 100 and 1000 rooms.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "accuracy/program.hpp"
#include "roomatlas/io/logs/carmen_writer.hpp"
#include "row_of_rooms.hpp"

namespace {

namespace fs = std::filesystem;
using namespace roomatlas;
using namespace roomatlas::bench;

/// @return how many readings there are
std::int64_t write_log(const fs::path& file, const Row& row, double period_s, int rooms) {
  RowDrive drive(row, period_s);
  CarmenWriter writer(file, *row.steps_in(1).front().reading.sensor, RobotFootprint{});
  std::int64_t readings = 0;
  while (drive.room() <= rooms) {
    const RangeReading reading = drive.next();
    writer.write(OdometryStep{reading.timestamp_s, reading.odom_from_robot});
    writer.write(reading);
    ++readings;
  }
  writer.finish();
  return readings;
}

/// Rows of rooms of one sensor, the shortest first: each against that.
void compare(const char* name, SimulationOptions options, double readings_a_room,
             const std::vector<int>& rooms, const fs::path& folder) {
  options.rate_hz *= readings_a_room / static_cast<double>(Row(options).steps_in(1).size());
  const Row row(options);
  double first_mb = 0.0;
  for (const int count : rooms) {
    const fs::path log = folder / "mission.clf";
    const std::int64_t readings = write_log(log, row, 1.0 / options.rate_hz, count);
    const fs::path out = folder / "out";
    const Finished mapped =
        run_roomatlas({"-q", "map", log.string(), "-o", out.string()}, folder / "log.txt");
    if (first_mb == 0.0) first_mb = mapped.peak_mb;
    std::printf("%-6s %6d %9lld %9.1f %9.1f %9.1f %7.2f  %s\n", name, count,
                static_cast<long long>(readings),
                static_cast<double>(fs::file_size(log)) / 1024.0 / 1024.0, mapped.processor_s,
                mapped.peak_mb, mapped.peak_mb / first_mb,
                mapped.exit_code == 0 ? "" : mapped.complaint.c_str());
    std::fflush(stdout);
    fs::remove_all(out);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string sensor = argc > 1 ? argv[1] : "both";
  const double readings_a_room = argc > 2 ? std::atof(argv[2]) : 1000.0;
  std::vector<int> rooms;
  for (int i = 3; i < argc; ++i) rooms.push_back(std::atoi(argv[i]));
  if (rooms.empty()) rooms = {100, 1000};
  const fs::path folder = fs::temp_directory_path() / "roomatlas_bench_memory";
  fs::create_directories(folder);
  std::printf("%-6s %6s %9s %9s %9s %9s %7s\n", "sensor", "rooms", "readings", "log (MB)",
              "time (s)", "peak (MB)", "ratio");
  SimulationOptions options;
  if (sensor != "laser") compare("sonar", options, readings_a_room, rooms, folder);
  options.sensor = SensorKind::laser;
  if (sensor != "sonar") compare("laser", options, readings_a_room, rooms, folder);
  fs::remove_all(folder);
}
