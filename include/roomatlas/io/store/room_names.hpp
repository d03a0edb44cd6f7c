// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "roomatlas/plan/ids.hpp"

namespace roomatlas {

/// Gives a room of the plan another name, and keeps with it the statements about the building that
/// are then told (`edits_json`; empty: none), in one transaction. Nobody may have the store open
/// for writing. Throws InputError when it is no store, or has no such room.
void rename_room(const std::filesystem::path& store, RoomId id, const std::string& name,
                 const std::string& edits);

}  // namespace roomatlas
