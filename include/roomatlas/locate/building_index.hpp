// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "roomatlas/locate/seen_building.hpp"
#include "roomatlas/match/align.hpp"

namespace roomatlas {

struct LocateOptions {
  AlignOptions align{.first_gate_m = 0.5, .last_gate_m = 0.2, .max_iterations = 20};
  double agree_m = 0.15;  ///< a wall this near to one of the building that looks its way agrees;
                          ///< sonars' walls lie that far off
  double wall_sigma_m = 0.04;      ///< how far one map's walls lie off the other's, one deviation
  double max_query_m = 30.0;       ///< so much around the middle of a query's path is looked for
  int candidates = 120;            ///< of the coarse search that are looked at finely
  double apart_m = 0.8;            ///< places nearer to each other than this ...
  double apart_deg = 6.0;          ///< ... and turned less are one
  double agree_weight = 2.1;       ///< log of how much oftener walls agree at the right place ...
  double contradict_weight = 1.8;  ///< ... and how much more seldom they stand on free floor
  double samples_alike = 10.0;     ///< neighbouring points err alike: so many count as one
};

/// A place where a query may have been seen.
struct PlaceHypothesis {
  Pose2 building_from_query;
  int agreeing = 0;       ///< of the query's wall points, on a wall of the building
  int contradicting = 0;  ///< on its floor
  int unseen = 0;         ///< where the building knows nothing
  int missing = 0;        ///< of the query's floor cells, with a wall of the building
  double score = 0.0;     ///< log likelihood against a place taken at random

  /// Of what can tell, the share that agrees, [0, 1].
  [[nodiscard]] double agreement() const {
    const int telling = agreeing + contradicting + missing;
    return telling > 0 ? static_cast<double>(agreeing) / telling : 0.0;
  }
};

class CorrelationPlane;

/// A building in which queries are looked for from nothing. Made once for many queries.
class BuildingIndex {
 public:
  BuildingIndex(const FloorSketch& building_sketch, const LocateOptions& options);
  ~BuildingIndex();
  BuildingIndex(const BuildingIndex&) = delete;
  BuildingIndex& operator=(const BuildingIndex&) = delete;

  /// Takes in what another mission saw, in the building's frame.
  void add(const FloorSketch& sketch);

  [[nodiscard]] const SeenBuilding& seen() const { return seen_; }

  /// Where the query may lie, the likeliest first, none near to a likelier one: coarsely, over all
  /// shifts and the headings that the walls' directions leave open, then finely.
  /// @param jobs threads at once, see `for_each_index`
  [[nodiscard]] std::vector<PlaceHypothesis> find(const FloorSketch& query, int jobs = 1) const;

  /// How well a query fits at a place, as it is.
  [[nodiscard]] PlaceHypothesis at(const FloorSketch& query, const Pose2& place) const;
  /// The share of a query's path that runs over the building's floor, [0, 1].
  [[nodiscard]] double share_on_floor(const FloorSketch& query, const Pose2& place) const;
  /// How well a query fits near a place: aligned, and judged.
  [[nodiscard]] PlaceHypothesis fit(const FloorSketch& query, const Pose2& guess) const;

 private:
  struct Coarse {
    Pose2 pose;
    float score = 0.0F;
  };
  [[nodiscard]] std::vector<Coarse> search(const FloorSketch& query, double heading_rad) const;
  void judge(const FloorSketch& query, PlaceHypothesis& place) const;

  LocateOptions options_;
  std::vector<double> directions_;  ///< of the walls, see `direction_histogram`
  SeenBuilding seen_;
  std::unique_ptr<CorrelationPlane> plane_;  ///< of both; made anew whenever something is added
};

}  // namespace roomatlas
