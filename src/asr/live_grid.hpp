// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <optional>
#include <utility>
#include <vector>

#include "roomatlas/asr/map_room.hpp"

namespace roomatlas {

/// The grid of the room that is being mapped, as seen so far and not yet cut at doors. Sweeps are
/// drawn when it is looked at.
class LiveGrid {
 public:
  LiveGrid(const RoomMapOptions& options, const RobotFootprint& footprint)
      : options_(options), footprint_(footprint), grid_(options.cell_m) {}

  /// Forgets the room.
  void clear();
  /// Takes a sweep, if the robot has moved since the last.
  void add(const RangeReading& reading, const Pose2& asr_from_robot);
  /// Begins to draw, in a thread of its own, what was taken since `clear`.
  void begin();
  [[nodiscard]] const HimmGrid& grid();

 private:
  using Sweeps = std::vector<std::pair<RangeReading, Pose2>>;  ///< with the room's pose of each

  void draw(const Sweeps& sweeps, HimmGrid& grid) const;

  const RoomMapOptions& options_;
  const RobotFootprint& footprint_;
  HimmGrid grid_;
  Sweeps undrawn_;  ///< not in `grid_` yet
  std::optional<Pose2> last_added_;
  std::future<HimmGrid> begun_;  ///< what `grid_` begins with, while it is drawn
};

}  // namespace roomatlas
