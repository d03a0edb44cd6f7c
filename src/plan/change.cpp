// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/change.hpp"

namespace roomatlas {

const char* to_string(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::door_shut:
      return "door shut";
    case ChangeKind::door_opened:
      return "door opened";
    case ChangeKind::door_turned:
      return "door leaf turned";
    case ChangeKind::furniture_gone:
      return "furniture gone";
    case ChangeKind::furniture_new:
      return "furniture new";
    case ChangeKind::furniture_moved:
      return "furniture moved";
    case ChangeKind::wall_gone:
      return "wall gone";
    case ChangeKind::wall_new:
      return "wall new";
    case ChangeKind::wall_moved:
      break;
  }
  return "wall moved";
}

}  // namespace roomatlas
