// SPDX-License-Identifier: GPL-3.0-or-later
// All of it costs a second for each file: headers include json_fwd.hpp.
#pragma once

#include <nlohmann/json.hpp>

#include "json_fwd.hpp"

#include <string>

namespace roomatlas {

/// Without line breaks. What is no UTF-8 in a name becomes U+FFFD instead of an exception.
[[nodiscard]] inline std::string compact(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace roomatlas
