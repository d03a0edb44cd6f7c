// SPDX-License-Identifier: GPL-3.0-or-later
#include "target.hpp"

namespace roomatlas::fuzz {

std::vector<std::vector<Target>> families() {
  return {log_targets(),  recording_targets(), message_targets(), table_targets(),
          plan_targets(), picture_targets(),   store_targets(),   configuration_targets()};
}

}  // namespace roomatlas::fuzz
