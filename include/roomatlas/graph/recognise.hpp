// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/graph/room_graph.hpp"

namespace roomatlas {

struct RecogniseOptions {
  double gate_m = 0.4;         ///< two doorways this near are the same, however short the path
  double gate_growth = 0.02;   ///< metres added to the gate a metre of path driven between them
  double max_gate_m = 1.5;     ///< doors of one wall are seldom nearer than this
  double max_turn_deg = 35.0;  ///< directions of one doorway agree this well
  double max_width_difference_m = 0.45;  ///< between crossings of one: jambs are seen anew
};

/// Doorways that the robot went through more than once: for each crossing, the nearest earlier
/// crossing of the same place, width and direction (or the opposite one). The edges join the two
/// ASRs that begin there; they are not yet in the graph.
/// Crossings are compared where `placement` puts them; each later crossing is matched to at most
/// one earlier one. Not guaranteed: a door that was placed wrongly by more than the gate is missed.
[[nodiscard]] std::vector<PassageEdge> recognise_doorways(const std::vector<Asr>& asrs,
                                                          const Placement& placement,
                                                          const RecogniseOptions& options);

}  // namespace roomatlas
