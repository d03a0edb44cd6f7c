// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_field.hpp"

#include "json.hpp"
#include "roomatlas/core/issue.hpp"

#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr std::size_t kLongestQuote = 40;  // of a wrong value, in a message

std::string quoted(const Json& value) {
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > kLongestQuote) text = text.substr(0, kLongestQuote) + "...";
  return text;
}

}  // namespace

JsonField JsonField::at(const std::string& key) const {
  if (!value_->is_object()) fail("an object");
  const auto member = value_->find(key);
  const std::string place = place_.empty() ? key : place_ + "." + key;
  if (member == value_->end()) {
    throw InputError(to_string(Issue{Severity::error, file_, 0, place, "missing"}));
  }
  return {*member, file_, place};
}

std::optional<JsonField> JsonField::find(const std::string& key) const {
  if (!value_->is_object()) fail("an object");
  const auto member = value_->find(key);
  if (member == value_->end() || member->is_null()) return std::nullopt;
  return at(key);
}

JsonField JsonField::element(std::size_t index) const {
  return {value_->at(index), file_, place_ + "[" + std::to_string(index) + "]"};
}

bool JsonField::is_null() const { return value_->is_null(); }

std::size_t JsonField::size() const {
  if (!value_->is_array()) fail("an array");
  return value_->size();
}

double JsonField::number() const {
  const double number = value_->is_number() ? value_->get<double>() : std::nan("");
  constexpr double kLargest = 1e15;  // what is reckoned from it is a number, too
  if (!std::isfinite(number)) fail("a finite number");
  if (std::abs(number) > kLargest) fail("a number of at most 1e15");
  return number;
}

double JsonField::number_not_negative() const {
  if (number() < 0.0) fail("a number >= 0");
  return number();
}

std::int64_t JsonField::positive_integer() const {
  // What fits the signed type that ids have.
  constexpr auto kLargest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  // Literals without a sign are parsed as unsigned, so a signed one is negative.
  const std::uint64_t number = value_->is_number_unsigned() ? value_->get<std::uint64_t>() : 0;
  if (number == 0 || number > kLargest) fail("a whole number >= 1");
  return static_cast<std::int64_t>(number);
}

std::string JsonField::text() const {
  if (!value_->is_string()) fail("a text");
  return value_->get<std::string>();
}

void JsonField::fail(const std::string& expected) const {
  const std::string message = "expected " + expected + ", found " + quoted(*value_);
  throw InputError(to_string(Issue{Severity::error, file_, 0, place_, message}));
}

}  // namespace roomatlas
