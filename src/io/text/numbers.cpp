// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbers.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <limits>
#include <system_error>

namespace roomatlas::io {
namespace {

template <typename Number>
std::errc parse_whole(std::string_view token, Number& value) {
  if (token.size() > 1 && token.front() == '+' && token[1] != '-') token.remove_prefix(1);
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  return stop == end ? error : std::errc::invalid_argument;
}

template <typename Number>
void append_shortest(std::string& text, Number value) {
  std::array<char, 512> buffer;  // the longest double without exponent has 327 characters
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
  if (error == std::errc()) text.append(buffer.data(), end);
}

}  // namespace

std::optional<double> parse_number(std::string_view token) {
  double value = 0.0;
  if (parse_whole(token, value) != std::errc()) return std::nullopt;
  return value;
}

std::optional<float> parse_range(std::string_view token) {
  float value = 0.0F;
  const std::errc error = parse_whole(token, value);
  if (error == std::errc::result_out_of_range) return std::numeric_limits<float>::infinity();
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::string shown(double value) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

void append_number(std::string& text, double value) { append_shortest(text, value); }
void append_number(std::string& text, float value) { append_shortest(text, value); }

}  // namespace roomatlas::io
