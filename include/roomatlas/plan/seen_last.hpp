// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/change.hpp"

namespace roomatlas {

/// Something that is drawn as a later mission saw it, and not as the missions before it did.
struct ThingSeenLast {
  ChangeKind kind = ChangeKind::furniture_gone;
  Point2 at = Point2::Zero();  ///< building metres, see `Change::at`
  double size_m = 0.0;         ///< the longer side
};

/// What changed between a mission and all that are older than it.
struct SeenLast {
  std::string mission;  ///< name of its log; of several at one time "a.clf, b.clf"
  std::vector<ThingSeenLast> things;
};

/// "3 things are drawn as b.clf saw them last (1 door shut, 2 pieces of furniture gone)". Without a
/// full stop.
[[nodiscard]] std::string words(const SeenLast& seen);

}  // namespace roomatlas
