// SPDX-License-Identifier: GPL-3.0-or-later
#include "former_store.hpp"

#include <algorithm>
#include <set>

#include "roomatlas/io/plans/edits_file.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/merge/carry_over.hpp"
#include "store_edits.hpp"
#include "usable_store.hpp"

namespace roomatlas::apps {
namespace {

/// Rooms with their numbers; those that nobody named get the names of rooms of another plan in the
/// same frame.
std::vector<PlanRoom> with_names_of(std::vector<PlanRoom> rooms,
                                    const std::vector<PlanRoom>& others) {
  FloorPlan plan;
  plan.rooms = std::move(rooms);
  std::map<AsrId, RoomId> no_visits;
  std::map<RoomId, RoomId> number_of;
  for (const auto& [was, is] : carry_over(others, plan, no_visits).number) number_of[is] = was;
  renumber(plan, number_of);
  return plan.rooms;
}

}  // namespace

Former former_in(const std::filesystem::path& store_file, const std::string& building) {
  const auto former = read_if_possible(store_file, [&](const GeoPackageStore& store) {
    const Metadata metadata = store.metadata();
    Former said;
    if (!may_be_of(metadata, building)) return said;
    said.rooms = store.former_rooms();
    if (const auto edits = metadata.find(kEditsKey); edits != metadata.end()) {
      said.edits.insert(*edits);
    }
    return said;
  });
  return former.value_or(Former{});
}

std::string named_building_in(const std::filesystem::path& store_file) {
  const auto building = read_if_possible(store_file, [](const GeoPackageStore& store) {
    const Metadata metadata = store.metadata();
    const std::vector<PlanRoom> rooms = store.former_rooms();
    const bool is_said =
        metadata.contains(kEditsKey) || std::any_of(rooms.begin(), rooms.end(), is_named);
    return is_said ? building_of(metadata) : std::string();
  });
  return building.value_or("");
}

void put_said(const Former& former, const GeoPackageStore& base, GeoPackageStore& store) {
  const std::vector<PlanRoom> of_base = base.former_rooms();  // also names that wait for a room
  store.put_former_rooms(former.rooms.empty() ? of_base : with_names_of(former.rooms, of_base));
  store.put_metadata(former.edits);
  const std::vector<Edit> said = former.edits.empty() ? std::vector<Edit>() : stored_edits(store);
  std::set<std::string> known;
  for (const Edit& edit : said) known.insert(edits_json({edit}));
  std::vector<Edit> edits = stored_edits(base);
  std::erase_if(edits, [&](const Edit& edit) { return known.contains(edits_json({edit})); });
  edits.insert(edits.end(), said.begin(), said.end());
  keep_edits(edits, store);
}

void require_known_version(const Settings& settings, const std::filesystem::path& store) {
  if (settings.force || !std::filesystem::exists(store)) return;
  try {
    const GeoPackageStore known(store, GeoPackageStore::Mode::read);
  } catch (const OtherVersion& error) {
    throw OtherVersion(std::string(error.what()) +
                       ". With --force it is replaced and stays beside the new one, which has not "
                       "its names of rooms and corrections by hand; or give another name with -o");
  } catch (const InputError&) {  // whoever replaces it keeps one that cannot be read
  }
}

}  // namespace roomatlas::apps
