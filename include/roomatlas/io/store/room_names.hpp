// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "roomatlas/plan/ids.hpp"

namespace roomatlas {

/// Gives a room of the plan another name. Nobody may have the store open for writing. Throws
/// InputError when it is no store, or has no such room.
void rename_room(const std::filesystem::path& store, RoomId id, const std::string& name);

}  // namespace roomatlas
