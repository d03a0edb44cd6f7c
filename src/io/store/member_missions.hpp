// SPDX-License-Identifier: GPL-3.0-or-later
// The table `missions`: what a building was joined from. A store of one mission has none.
#pragma once

#include <vector>

#include "database.hpp"
#include "roomatlas/assembly/member_mission.hpp"

namespace roomatlas {

/// Part of a transaction. Replaces what was there.
void write_members(Database& db, const std::vector<MemberMission>& members);

/// In the order of their visits.
[[nodiscard]] std::vector<MemberMission> read_members(Database& db);

}  // namespace roomatlas
