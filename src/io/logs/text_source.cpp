// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_source.hpp"

#include "roomatlas/mission/plausible.hpp"
#include "text/numbers.hpp"

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/text/utf8.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::int64_t kMostListed = 100;  // one by one; all are counted

}  // namespace

TextSource::TextSource(const std::filesystem::path& file, const MissionOptions& options,
                       const char* format)
    : reader_(file) {
  info_.file = as_utf8(file.filename().string());
  info_.format = format;
  info_.odometry = "none";
  info_.footprint = options.footprint;
}

void TextSource::set_laser(std::shared_ptr<const RangeSensor> laser) {
  laser_ = std::move(laser);
  info_.sensors.push_back(laser_);
}

void TextSource::warn(std::string field, std::string message) {
  info_.issues.push_back(
      {Severity::warning, info_.file, line_, std::move(field), std::move(message)});
}

/// @param tag empty where it is not known; may be any word
void TextSource::leave_out(const std::string& tag, const std::string& problem) {
  left_out_.add(tag, line_, problem);
  if (++info_.malformed_lines > kMostListed) {
    ++info_.issues_not_listed;
    return;
  }
  warn("", problem + "; the line is left out: correct it or delete it");
}

void TextSource::note_end() {
  left_out_.explain(info_);
  if (reader_.end() == LineReader::End::complete) return;
  warn(
      "",
      reader_.end() == LineReader::End::wrong_checksum
          ? LineReader::kWrongChecksumMessage
          : "the log is cut short after this line because its gzip data ends or is damaged; mapped "
            "up to the cut. Copy the file again to have the rest");
  std::rotate(info_.issues.begin(), info_.issues.end() - 1, info_.issues.end());  // explains others
}

std::optional<MissionEvent> TextSource::next() {
  while (true) {
    if (auto reading = use_decided()) return std::move(*reading);
    const std::optional<std::string_view> line = reader_.next();
    line_ = reader_.line_number();
    if (!line) break;
    take_line(*line);
  }
  spikes_.finish();
  if (auto reading = use_decided()) return std::move(*reading);
  line_ = reader_.line_number();
  if (!std::exchange(ended_, true)) note_end();
  return std::nullopt;
}

void TextSource::take_line(std::string_view line) {
  if (reader_.line_is_too_long()) return leave_out("", "the line is too long");
  const Tokens fields(line);
  if (fields.at_end() || Tokens(fields).next().front() == '#') return;
  LineContent content = read(fields);
  if (!content.problem.empty()) return leave_out(content.tag, content.problem);
  content.line = line_;
  std::optional<StampedPose> pose;
  if (content.odom_from_robot) pose = {content.timestamp_s.value_or(0.0), *content.odom_from_robot};
  const std::string source = content.tag;
  spikes_.push(source, pose, std::move(content));
}

/// The next reading among the lines that need not wait any longer.
std::optional<RangeReading> TextSource::use_decided() {
  while (const auto decided = spikes_.take()) {
    line_ = decided->message.line;
    if (decided->jump_m > 0.0) {
      leave_out(
          decided->message.tag,
          "the position jumps " + shown(decided->jump_m) +
              " m away from the line before it and does not stay there: expected what a robot "
              "can drive in that time");
    } else if (auto reading = use(decided->message)) {
      return reading;
    }
  }
  return std::nullopt;
}

void TextSource::note_time(double timestamp_s) {
  if (info_.last_timestamp_s && timestamp_s < *info_.last_timestamp_s) ++info_.steps_back_in_time;
  if (!info_.first_timestamp_s) info_.first_timestamp_s = timestamp_s;
  info_.last_timestamp_s = timestamp_s;
}

std::optional<RangeReading> TextSource::use(const LineContent& content) {
  ++info_.line_counts[content.tag];
  if (content.timestamp_s) note_time(*content.timestamp_s);
  if (content.odom_from_robot) {
    if (odom_from_robot_) {
      info_.path_length_m +=
          (content.odom_from_robot->position() - odom_from_robot_->position()).norm();
    }
    odom_from_robot_ = content.odom_from_robot;
  }
  if (content.ranges_m.empty()) return std::nullopt;
  if (!odom_from_robot_) {
    warn("", "no odometry before this reading: its pose is taken as the origin");
    odom_from_robot_ = Pose2{};
  }
  const double number = static_cast<double>(info_.readings++);
  if (!info_.has_times) note_time(number);
  return RangeReading{content.timestamp_s.value_or(number), *odom_from_robot_, laser_,
                      content.ranges_m};
}

std::shared_ptr<const RangeSensor> make_laser(const Pose2& robot_from_laser, int beams,
                                              double start_rad, double step_rad,
                                              double max_range_m) {
  auto laser = std::make_shared<RangeSensor>();
  laser->max_range_m = static_cast<double>(static_cast<float>(max_range_m));
  for (int i = 0; i < beams; ++i) {
    laser->robot_from_beam.push_back(robot_from_laser *
                                     Pose2{0.0, 0.0, wrap_angle(start_rad + i * step_rad)});
  }
  return laser;
}

double NumberFields::number(const char* field) {
  if (!problem_.empty()) return 0.0;
  const std::string_view token = fields_.next();
  const auto value = parse_number(token);
  if (value && std::isfinite(*value)) return *value;
  problem_ = std::string(field) + ": expected a finite number, found " +
             (token.empty() ? "the end of the line" : quoted(token));
  return 0.0;
}

Pose2 NumberFields::pose(double metres_per_unit) {
  const double x_m = number("x") * metres_per_unit;
  const double y_m = number("y") * metres_per_unit;
  if (problem_.empty() && !(std::abs(x_m) <= kFarthest_m && std::abs(y_m) <= kFarthest_m)) {
    problem_ = "x, y: expected at most 9990 km from the origin, found " + shown(x_m) + " m, " +
               shown(y_m) + " m";
  }
  return {x_m, y_m, wrap_angle(number("theta"))};
}

std::vector<float> NumberFields::ranges(int count, double metres_per_unit) {
  std::vector<float> ranges_m;
  for (int i = 0; i < count; ++i) {
    const double range = number("range");
    ranges_m.push_back(static_cast<float>(range * metres_per_unit));
  }
  return ranges_m;
}

void NumberFields::end() {
  if (problem_.empty() && !fields_.at_end()) {
    problem_ = std::to_string(fields_.count()) + " fields too many";
  }
}

}  // namespace roomatlas::io
