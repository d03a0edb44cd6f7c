// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/text/utf8.hpp"

#include <nlohmann/json.hpp>

namespace roomatlas {

std::string as_utf8(const std::string& bytes) {
  using Json = nlohmann::json;
  const std::string written = Json(bytes).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(written).get<std::string>();
}

}  // namespace roomatlas
