// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace roomatlas {

/// The greatest whole number that is not greater: what `std::floor` gives, which is a call of the
/// mathematics library where the processor is not known to round. Cells are asked for too often for
/// that.
/// @param value of less than 2^62
[[nodiscard]] inline std::int64_t floored(double value) {
  const auto whole = static_cast<std::int64_t>(value);  // towards zero
  return whole - (static_cast<double>(whole) > value ? 1 : 0);
}

}  // namespace roomatlas
