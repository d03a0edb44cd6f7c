// SPDX-License-Identifier: GPL-3.0-or-later
// ASRs placed where the robot truly was, and known wrong corrections of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "../../src/io/text/line_reader.hpp"
#include "roomatlas/graph/recognise.hpp"
#include "roomatlas/pipeline/options.hpp"
#include "support/memory_store.hpp"

namespace roomatlas::test {

inline std::vector<std::vector<std::string>> words_of_lines(const std::filesystem::path& file) {
  std::vector<std::vector<std::string>> lines;
  io::LineReader reader(file);
  while (const auto line = reader.next()) {
    std::istringstream stream{std::string(*line)};
    std::vector<std::string>& words = lines.emplace_back();
    for (std::string word; stream >> word;) words.push_back(word);
  }
  return lines;
}

/// A number, counted from the end of a line.
inline double number(const std::vector<std::string>& words, std::size_t from_end) {
  return std::atof(words.at(words.size() - from_end).c_str());
}

/// The poses of a corrected log at the raw log's timestamps: its logger times are the raw log's.
inline Trajectory poses_of_corrected_log(const std::filesystem::path& raw,
                                         const std::filesystem::path& corrected) {
  std::map<double, double> timestamp_at;  // by logger time
  for (const auto& words : words_of_lines(raw)) {
    if (words.size() > 10 && words[0] == "FLASER")
      timestamp_at[number(words, 1)] = number(words, 3);
  }
  Trajectory poses;
  for (const auto& words : words_of_lines(corrected)) {
    if (words.size() < 11 || words[0] != "FLASER") continue;
    const double logger_s = number(words, 1);
    const auto at = timestamp_at.lower_bound(logger_s - 0.01);
    if (at == timestamp_at.end() || std::abs(at->first - logger_s) > 0.01) continue;
    poses.push_back({at->second, {number(words, 6), number(words, 5), number(words, 4)}});
  }
  return poses;
}

/// `timestamp x y theta` a line.
inline Trajectory poses_of_table(const std::filesystem::path& file) {
  Trajectory poses;
  for (const auto& words : words_of_lines(file)) {
    if (words.size() != 4 || words[0] == "#") continue;
    poses.push_back({number(words, 4), {number(words, 3), number(words, 2), number(words, 1)}});
  }
  return poses;
}

/// Each ASR where its true poses put it in the mean; ASRs without any follow the one before by
/// odometry.
inline Placement true_placement(const std::vector<Asr>& asrs, const Trajectory& truth) {
  std::map<std::int64_t, Pose2> true_pose_at;  // by microseconds
  for (const auto& [t, pose] : truth) true_pose_at.emplace(std::llround(t * 1e6), pose);
  Placement placement;
  const Asr* former = nullptr;
  for (const Asr& asr : asrs) {
    Point2 heading = Point2::Zero();
    Point2 ours = Point2::Zero();
    Point2 theirs = Point2::Zero();
    double count = 0.0;
    for (const PathSample& sample : asr.path) {
      const auto at = true_pose_at.find(std::llround(sample.timestamp_s * 1e6));
      if (at == true_pose_at.end()) continue;
      heading += direction(at->second.theta_rad - sample.asr_from_robot.theta_rad);
      ours += sample.asr_from_robot.position();
      theirs += at->second.position();
      count += 1.0;
    }
    if (count > 0.0) {
      const Pose2 turn{0, 0, std::atan2(heading.y(), heading.x())};
      const Point2 shift = theirs / count - turn * Point2(ours / count);
      placement[asr.id] = {shift.x(), shift.y(), turn.theta_rad};
    } else if (former != nullptr) {
      placement[asr.id] =
          placement.at(former->id) * inverse(former->odom_from_asr) * asr.odom_from_asr;
    } else {
      continue;
    }
    former = &asr;
  }
  return placement;
}

inline Placement odometry_placement(const std::vector<Asr>& asrs) {
  Placement placement;
  for (const Asr& asr : asrs) placement[asr.id] = asr.odom_from_asr;
  return placement;
}

/// Each room turned at the pivot through which it was first entered, one room left and the next
/// right.
inline Placement rooms_turned(const Placement& placement, const std::map<AsrId, RoomId>& room_of,
                              double angle_deg) {
  std::map<RoomId, Pose2> pivot_of;
  for (const auto& [asr, pose] : placement) pivot_of.try_emplace(room_of.at(asr), pose);
  Placement turned;
  for (const auto& [asr, pose] : placement) {
    const RoomId room = room_of.at(asr);
    const double sign = room % 2 == 0 ? -1.0 : 1.0;
    const Pose2& pivot = pivot_of.at(room);
    turned[asr] = pivot * Pose2{0, 0, radians(sign * angle_deg)} * inverse(pivot) * pose;
  }
  return turned;
}

/// Each ASR turned at its own pivot, by the sign of its room.
inline Placement visits_turned(const Placement& placement, const std::map<AsrId, RoomId>& room_of,
                               double angle_deg) {
  Placement turned;
  for (const auto& [asr, pose] : placement) {
    const double sign = room_of.at(asr) % 2 == 0 ? -1.0 : 1.0;
    turned[asr] = pose * Pose2{0, 0, radians(sign * angle_deg)};
  }
  return turned;
}

/// A false loop: the second half of the mission is pulled aside as if a place had been recognised
/// that was not, and the middle of the chain stretches to follow.
inline Placement false_loop(const Placement& placement, double size_m) {
  Placement pulled;
  const auto count = static_cast<double>(placement.size());
  double index = 0.0;
  for (const auto& [asr, pose] : placement) {
    const double share = std::clamp((index - count / 4.0) / (count / 2.0), 0.0, 1.0);
    pulled[asr] = pose;
    pulled[asr].x_m += 0.8 * share * size_m;
    pulled[asr].y_m += 0.6 * share * size_m;
    index += 1.0;
  }
  return pulled;
}

inline std::vector<Asr> all_of(const MemoryStore& store) {
  std::vector<Asr> asrs;
  for (const AsrId id : store.ids()) asrs.push_back(store.get(id, AsrDetail::path));
  return asrs;
}

}  // namespace roomatlas::test
