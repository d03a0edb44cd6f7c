// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokens.hpp"

#include "numbers.hpp"

namespace roomatlas::io {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view without_leading_blanks(std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_blank(text[begin])) ++begin;
  return text.substr(begin);
}

}  // namespace

Tokens::Tokens(std::string_view line) : rest_(without_leading_blanks(line)) {}

std::string_view Tokens::next() {
  std::size_t end = 0;
  while (end < rest_.size() && !is_blank(rest_[end])) ++end;
  const std::string_view token = rest_.substr(0, end);
  rest_ = without_leading_blanks(rest_.substr(end));
  return token;
}

std::size_t Tokens::count() const {
  std::size_t count = 0;
  for (Tokens ahead = *this; !ahead.at_end(); ++count) (void)ahead.next();
  return count;
}

std::size_t Tokens::count_numbers() const {
  std::size_t count = 0;
  for (Tokens ahead = *this; !ahead.at_end();) {
    if (parse_number(ahead.next())) ++count;
  }
  return count;
}

std::string quoted(std::string_view token) {
  constexpr std::size_t kLongest = 24;  // in a message
  std::string text = "'";
  for (const char c : token.substr(0, kLongest)) text += c > ' ' && c <= '~' ? c : '?';
  return text + (token.size() > kLongest ? "...'" : "'");
}

}  // namespace roomatlas::io
