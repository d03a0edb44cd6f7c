// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/pictures.hpp"
#include "plugins/plugin.hpp"

namespace roomatlas::io {

/// @param purpose what cannot be done without it
[[nodiscard]] inline Plugin pictures_plugin(const std::string& purpose) {
  return {"roomatlas-pictures.so", purpose, "roomatlas-pictures"};
}

}  // namespace roomatlas::io
