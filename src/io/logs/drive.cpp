// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/number_rows.hpp"

#include "roomatlas/io/logs/drive.hpp"

namespace roomatlas {

Drive read_drive(const Path& file) {
  Drive drive;
  io::read_number_rows(file, {"x", "y"}, [&](std::span<const double> row) {
    drive.emplace_back(row[0], row[1]);
    return std::string();
  });
  return drive;
}

}  // namespace roomatlas
