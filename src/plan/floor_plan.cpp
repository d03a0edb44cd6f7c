// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

const char* to_string(RoomKind kind) {
  switch (kind) {
    case RoomKind::corridor:
      return "corridor";
    case RoomKind::hall:
      return "hall";
    case RoomKind::room:
      break;
  }
  return "room";
}

}  // namespace roomatlas
