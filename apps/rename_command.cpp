// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>

#include "building_report.hpp"
#include "commands.hpp"
#include "output_places.hpp"
#include "roomatlas/io/plans/edits_file.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/store/room_names.hpp"
#include "roomatlas/io/text/utf8.hpp"
#include "store_edits.hpp"

namespace roomatlas::apps {
namespace {

/// The room of that number, else the only one of that name.
const PlanRoom& find_room(const Path& store, const FloorPlan& plan, const std::string& wanted) {
  std::vector<const PlanRoom*> found;
  for (const PlanRoom& room : plan.rooms) {
    if (std::to_string(room.id) == wanted) return room;
    if (room.name == wanted) found.push_back(&room);
  }
  if (found.size() == 1) return *found.front();
  std::vector<std::string> choices;
  for (const PlanRoom& room : plan.rooms) {
    if (found.empty() || room.name == wanted) choices.push_back(std::to_string(room.id));
  }
  if (!found.empty()) {
    throw UsageError(fmt::format("{}: several rooms are called \"{}\": give one by its number, {}",
                                 store.string(), wanted, fmt::join(choices, " or ")));
  }
  throw UsageError(fmt::format("{}: no room has the number or name \"{}\"; its rooms are {}",
                               store.string(), wanted, fmt::join(choices, ", ")));
}

void check_name(const std::string& name) {
  const bool is_printable =
      std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; });
  if (name.find_first_not_of(' ') == std::string::npos || !is_printable || as_utf8(name) != name) {
    throw UsageError("a room's name must be one line of UTF-8 text that is not empty");
  }
  if (name.size() > kLongestRoomName) {
    throw UsageError(fmt::format("a room's name must have {} bytes at most: this one has {}",
                                 kLongestRoomName, name.size()));
  }
}

/// A name is said once in a plan, and is no other room's number, or nobody could tell the rooms
/// apart.
void require_unused(const Path& store, const FloorPlan& plan, const PlanRoom& chosen,
                    const std::string& name) {
  for (const PlanRoom& room : plan.rooms) {
    if (room.id == chosen.id) continue;
    if (room.name == name) {
      throw UsageError(fmt::format(
          "{}: room {} is called \"{}\" already: choose another name, or rename that room first",
          store.string(), room.id, name));
    }
    if (std::to_string(room.id) == name) {
      throw UsageError(fmt::format("{}: {} is the number of the room \"{}\": choose another name",
                                   store.string(), name, room.name));
    }
  }
}

/// The statements with the name of a room instead of those that it had; as text, empty where none
/// is left. A room that is called by its number again has no name.
std::string with_name(std::vector<Edit> edits, const PlanRoom& room, const std::string& name) {
  std::erase_if(edits, [&](const Edit& edit) {
    if (edit.kind != EditKind::name_room || !edit.rooms.front().at) return false;
    const Point2 at = *edit.rooms.front().at;
    return std::any_of(room.parts.begin(), room.parts.end(),
                       [&](const Polygon& part) { return contains(part, at); });
  });
  if (name != std::to_string(room.id)) {
    Edit edit;
    edit.rooms = {anchor_of(room)};
    edit.name = name;
    edits.push_back(edit);
  }
  return edits.empty() ? "" : edits_json(edits);
}

}  // namespace

void rename(const Settings& settings, const Path& store_file, const std::string& room,
            const std::string& name) {
  check_name(name);
  const PlaceLock lock = lock_store(store_file);
  auto store = std::make_unique<GeoPackageStore>(store_file, GeoPackageStore::Mode::read);
  const FloorPlan plan = store->plan();
  const std::vector<Edit> edits = stored_edits(*store);
  store.reset();  // nobody may have it open while it is written
  const PlanRoom& chosen = find_room(store_file, plan, room);
  require_unused(store_file, plan, chosen, name);
  rename_room(store_file, chosen.id, name, with_name(edits, chosen, name));
  GeoPackageStore(store_file, GeoPackageStore::Mode::update).finish();
  if (settings.json) tell_renamed(store_file, chosen, name);
  spdlog::info("room {}: \"{}\" is now \"{}\"; `roomatlas export` draws it so", chosen.id,
               chosen.name, name);
}

}  // namespace roomatlas::apps
