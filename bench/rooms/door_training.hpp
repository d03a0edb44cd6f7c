// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelled_map.hpp"
#include "partition/cut_building.hpp"
#include "partition/region_graph.hpp"

namespace roomatlas::bench {

/// A map in pieces, and what each piece truly is.
struct TrainingMap {
  RegionGraph graph;
  FloorPieces pieces;
  std::vector<std::vector<double>> cells_of_room;  ///< by piece, by true room
};
[[nodiscard]] TrainingMap training_map(const LabelledMap& map, const CutBuilding& cut);

/// One question that a partition asks, and its answer.
struct DoorSample {
  DoorFigures figures{};
  bool is_door = false;  ///< the two regions lie mostly in different true rooms
  double weight = 1.0;   ///< root of the smaller area, m2, at most 20 m2
};

/// The questions on the way from pieces to true rooms: pairs are taken in the order of a model and
/// joined where that is right; after each join all around is asked again.
[[nodiscard]] std::vector<DoorSample> samples_on_the_way(const TrainingMap& map,
                                                         const DoorWeights& order);

/// Logistic regression by Newton's method, with squared weights (of figures scaled to unit
/// variance) as penalty times `penalty`; samples' weights are scaled to mean 1.
[[nodiscard]] DoorWeights fit_doors(const std::vector<DoorSample>& samples, double penalty);

/// Fitted twice: to samples in the order of the openings' relative widths, then also to those that
/// the first fit meets.
[[nodiscard]] DoorWeights train_doors(const std::vector<const TrainingMap*>& maps, double penalty);

}  // namespace roomatlas::bench
