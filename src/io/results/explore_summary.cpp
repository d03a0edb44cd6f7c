// SPDX-License-Identifier: GPL-3.0-or-later

#include "roomatlas/io/results/summary.hpp"
#include "text/json.hpp"

namespace roomatlas {

std::string to_json(const ExploreSummary& summary, const FloorPlan& world) {
  std::vector<RoomId> missed;
  for (const PlanRoom& room : world.rooms) {
    if (!summary.entered.contains(room.id)) missed.push_back(room.id);
  }
  const nlohmann::ordered_json json = {{"finished", summary.finished},
                                       {"duration_s", summary.duration_s},
                                       {"path_length_m", summary.path_length_m},
                                       {"collisions", summary.collisions},
                                       {"rooms", world.rooms.size()},
                                       {"entered", summary.entered.size()},
                                       {"not_entered", missed},
                                       {"spaces_found", summary.rooms_found},
                                       {"doorways_found", summary.doorways_found},
                                       {"goals_given_up", summary.goals_given_up}};
  return json.dump(2);
}

}  // namespace roomatlas
