// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

#include "roomatlas/match/align.hpp"

namespace roomatlas {

struct MatchMapsOptions {
  AlignOptions align{.max_iterations = 20};
  double min_face_hits = 2.0;  ///< a face hit once may be anything
  int searched_points = 300;   ///< of the second map in the coarse search
  int aligned_points = 1500;   ///< and in the fine one
  double agree_m = 0.13;       ///< a point this near to a face that looks its way agrees
  double point_sigma_m = 0.03;
  double points_per_sample = 20.0;  ///< neighbouring points err alike: so many count as one
  double floor_position_m = 0.02;   ///< no match is better than this ...
  double floor_heading_deg = 0.15;  ///< ... nor its heading
};

/// How far around the guess a match is looked for.
struct SearchWindow {
  double reach_m = 0.0;
  double reach_rad = 0.0;
};

struct MapMatch {
  Pose2 first_from_second;
  int agreeing = 0;       ///< points of the second map on a face of the first
  int contradicting = 0;  ///< points of the second map where the first saw free space
  int unseen = 0;         ///< points of the second map where the first knows nothing
  /// Inverse covariance of x, y, theta in the frame of the second.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  /// Of the points that can tell, the share that agrees, [0, 1]; 0 where none can tell.
  [[nodiscard]] double agreement() const {
    const int telling = agreeing + contradicting;
    return telling > 0 ? static_cast<double>(agreeing) / telling : 0.0;
  }
};

/// A map that others are looked for in. Made once for many searches.
class SearchableMap {
 public:
  SearchableMap(const LocalMap& map, const MatchMapsOptions& options);

  /// Where the points fit best: coarsely over the whole window (branch and bound over maxima of
  /// ever larger squares, after Olson 2009 and Hess et al. 2016), then finely, then judged.
  /// @param points of the second map, in its frame, see `points_of`
  [[nodiscard]] MapMatch find(const std::vector<ScanPoint>& points, const Pose2& guess,
                              const SearchWindow& window) const;

 private:
  static constexpr int kLevels = 4;

  [[nodiscard]] Pose2 search(const std::vector<ScanPoint>& points, const Pose2& guess,
                             const SearchWindow& window) const;
  void judge(const std::vector<ScanPoint>& points, MapMatch& match) const;
  [[nodiscard]] double score(int level, const std::vector<Cell>& cells, const Cell& shift) const;

  const LocalMap& map_;
  MatchMapsOptions options_;
  CellBox box_;
  /// Level l holds for each cell the highest value of the 2^l x 2^l cells from it on.
  std::vector<std::vector<std::int8_t>> levels_;
};

/// The faces of a map as points to be matched.
[[nodiscard]] std::vector<ScanPoint> points_of(const LocalMap& map,
                                               const MatchMapsOptions& options);

}  // namespace roomatlas
