// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

namespace roomatlas {

/// What one cell costs by label. Label 0 is solid; others are rooms.
struct LabelCosts {
  double solid = 0.0;
  double other = 0.0;           ///< of a room that is not in `rooms`
  std::map<int, double> rooms;  ///< labels that have a cost of their own
  [[nodiscard]] double of(int label) const {
    if (label == 0) return solid;
    const auto own = rooms.find(label);
    return own == rooms.end() ? other : own->second;
  }
};

/// A border between two cells and what it costs where they differ.
struct LabelBorder {
  int first = 0;
  int second = 0;
  double solid_cost = 0.0;  ///< one of them is solid
  double room_cost = 0.0;   ///< both are rooms; counts as at most twice `solid_cost`
};

/// A labelling of little cost, by alpha expansion (Boykov, Veksler and Zabih, "Fast approximate
/// energy minimization via graph cuts", PAMI 2001) from the cheapest label of each cell; each move
/// is the best possible one, by Boost.Graph's maximum flow (Boykov and Kolmogorov, PAMI 2004).
/// @param labels how many, solid included
/// @param most_sweeps over all labels
[[nodiscard]] std::vector<int> label_cells(const std::vector<LabelCosts>& cells,
                                           const std::vector<LabelBorder>& borders, int labels,
                                           int most_sweeps);

/// What a labelling costs.
[[nodiscard]] double labelling_cost(const std::vector<LabelCosts>& cells,
                                    const std::vector<LabelBorder>& borders,
                                    const std::vector<int>& label_of_cell);

}  // namespace roomatlas
