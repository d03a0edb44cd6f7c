// SPDX-License-Identifier: GPL-3.0-or-later
// Which visits come near to which, by their paths.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "roomatlas/grid/cells.hpp"
#include "roomatlas/loops/closures.hpp"

namespace roomatlas {

/// Visits by the places where the robot was, so that those near to a path are found without
/// looking at all.
class VisitsNear {
 public:
  explicit VisitsNear(double near_m) : frame_{near_m} {}

  void add(const AsrShape& shape, const Pose2& building_from_asr) {
    for (const Point2& at : shape.path) {
      const Cell cell = frame_.cell_of(building_from_asr * at);
      visits_[{cell.y, cell.x}].insert(shape.id);
    }
  }

  /// At most twice the distance away, ascending.
  [[nodiscard]] std::set<AsrId> near(const AsrShape& shape, const Pose2& building_from_asr) const {
    std::set<AsrId> found;
    for (const Point2& at : shape.path) {
      const Cell middle = frame_.cell_of(building_from_asr * at);
      for_each_cell({{middle.x - 1, middle.y - 1}, {middle.x + 2, middle.y + 2}},
                    [&](const Cell& cell) {
                      const auto there = visits_.find({cell.y, cell.x});
                      if (there == visits_.end()) return;
                      found.insert(there->second.begin(), there->second.end());
                    });
    }
    return found;
  }

 private:
  CellFrame frame_;
  std::map<std::pair<int, int>, std::set<AsrId>> visits_;
};

}  // namespace roomatlas
