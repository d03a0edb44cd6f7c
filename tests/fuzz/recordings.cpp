// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of ROS: its first release's bags, MCAP, rosbag2's SQLite, each by its messages and as
// a mission; and the folder's metadata.
#include "bags/bag_reader.hpp"
#include "bags/rosbag2_metadata.hpp"
#include "io/bags/small_bags.hpp"
#include "mission.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "target.hpp"

namespace roomatlas::fuzz {
namespace {

using test::bags::packed;
using test::bags::small_mcap;
using test::bags::small_ros1_bag;

void read_recording(const Path& file, const std::string&) {
  if (const auto bag = io::open_bag(file)) {
    while (bag->next()) {
    }
    (void)bag->issues();
  }
  if (io::is_bag_by_magic(file)) read_whole(*open_mission_to_map(file, {}));
}

void read_database(const Path& file, const std::string& bytes) {
  read_recording(file, bytes);
  if (bytes.starts_with("SQLite")) read_whole(*open_mission_to_map(file, {}));
}

std::vector<std::string> missions(const std::string& name) {
  std::vector<std::string> seeds;
  for (const SensorKind kind : {SensorKind::laser, SensorKind::sonar}) {
    seeds.push_back(written(name, [&](const Path& file) { write_mission(file, kind); }));
  }
  return seeds;
}

std::vector<std::string> ros1_seeds() {
  std::vector<std::string> seeds = missions("mission.bag");
  for (const char* packing : {"none", "bz2", "lz4"}) {
    for (const bool is_indexed : {true, false}) {
      seeds.push_back(small_ros1_bag(packing, is_indexed).bytes);
    }
  }
  return seeds;
}

std::vector<std::string> mcap_seeds() {
  std::vector<std::string> seeds = missions("mission.mcap");
  for (const char* packing : {"", "lz4", "zstd"}) {
    seeds.push_back(small_mcap({.packing = packing}).bytes);
    seeds.push_back(small_mcap({.packing = packing,
                                .has_message_index = false,
                                .has_summary = false,
                                .has_crcs = false})
                        .bytes);
  }
  seeds.push_back(small_mcap({.packing = "", .has_chunks = false}).bytes);
  seeds.push_back(packed("zstd", seeds.back()));
  return seeds;
}

std::vector<std::string> database_seeds() {
  std::vector<std::string> seeds = missions("mission.db3");
  seeds.push_back(packed("zstd", seeds.front()));
  return seeds;
}

std::vector<std::string> metadata_seeds() {
  return {
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
      "  relative_file_paths:\n    - run_0.db3\n    - \"run_1.db3\"\n  duration:\n"
      "    nanoseconds: 100\n  message_count: 3\n  topics_with_message_count:\n"
      "    - topic_metadata:\n        name: /scan\n        type: sensor_msgs/msg/LaserScan\n"
      "        serialization_format: cdr\n        offered_qos_profiles: \"\"\n"
      "      message_count: 3\n  compression_format: zstd\n  compression_mode: FILE\n",
      "rosbag2_bagfile_information:\n  relative_file_paths: [a.mcap, 'b.mcap', ../c]\n"};
}

}  // namespace

std::vector<Target> recording_targets() {
  return {{"ros1_bag", "mission.bag", ros1_seeds, read_recording},
          {"mcap", "mission.mcap", mcap_seeds, read_recording},
          {"rosbag2_database", "mission.db3", database_seeds, read_database},
          {"rosbag2_metadata", "metadata.yaml", metadata_seeds,
           [](const Path& file, const std::string&) {
             (void)io::read_rosbag2_metadata(file.parent_path());
           }}};
}

}  // namespace roomatlas::fuzz
