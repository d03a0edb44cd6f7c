// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_reader.hpp"

#include "roomatlas/mission/plausible.hpp"
#include "text/numbers.hpp"

#include <charconv>
#include <cmath>
#include <utility>

namespace roomatlas::io {

FieldReader::FieldReader(std::string_view tag, std::string_view line)
    : tag_(tag), fields_(line), behind_announced_("") {
  (void)fields_.next();
}

void FieldReader::fail(std::string field, std::string message) {
  if (problem_) return;
  if (!field.empty()) field = std::string(tag_) + " " + field;
  problem_ = CarmenProblem{std::move(field), std::move(message)};
}

double FieldReader::number(const char* field) {
  if (problem_) return 0.0;
  const std::string_view token = fields_.next();
  const std::optional<double> value = parse_number(token);
  if (value && std::isfinite(*value)) return *value;
  fail(field, token.empty() ? "expected a finite number, found the end of the line"
                            : "expected a finite number, found " + quoted(token));
  return 0.0;
}

double FieldReader::coordinate(const char* field, double farthest_m, const char* expected) {
  const std::string_view token = Tokens(fields_).next();
  const double value_m = number(field);
  if (std::abs(value_m) <= farthest_m) return value_m;
  fail(field, std::string("expected ") + expected + ", found " + quoted(token));
  return 0.0;
}

Pose2 FieldReader::pose(const char* x_field, const char* y_field, const char* theta_field) {
  constexpr const char* kExpected = "metres, at most 9990 km from the origin";
  Pose2 pose;
  pose.x_m = coordinate(x_field, kFarthest_m, kExpected);
  pose.y_m = coordinate(y_field, kFarthest_m, kExpected);
  pose.theta_rad = wrap_angle(number(theta_field));
  return pose;
}

Pose2 FieldReader::mount(const char* x_field, const char* y_field, const char* theta_field) {
  constexpr const char* kExpected = "metres, at most 10 m from the robot's centre";
  Pose2 pose;
  pose.x_m = coordinate(x_field, kFarthestMount_m, kExpected);
  pose.y_m = coordinate(y_field, kFarthestMount_m, kExpected);
  pose.theta_rad = wrap_angle(number(theta_field));
  return pose;
}

std::size_t FieldReader::count(const char* field) {
  if (problem_) return 0;
  const std::string_view token = fields_.next();
  const char* const end = token.data() + token.size();
  std::size_t value = 0;
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (token.empty() || stop != end || error != std::errc()) {
    fail(field, token.empty() ? "expected a whole number, found the end of the line"
                              : "expected a whole number, found " + quoted(token));
  }
  return value;
}

void FieldReader::ranges(std::vector<float>& ranges_m) {
  ranges_m.clear();
  announced_ = count("number of readings");
  if (!problem_ && announced_ == 0) fail("number of readings", "expected at least 1, found 0");
  behind_announced_ = fields_;
  for (std::size_t i = 0; i < announced_ && !problem_; ++i) {
    const std::string_view token = fields_.next();
    if (const std::optional<float> range = parse_range(token)) {
      ranges_m.push_back(*range);
    } else if (token.empty() || fields_.count() < 2) {  // the end of the line, or its host name
      fail_announced();
    } else {
      fail("reading " + std::to_string(i + 1), "expected a number, found " + quoted(token));
    }
  }
}

bool FieldReader::is_trailer() const {
  Tokens ahead = fields_;
  const std::string_view timestamp = ahead.next();
  const std::string_view host = ahead.next();
  (void)ahead.next();
  return ahead.at_end() && parse_number(timestamp) && !parse_number(host);
}

void FieldReader::skip_counted(const char* field) {
  const std::size_t announced = count(field);
  for (std::size_t i = 0; i < announced && !problem_; ++i) (void)number(field);
}

void FieldReader::fail_announced() {
  fail("", std::string(tag_) + " announces " + std::to_string(announced_) +
               " readings but the line has " + std::to_string(behind_announced_.count_numbers()) +
               " numbers");
}

}  // namespace roomatlas::io
