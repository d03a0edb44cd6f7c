// SPDX-License-Identifier: GPL-3.0-or-later
#include "carmen_source.hpp"

#include "carmen_parser.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

#include "roomatlas/io/text/utf8.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr int kProbedLines = 1000;  // without a known message: then it is no such log
constexpr std::int64_t kMostMalformedListed = 100;  // one by one; all are counted
constexpr std::size_t kMostIgnoredTags = 64;        // kept by name: a damaged log has thousands

bool is_comment(std::string_view tag) { return tag.empty() || tag.front() == '#'; }

bool looks_like_tag(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  const auto fits = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= 32 && is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), fits);
}

/// The robot's pose on the line, where it has one.
std::optional<StampedPose> robot_pose(const CarmenMessage& message) {
  const double timestamp_s = message.timestamp_s.value_or(0.0);
  if (message.tag->kind == CarmenKind::odometry) return StampedPose{timestamp_s, message.pose};
  if (message.tag->kind != CarmenKind::laser || !message.scan.has_poses) return std::nullopt;
  return StampedPose{timestamp_s, message.scan.odom_from_robot};
}

}  // namespace

CarmenSource::CarmenSource(const std::filesystem::path& file, const MissionOptions& options)
    : reader_(file), catalog_(options, info_.sensors) {
  info_.file = as_utf8(file.filename().string());
  info_.format = "CARMEN";
  info_.odometry = "none";
  info_.footprint = options.footprint;
  read_first_message(file.string());
}

void CarmenSource::read_first_message(const std::string& name) {
  for (int unknown = 0; unknown < kProbedLines;) {
    const std::optional<std::string_view> line = reader_.next();
    if (!line) {
      const bool whole = reader_.end() == LineReader::End::complete;
      if (!whole) throw InputError(name + ": is cut short before its first message; copy it again");
      if (unknown > 0) break;
      throw InputError(name + ": holds comments only; nothing was recorded in it");
    }
    const std::string_view word = Tokens(*line).next();
    if (is_comment(word)) continue;
    if (const CarmenTag* tag = find_carmen_tag(word)) return read_message(*tag, *line);
    count_ignored(word);
    ++unknown;
  }
  throw InputError(name +
                   ": is not a CARMEN log: none of its first lines begins with a known tag (" +
                   list_carmen_tags() + "); name a mission log");
}

std::optional<MissionEvent> CarmenSource::next() {
  while (!queue_.ready()) {
    if (read_line()) continue;
    spikes_.finish();
    if (use_decided()) continue;
    if (queue_.empty()) {
      if (!std::exchange(ended_, true)) left_out_.explain(info_);
      return std::nullopt;
    }
    break;
  }
  return hand_out(queue_.take());
}

/// Reads one line, whatever is in it. False at the end.
bool CarmenSource::read_line() {
  const std::optional<std::string_view> line = reader_.next();
  line_ = reader_.line_number();
  if (!line) {
    if (reader_.end() != LineReader::End::complete) report_cut();
    return false;
  }
  if (reader_.line_is_too_long()) {
    add_malformed(
        "", {"", "the line is longer than " + std::to_string(LineReader::kLongestLine) + " bytes"});
    return true;
  }
  const std::string_view word = Tokens(*line).next();
  if (is_comment(word)) return true;
  if (const CarmenTag* tag = find_carmen_tag(word)) {
    read_message(*tag, *line);
  } else if (!reader_.line_is_terminated() && begins_carmen_tag(word)) {
    report_cut();
  } else {
    count_ignored(word);
  }
  return true;
}

void CarmenSource::read_message(const CarmenTag& tag, std::string_view line) {
  line_ = reader_.line_number();
  std::optional<CarmenProblem> problem = parse_carmen_line(tag, line, message_);
  if (is_cut_off(tag, problem.has_value())) return report_cut();
  if (problem) return add_malformed(tag.name, *problem);
  message_.line = line_;
  const std::optional<StampedPose> pose = robot_pose(message_);
  spikes_.push(tag.name, pose, std::move(message_));
  (void)use_decided();
}

bool CarmenSource::use_decided() {
  bool any = false;
  while (auto decided = spikes_.take()) {
    any = true;
    message_ = std::move(decided->message);
    line_ = message_.line;
    if (decided->jump_m == 0.0) {
      use_message();
    } else {
      add_malformed(message_.tag->name,
                    {std::string(message_.tag->name) + " position",
                     "jumps " + shown(decided->jump_m) +
                         " m away from the line before it and does not stay there: expected "
                         "what a robot can drive in that time"});
    }
  }
  line_ = reader_.line_number();
  return any;
}

/// A last line without its end is whole only if nothing is missing that the lines before it had.
bool CarmenSource::is_cut_off(const CarmenTag& tag, bool malformed) const {
  if (reader_.line_is_terminated()) return false;
  if (malformed || reader_.end() != LineReader::End::complete) return true;
  const auto state = tags_.find(&tag);
  if (state == tags_.end()) return false;
  return message_.trailing_fields < state->second.trailing_fields ||
         message_.scan.has_poses < state->second.has_poses;
}

void CarmenSource::report_cut() {
  if (std::exchange(cut_reported_, true)) return;
  const bool damaged = reader_.end() == LineReader::End::damaged;
  if (reader_.end() == LineReader::End::wrong_checksum) {
    add_issue(Severity::warning, "", LineReader::kWrongChecksumMessage);
  } else {
    add_issue(Severity::warning, "",
              std::string("the log is cut short in or after this line") +
                  (damaged ? " because its gzip data is damaged" : "") +
                  "; mapped up to the cut. Copy the file again to have the rest");
  }
  std::rotate(info_.issues.begin(), info_.issues.end() - 1, info_.issues.end());  // explains others
}

void CarmenSource::count_ignored(std::string_view tag) {
  std::string key = looks_like_tag(tag) ? std::string(tag) : "(not a tag)";
  if (info_.ignored_line_counts.size() >= kMostIgnoredTags &&
      !info_.ignored_line_counts.contains(key)) {
    key = "(others)";
  }
  ++info_.ignored_line_counts[key];
}

/// @param tag empty where it is not known
void CarmenSource::add_malformed(std::string_view tag, const CarmenProblem& problem) {
  left_out_.add(std::string(tag), line_,
                (problem.field.empty() ? "" : problem.field + ": ") + problem.message);
  if (++info_.malformed_lines > kMostMalformedListed) {
    ++info_.issues_not_listed;
    return;
  }
  add_issue(Severity::warning, problem.field,
            problem.message + "; the line is left out: correct it or delete it");
}

/// Adds what concerns the log as a whole, of which there are a few at most, whatever the limit.
void CarmenSource::add_issue(Severity severity, std::string field, std::string message) {
  info_.issues.push_back({severity, info_.file, line_, std::move(field), std::move(message)});
}

}  // namespace roomatlas::io
