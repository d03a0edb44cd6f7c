// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_world_draft.hpp"

namespace roomatlas::random_world_draft {

// Each puts a building of one kind together, of about `rooms` rooms.

[[nodiscard]] Draft offices(RandomStream& random, Style style, int rooms);
[[nodiscard]] Draft long_corridor(RandomStream& random, Style style, int rooms);
[[nodiscard]] Draft ring(RandomStream& random, Style style, int rooms);
[[nodiscard]] Draft hall(RandomStream& random, Style style, int rooms);
[[nodiscard]] Draft open_plan(RandomStream& random, Style style, int rooms);
[[nodiscard]] Draft apartment(RandomStream& random, Style style, int rooms);
[[nodiscard]] Draft wings(RandomStream& random, Style style, int rooms);
[[nodiscard]] Draft rotunda(RandomStream& random, Style style, int rooms);

}  // namespace roomatlas::random_world_draft
