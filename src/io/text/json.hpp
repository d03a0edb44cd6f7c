// SPDX-License-Identifier: GPL-3.0-or-later
// All of it costs a second for each file: headers include json_fwd.hpp.
#pragma once

#include <nlohmann/json.hpp>

#include "json_fwd.hpp"
