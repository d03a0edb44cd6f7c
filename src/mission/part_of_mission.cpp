// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/mission/part_of_mission.hpp"

namespace roomatlas {

std::string MissionPart::suffix() const { return is_whole() ? "" : "#" + std::to_string(number); }

PartOfMission::PartOfMission(MissionSource& mission, const MissionPart& part)
    : BorrowedMission(mission), part_(part) {}

bool PartOfMission::takes(const MissionEvent& event) {
  if (std::holds_alternative<TruePose>(event)) {
    const bool is_inside = reading_ >= part_.first && reading_ <= part_.last;
    truths_ += is_inside ? 1 : 0;
    return is_inside;
  }
  if (reading_++ < part_.first) return false;
  const auto& reading = std::get<RangeReading>(event);
  const StampedPose at{reading.timestamp_s, reading.odom_from_robot};
  if (last_) path_m_ += (at.pose.position() - last_->pose.position()).norm();
  if (!first_) first_ = at;
  last_ = at;
  ++taken_;
  return true;
}

std::optional<MissionEvent> PartOfMission::next() {
  while (reading_ <= part_.last) {
    std::optional<MissionEvent> event = BorrowedMission::next();
    if (!event || takes(*event)) return event;
  }
  return std::nullopt;
}

const MissionInfo& PartOfMission::info() const {
  if (part_.is_whole()) return BorrowedMission::info();
  info_ = BorrowedMission::info();
  info_.file += part_.suffix();
  info_.readings = taken_;
  info_.true_poses = truths_;
  info_.path_length_m = path_m_;
  if (first_) info_.first_timestamp_s = first_->timestamp_s;
  if (last_) info_.last_timestamp_s = last_->timestamp_s;
  return info_;
}

}  // namespace roomatlas
