// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/doorway.hpp"
#include "roomatlas/grid/cells.hpp"

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace roomatlas {

/// The explorer's graph: spaces as vertices, doorways as edges. A space's number is its place in
/// the order in which it was entered.
class ExplorerRooms {
 public:
  using Room = std::size_t;
  using Door = std::size_t;

  struct KnownDoor {
    Doorway doorway;
    std::optional<Room> behind;  ///< the room on the side from which the pivot points away
    std::optional<Room> ahead;
    int failures = 0;  ///< ways through it that came to nothing
  };

  explicit ExplorerRooms(const CellFrame& frame) : frame_(frame), anchors_(1) {}

  [[nodiscard]] Room current() const { return current_; }
  [[nodiscard]] std::size_t count() const { return anchors_.size(); }
  [[nodiscard]] const std::vector<KnownDoor>& doors() const { return doors_; }

  /// Adds a doorway of the current room, seen from `viewer`; false when it was known.
  bool add(const Doorway& doorway, const Point2& viewer);
  void note_failure(Door door) { ++doors_[door].failures; }
  void forget_failures() {
    for (KnownDoor& door : doors_) door.failures = 0;
  }

  /// The door in whose zone the robot stands: there it is in no room.
  [[nodiscard]] std::optional<Door> door_at(const Point2& point) const;

  /// Whether a cell lies on a door's line; that of `open` does not count.
  [[nodiscard]] bool is_closed(const Cell& cell, std::optional<Door> open) const;

  /// Whether the current room is on one side of the door.
  [[nodiscard]] bool is_here(Door door) const {
    return doors_[door].ahead == current_ || doors_[door].behind == current_;
  }

  /// Signed distance beyond a door's line: positive on the side away from the current room.
  [[nodiscard]] double beyond_m(Door door, const Point2& point) const;

  /// The robot has left the zone of a door: the side where it stands becomes the current room.
  /// @param find_known the room that can be reached from here without passing a door
  template <typename FindKnown>
  void leave(Door door, const Point2& position, FindKnown find_known);

  /// Remembers that the robot stood here, to know the room again.
  void anchor(const Point2& position) { anchors_[current_].push_back(position); }
  [[nodiscard]] const std::vector<std::vector<Point2>>& anchors() const { return anchors_; }

  /// Doors of the current room behind which nobody has been.
  [[nodiscard]] std::vector<Door> untaken() const;

  /// The first door on the shortest way through the graph to a room with untaken doors.
  [[nodiscard]] std::optional<Door> way_back() const;

 private:
  [[nodiscard]] bool is_untaken(const KnownDoor& door) const;

  CellFrame frame_;
  Room current_ = 0;
  std::vector<KnownDoor> doors_;
  std::unordered_map<std::int64_t, Door> closed_;
  std::vector<std::vector<Point2>> anchors_;  ///< one list a room
};

template <typename FindKnown>
void ExplorerRooms::leave(Door door, const Point2& position, FindKnown find_known) {
  KnownDoor& left = doors_[door];
  const Point2 from_pivot = inverse(left.doorway.frame_from_pivot) * position;
  std::optional<Room>& side = from_pivot.x() > 0.0 ? left.ahead : left.behind;
  if (!side) {
    side = find_known();
    if (!side) {
      side = anchors_.size();
      anchors_.emplace_back();
    }
  }
  current_ = *side;
}

}  // namespace roomatlas
