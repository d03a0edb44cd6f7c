// SPDX-License-Identifier: GPL-3.0-or-later
// The room graph while loops are closed: poses always up to date, closures come and go.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "roomatlas/asr/asr.hpp"
#include "roomatlas/match/match_maps.hpp"
#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {

/// Two ASRs that may have seen the same walls.
struct Pair {
  std::size_t first = 0;
  std::size_t second = 0;
  double apart_m = 0.0;  ///< between their paths
};

/// How uncertain the pose of one ASR in the frame of another is.
struct Uncertainty {
  double position_m = 0.0;
  double heading_rad = 0.0;
};

class PlacedGraph {
 public:
  /// @param robust_sigmas closures off by more lose weight (Cauchy)
  explicit PlacedGraph(double robust_sigmas) : robust_sigmas_(robust_sigmas) {}

  void add_node(AsrId id, const Pose2& pose);
  void add_driven(std::size_t from, std::size_t to, const Pose2& from_from_to,
                  const Eigen::Matrix3d& information);
  void add(const Pair& pair, const MapMatch& match) { add(pair, match, robust_sigmas_); }
  /// A match that is to be believed, however much it moves.
  void add_believed(const Pair& pair, const MapMatch& match) { add(pair, match, 0.0); }
  void remove_closures();

  /// From now on passages that are off by more may give way.
  void doubt_passages(double robust_sigmas);
  /// Believes all passages again but those that are off, and tells into which nodes these lead.
  std::set<AsrId> keep_doubts();

  void solve();
  /// Solves, and tells how uncertain each pair is.
  [[nodiscard]] std::vector<Uncertainty> uncertainties(const std::vector<Pair>& pairs);
  [[nodiscard]] Pose2 first_from_second(const Pair& pair) const;
  [[nodiscard]] const Pose2& pose(std::size_t i) const { return graph_.guess[i]; }

 private:
  void add(const Pair& pair, const MapMatch& match, double robust_sigmas);

  double robust_sigmas_;
  PoseGraph graph_;
};

}  // namespace roomatlas
