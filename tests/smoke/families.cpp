// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/target.hpp"

namespace roomatlas::fuzz {

std::vector<std::vector<Target>> families() { return {message_targets(), table_targets()}; }

}  // namespace roomatlas::fuzz
