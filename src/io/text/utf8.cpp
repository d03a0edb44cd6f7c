// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/text/utf8.hpp"
#include "text/json.hpp"

namespace roomatlas {

std::string as_utf8(const std::string& bytes) {
  return Json::parse(compact(bytes)).get<std::string>();
}

}  // namespace roomatlas
