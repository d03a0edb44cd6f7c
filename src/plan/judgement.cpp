// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/judgement.hpp"

namespace roomatlas {

const char* to_string(AdviceKind kind) {
  switch (kind) {
    case AdviceKind::cross_again:
      return "cross_again";
    case AdviceKind::drive_again:
      return "drive_again";
    case AdviceKind::use_door:
      return "use_door";
  }
  return "unknown";
}

std::string words(const Advice& advice) {
  const std::string from = std::to_string(advice.from_room);
  const std::string to = std::to_string(advice.to_room);
  if (advice.kind == AdviceKind::use_door) {
    return "drive through the door between rooms " + from + " and " + to +
           ", which has not been used";
  }
  if (advice.from_room == advice.to_room) return "drive once more through room " + from;
  if (advice.kind == AdviceKind::drive_again) {
    return "drive once more from room " + from + " to room " + to;
  }
  return std::string("drive once more through the ") + (advice.by_door ? "door" : "passage") +
         " between rooms " + from + " and " + to;
}

}  // namespace roomatlas
