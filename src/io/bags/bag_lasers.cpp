// SPDX-License-Identifier: GPL-3.0-or-later
// How a recording's source makes readings of sweeps.
#include "bags/bag_source.hpp"

#include "text/nearest_name.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomatlas::io {

void BagSource::refuse_without_mount(std::size_t topic, const std::string& frame,
                                     const std::string& remedy) {
  describe();  // with the frames that are there
  const std::string sensor = topics_[topic].use == Use::range ? "sonar" : "laser";
  std::vector<std::string> frames = {frame};
  for (const FrameEdge& edge : poses_->frames().edges()) {
    frames.insert(frames.end(), {edge.parent, edge.child});
  }
  const std::string& base = choice_.base_frame;
  const bool is_unknown = std::count(frames.begin(), frames.end(), base) == 0;
  const std::string nearest =
      is_unknown ? " (no frame is called so; nearest comes " + nearest_name(base, frames) + ")"
                 : "";
  throw InputError(info_.file + ": " + reader_->topics()[topic].name + ": where its " + sensor +
                   " sits on the robot is not known: no tf joins the robot's frame " + base +
                   nearest + " and the " + sensor + "'s " + frame + "; " + remedy);
}

void BagSource::refuse_laser(std::size_t topic, const std::string& frame) {
  refuse_without_mount(topic, frame,
                       "tell it by --laser-mount x,y,deg (0,0,0: at the centre, looking ahead), or "
                       "name the robot's frame by --base-frame");
}

/// Whether the other lasers' sweeps about that time are there, with odometry for them.
bool BagSource::is_group_told(const Waiting& waiting) const {
  if (group_.empty()) return true;
  return std::all_of(group_.topics().begin(), group_.topics().end(), [&](std::size_t topic) {
    if (!group_.is_there(topic, waiting.stamp_ns)) return false;
    const LaserGroup::Sweep* sweep = group_.nearest(topic, waiting.stamp_ns);
    if (sweep == nullptr) return true;
    const auto pose = poses_->odom_from_base(sweep->until_ns);
    return pose && pose->beyond_ns == 0;
  });
}

RangeReading BagSource::laser_reading(const Waiting& waiting) {
  const bool has_odometry = choice_.odometry != TopicChoice::Odometry::none;
  RangeReading first =
      lasers_.read({waiting.topic, std::get<LaserScanMessage>(waiting.content), waiting.stamp_ns,
                    waiting.stamp_ns, mount_of(waiting)->transform, choice_.beam_order},
                   *poses_, has_odometry);
  if (group_.empty()) return first;
  std::vector<std::optional<RangeReading>> parts = {std::move(first)};
  for (const std::size_t topic : group_.topics()) {
    parts.push_back(companion_reading(topic, waiting));
  }
  return group_.joined(parts);
}

std::optional<RangeReading> BagSource::companion_reading(std::size_t topic,
                                                         const Waiting& waiting) {
  const LaserGroup::Sweep* sweep = group_.nearest(topic, waiting.stamp_ns);
  std::optional<RangeReading> reading;
  if (sweep != nullptr) {
    const std::string& frame = sweep->scan.header.frame;
    const auto mount = poses_->base_from(frame, sweep->stamp_ns);
    if (!mount) refuse_laser(topic, frame);
    reading =
        lasers_.read({topic, sweep->scan, sweep->stamp_ns, waiting.stamp_ns, mount->transform},
                     *poses_, choice_.odometry != TopicChoice::Odometry::none);
  }
  group_.forget_before(topic, waiting.stamp_ns, sweep);
  return reading;
}

/// Without time and pose.
RangeReading BagSource::cloud_reading(const Waiting& waiting) {
  const auto& cloud = std::get<CloudMessage>(waiting.content);
  SweepPath path;
  if (!cloud.times_s.empty() && choice_.odometry != TopicChoice::Odometry::none) {
    const auto [first, last] = std::minmax_element(cloud.times_s.begin(), cloud.times_s.end());
    const auto time_of_point = [&](float off_s) {
      return waiting.stamp_ns + std::llround(1e9 * static_cast<double>(off_s));
    };
    path = SweepPath(*poses_, waiting.stamp_ns, time_of_point(*first), time_of_point(*last));
  }
  const RecordingOptions& recording = options_.recording;
  return clouds_.read(
      cloud, mount_of(waiting)->transform,
      {recording.cloud_low_m, recording.cloud_high_m, evidence_[waiting.topic].is_flat,
       options_.footprint, options_.laser_max_range_m},
      path);
}

}  // namespace roomatlas::io
