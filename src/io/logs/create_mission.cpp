// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/bag_writer.hpp"
#include "bags/mission_bag.hpp"

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/logs/carmen_writer.hpp"
#include "roomatlas/io/logs/mission_writer.hpp"

namespace roomatlas {
namespace {

bool is_carmen_name(const Path& file) {
  return file.extension() == ".clf" || file.extension() == ".log";
}

}  // namespace

std::unique_ptr<MissionWriter> create_mission(const Path& file, const RangeSensor& sensor,
                                              const RobotFootprint& footprint) {
  if (is_carmen_name(file)) return std::make_unique<CarmenWriter>(file, sensor, footprint);
  if (is_recording_name(file))
    return std::make_unique<io::MissionBag>(io::create_bag(file), file.string());
  throw InputError(file.string() +
                   ": no mission is written under such a name; expected one that ends in .mcap, "
                   ".bag, .db3 or .clf, or a folder's for a rosbag2");
}

bool is_recording_name(const Path& file) { return io::bag_container_of(file).has_value(); }

}  // namespace roomatlas
