// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/trajectories/closures_file.hpp"

#include <array>
#include <cmath>
#include <string>

#include "roomatlas/core/issue.hpp"
#include "text/line_reader.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace roomatlas {
namespace {

constexpr std::array<const char*, 5> kFields = {"from_asr", "to_asr", "x_m", "y_m", "theta_rad"};

/// What is wrong with the line, or empty.
std::string read_line(std::string_view line, std::vector<GivenClosure>& closures) {
  io::Tokens words(line);
  if (words.count() != kFields.size()) {
    return "expected five fields: from_asr to_asr x_m y_m theta_rad, found " +
           std::to_string(words.count());
  }
  std::array<double, kFields.size()> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string_view word = words.next();
    const auto number = io::parse_number(word);
    const bool is_id = i < 2;
    if (!number || !std::isfinite(*number) ||
        (is_id && (*number < 1.0 || *number > 1e9 || *number != std::floor(*number)))) {
      return std::string(kFields[i]) + ": expected " +
             (is_id ? "the number of an ASR" : "a number") + ", found " + io::quoted(word);
    }
    numbers[i] = *number;
  }
  closures.push_back({static_cast<AsrId>(numbers[0]),
                      static_cast<AsrId>(numbers[1]),
                      {numbers[2], numbers[3], wrap_angle(numbers[4])}});
  if (closures.back().from == closures.back().to) return "to_asr: an ASR cannot close on itself";
  return {};
}

}  // namespace

std::vector<GivenClosure> read_closures(const std::filesystem::path& file) {
  io::LineReader reader(file);
  std::vector<GivenClosure> closures;
  while (const auto full = reader.next()) {
    const std::string_view line = full->substr(0, full->find('#'));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const std::string wrong = read_line(line, closures);
    if (!wrong.empty()) {
      throw InputError(file.string() + ":" + std::to_string(reader.line_number()) + ": " + wrong +
                       "; correct or delete the line");
    }
  }
  if (closures.empty()) throw InputError(file.string() + ": holds no closure");
  return closures;
}

}  // namespace roomatlas
