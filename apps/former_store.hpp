// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"
#include "settings.hpp"

namespace roomatlas::apps {

/// The rooms of the store that is about to be replaced, for their numbers and names; none where
/// there is no store. A store of another log has another frame: nothing is carried over, and a
/// warning names the rooms whose names are lost.
[[nodiscard]] std::vector<PlanRoom> rooms_to_carry_over(const std::filesystem::path& store,
                                                        const std::string& mission_sha256);

/// @throws OtherVersion for a store that another release wrote, unless `settings.force`: what
/// people
///   put into it (names, corrections) would be lost
void require_known_version(const Settings& settings, const std::filesystem::path& store);

}  // namespace roomatlas::apps
