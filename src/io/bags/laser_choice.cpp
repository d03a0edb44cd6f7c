// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/robot_poses.hpp"
#include "bags/topic_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomatlas::io {
namespace {

constexpr double kAllAroundRad = radians(350.0);  // who sees so much needs no other
constexpr double kLeastViewRad = radians(120.0);  // less is a camera's, which is worse than a laser
constexpr double kLevelRad = radians(2.0);
constexpr double kSameHeightM = 0.25;  // walls look alike at both heights
constexpr double kApartM = 0.05;       // nearer, and turned by less, it is one laser twice
constexpr double kApartRad = radians(10.0);
constexpr double kMostFaster = 2.0;
constexpr std::int64_t kSlack_ns = 2'000'000'000;

bool is_laser(const TopicEvidence& evidence) {
  return evidence.kind == MessageKind::laser || evidence.kind == MessageKind::echoes;
}

/// The mount of a laser that hangs or stands level and does not move; nothing of another.
std::optional<Transform3> level_mount(const TopicChoice& choice, const Survey& survey,
                                      std::size_t topic) {
  const std::vector<std::string>& frames = survey.evidence[topic].frames;
  if (frames.size() != 1) return std::nullopt;
  std::vector<std::string> bases = {choice.base_frame};
  if (is_usual_base(choice.base_frame)) bases.insert(bases.end(), {"base_link", "base_footprint"});
  for (const std::string& base : bases) {
    const auto mount = survey.frames.lookup(base, frames.front(), 0, Constant::holds_always);
    if (!mount) continue;
    const Eigen::Vector3d up = mount->transform.rotation * Eigen::Vector3d::UnitZ();
    const bool is_level = std::abs(up.z()) > std::cos(kLevelRad);
    if (mount->beyond_ns == 0 && is_level) return mount->transform;
    return std::nullopt;
  }
  return std::nullopt;
}

bool is_another_place(const Transform3& a, const Transform3& b) {
  return (a.translation - b.translation).head<2>().norm() > kApartM ||
         std::abs(wrap_angle(planar(a).theta_rad - planar(b).theta_rad)) > kApartRad;
}

bool goes_with(const TopicEvidence& laser, const TopicEvidence& first) {
  const bool is_usable = is_laser(laser) && laser.misfit.empty() && laser.beams > 0 &&
                         laser.messages > laser.unreadable && laser.view_rad >= kLeastViewRad;
  if (!is_usable || laser.frames == first.frames) return false;
  return laser.rate_hz() > first.rate_hz() / kMostFaster &&
         laser.rate_hz() < first.rate_hz() * kMostFaster &&
         std::abs(*laser.first_log_ns - *first.first_log_ns) < kSlack_ns;
}

}  // namespace

void join_lasers(TopicChoice& choice, const Survey& survey, const RecordingOptions& options) {
  const auto all_are_lasers = [&] {
    return std::all_of(choice.scans.begin(), choice.scans.end(),
                       [&](std::size_t i) { return is_laser(survey.evidence[i]); });
  };
  if (choice.scans.empty() || !all_are_lasers()) return;
  const TopicEvidence& first = survey.evidence[choice.scans.front()];
  const bool is_open =
      options.scan_topics.empty() && options.laser_mount.empty() && first.view_rad < kAllAroundRad;
  const auto mount = level_mount(choice, survey, choice.scans.front());
  if (is_open && mount) {
    std::vector<Transform3> taken = {*mount};
    for (std::size_t i = 0; i < survey.topics.size(); ++i) {
      if (i == choice.scans.front() || !goes_with(survey.evidence[i], first)) continue;
      const auto other = level_mount(choice, survey, i);
      if (!other || std::abs(other->translation.z() - mount->translation.z()) > kSameHeightM ||
          !std::all_of(taken.begin(), taken.end(),
                       [&](const Transform3& one) { return is_another_place(one, *other); })) {
        continue;
      }
      taken.push_back(*other);
      choice.scans.push_back(i);
    }
  }
  choice.is_one_reading = choice.scans.size() > 1;
  const double rate_hz = first.rate_hz() > 0.0 ? first.rate_hz() : 10.0;
  choice.half_period_ns = std::llround(0.5e9 / rate_hz);
}

}  // namespace roomatlas::io
