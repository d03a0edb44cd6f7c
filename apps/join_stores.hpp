// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "commands.hpp"
#include "roomatlas/pipeline/assemble_joined.hpp"

namespace roomatlas::apps {

/// A building that was written, or a mission that stands alone and has its own store already.
struct WrittenBuilding {
  JoinedBuilding building;
  Path store;
  std::size_t rooms = 0;
};

/// Joins the missions of several assembled stores and writes a store for each building of two and
/// more: the largest at `place`, others beside it as NAME.2.gpkg and so on. Says which mission was
/// joined and why others were not.
/// @throws InputError for a store that is not assembled, NotEnoughError where nothing holds any two
///   of them together
[[nodiscard]] std::vector<WrittenBuilding> join_into(const Settings& settings,
                                                     const std::vector<Path>& stores,
                                                     const Path& place);

}  // namespace roomatlas::apps
