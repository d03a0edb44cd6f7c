// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/place_index.hpp"
#include "roomatlas/evaluate/self_consistency.hpp"

#include <vector>

namespace roomatlas {

/// One ASR's evidence, placed.
struct PlacedEvidence {
  const AsrEvidence* evidence = nullptr;
  Pose2 building_from_asr;
  RoomId room = 0;  ///< negative for a room of its own
  Box2 seen;        ///< of its rays, in building metres
  Box2 solid;       ///< of its walls and surfaces
};
using PlacedAll = std::vector<PlacedEvidence>;

[[nodiscard]] bool near(const Box2& a, const Box2& b, double reach_m);

/// Finds ASRs by one of their boxes, without asking all of the building.
class NearAsrs {
 public:
  NearAsrs(const PlacedAll& all, Box2 PlacedEvidence::*box, double reach_m);

  /// Those whose box comes near another, in the order of all.
  [[nodiscard]] std::vector<const PlacedEvidence*> near(const Box2& other) const;

 private:
  const PlacedAll& all_;
  Box2 PlacedEvidence::*box_;
  double reach_m_;
  PlaceIndex index_;
};

// One function a figure; see ConsistencyFigure for what each means.
[[nodiscard]] ConsistencyValue room_overlap(const PlacedAll& all,
                                            const ConsistencyOptions& options);
[[nodiscard]] ConsistencyValue negative_walls(const PlacedAll& all,
                                              const ConsistencyOptions& options);
[[nodiscard]] ConsistencyValue door_sides(const PlacedAll& all);
[[nodiscard]] ConsistencyValue doors_again(const PlacedAll& all, const ConsistencyOptions& options);
[[nodiscard]] ConsistencyValue corridor_bend(const PlacedAll& all);
[[nodiscard]] ConsistencyValue rays_through_walls(const PlacedAll& all,
                                                  const ConsistencyOptions& options);

/// What the others say of each visit's hits.
[[nodiscard]] std::vector<VisitAgreement> judge_visits(const PlacedAll& all,
                                                       const ConsistencyOptions& options);

/// Two figures from one look at all hits.
struct HitFigures {
  ConsistencyValue in_free_space;
  ConsistencyValue doubled_walls;
};
[[nodiscard]] HitFigures judge_hits(const PlacedAll& all, const ConsistencyOptions& options);

}  // namespace roomatlas
