// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_logs.hpp"

#include "text/line_reader.hpp"
#include "text/tokens.hpp"

namespace roomatlas::io {

OpenLog find_small_log(const std::filesystem::path& file) {
  LineReader reader(file);
  while (const auto line = reader.next()) {
    Tokens fields(*line);
    const std::size_t count = fields.count();
    if (count == 0) continue;
    const std::string_view first = fields.next();
    if (first.front() == '#') continue;
    const std::size_t numbers = fields.count_numbers();
    if ((first == "O" && numbers == 4) || (first == "L" && numbers == 187)) return open_wean_log;
    if ((first == "Odometry" && numbers == 3) || (first == "Laser" && numbers == 182)) {
      return open_duke_log;
    }
    const bool all_numbers = Tokens(*line).count_numbers() == count;
    if (all_numbers && (count == 695 || count == 707)) return open_mines_log;
    return nullptr;
  }
  return nullptr;
}

}  // namespace roomatlas::io
