// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "changes/alter_world.hpp"

namespace roomatlas::bench {

/// What became of alterations and of what was told.
struct ChangeScore {
  int altered = 0;   ///< in rooms that both missions entered
  int found = 0;     ///< of these, told where they are as a door's, a piece's or a wall's
  int named = 0;     ///< of these, by the very word
  int invented = 0;  ///< told where nothing was altered, or a second time
  std::vector<std::string> remarks;  ///< what was missed, misnamed or invented

  [[nodiscard]] double precision() const;
  [[nodiscard]] double recall() const;
  [[nodiscard]] double f1() const;
  void add(const ChangeScore& other);
};

/// @param seen rooms that both missions entered; alterations elsewhere count neither way
[[nodiscard]] ChangeScore scored(const std::vector<Alteration>& alterations,
                                 const std::set<RoomId>& seen, const std::vector<Change>& changes,
                                 const Pose2& world_from_old);

}  // namespace roomatlas::bench
