// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace roomatlas {

/// Keeps the order in which members were added, so that files can be compared.
using Json = nlohmann::ordered_json;

}  // namespace roomatlas
