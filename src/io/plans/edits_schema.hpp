// SPDX-License-Identifier: GPL-3.0-or-later
// The words of edits.json, for reading and writing. Private.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "roomatlas/edit/edit.hpp"

namespace roomatlas::edits_schema {

inline constexpr const char* kFormat = "roomatlas-edits";
inline constexpr int kVersion = 1;

/// A kind of statement and the fields that it has beside "edit".
struct Statement {
  EditKind kind;
  std::vector<std::string> fields;
};

[[nodiscard]] inline const std::vector<Statement>& statements() {
  static const std::vector<Statement> all = {
      {EditKind::name_room, {"room", "name"}},
      {EditKind::set_room_kind, {"room", "kind"}},
      {EditKind::join_rooms, {"rooms"}},
      {EditKind::split_room, {"room", "line_m", "thickness_m"}},
      {EditKind::shut_door, {"at_m"}},
      {EditKind::open_door, {"at_m"}},
      {EditKind::add_door, {"jambs_m"}},
      {EditKind::move_wall, {"wall_m", "by_m"}},
      {EditKind::furniture_to_wall, {"at_m"}},
      {EditKind::wall_to_furniture, {"at_m", "outline_m"}},
      {EditKind::reject_closure, {"from_time_s", "to_time_s"}},
      {EditKind::pin_visits, {"from_time_s", "to_time_s", "from_from_to"}},
  };
  return all;
}

/// The field that holds the line of a kind; empty where it has none.
[[nodiscard]] inline std::string line_field(EditKind kind) {
  if (kind == EditKind::split_room) return "line_m";
  if (kind == EditKind::add_door) return "jambs_m";
  return kind == EditKind::move_wall ? "wall_m" : "";
}

}  // namespace roomatlas::edits_schema
