// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "json.hpp"

namespace roomatlas::io {

/// The number, or null where it is not finite.
[[nodiscard]] inline Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace roomatlas::io
