// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cell_grid.hpp"
#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::io {

/// Gives free cells without a label that of the nearest labelled cell, at most `most_steps` away
/// from cell to cell. Of two as near the lower label wins.
/// @param labels 0 where there is none
/// @param free 1 where a label may spread to
[[nodiscard]] CellGrid<int> spread_labels(const CellGrid<int>& labels, const CellGrid<char>& free,
                                          int most_steps);

/// An unbroken line on which two labels touch, side to side.
struct LabelContact {
  int first = 0;  ///< the lower label
  int second = 0;
  Segment2 ends;  ///< in cells; the two points of the line that are farthest apart
};

/// All of them, by labels, then from the lowest up.
[[nodiscard]] std::vector<LabelContact> label_contacts(const CellGrid<int>& labels);

}  // namespace roomatlas::io
