// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas {

/// Way-points of a scripted drive: `x y` a line, metres, `#` starts a comment.
[[nodiscard]] Drive read_drive(const Path& file);

}  // namespace roomatlas
