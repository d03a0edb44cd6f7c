// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

// Numbers and names of rooms across stores and assemblies. All take the file of a store that
// nobody has open for writing, and throw InputError when it is none.

/// Gives a room of the plan another name. Throws InputError when there is no such room.
void rename_room(const std::filesystem::path& store, RoomId id, const std::string& name);

/// Rooms whose numbers and names the next assembly carries over: those of the plan that is there,
/// else those that were put, from a store that this one replaced.
[[nodiscard]] std::vector<PlanRoom> former_rooms(const std::filesystem::path& store);

/// Replaces what was put; the store keeps numbers, names, areas and polygons.
void put_former_rooms(const std::filesystem::path& store, const std::vector<PlanRoom>& rooms);

}  // namespace roomatlas
