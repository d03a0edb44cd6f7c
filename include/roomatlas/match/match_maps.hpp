// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

#include "roomatlas/match/align.hpp"

namespace roomatlas {

struct MatchMapsOptions {
  AlignOptions align{.max_iterations = 20};  ///< from a whole cell and a degree off: more steps
  double min_face_hits = 2.0;                ///< a face hit once may be anything
  int searched_points = 300;                 ///< of the second map in the coarse search
  int aligned_points = 1500;                 ///< and in the fine one
  double agree_m = 0.13;            ///< a point this near to a face that looks its way agrees
  double point_sigma_m = 0.03;      ///< of a sample; larger lets passages overrule closures
  double points_per_sample = 20.0;  ///< neighbouring points err alike: so many count as one
  double floor_position_m = 0.02;   ///< no match is better than this ...
  double floor_heading_deg = 0.15;  ///< ... nor its heading
};

/// How far around the guess a match is looked for.
struct SearchWindow {
  double reach_m = 0.0;    ///< to each side; time grows with its square
  double reach_rad = 0.0;  ///< and each way; time grows with it
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
  static constexpr int kLevels = 4;  ///< squares of 1 to 8 cells; the margin in the source is as
                                     ///< wide. More skip wide windows faster, and cost memory

  /// A square of shifts, by its lowest corner. None of them scores more.
  struct Candidate {
    double score = 0.0;
    Cell shift;
  };
  struct Turned {
    Pose2 pose;
    double by_rad = 0.0;  ///< off the guess
  };
  struct Best {
    Pose2 pose;
    double score = 0.0;
  };

  [[nodiscard]] Pose2 search(const std::vector<ScanPoint>& points, const Pose2& guess,
                             const SearchWindow& window) const;
  /// Branch and bound over the shifts of points turned alike, for one better than `best`.
  void search_shifts(const std::vector<Cell>& cells, const Turned& turned,
                     const SearchWindow& window, Best& best) const;
  /// Adds a level's squares inside a box of shifts, and sorts: the best to the back.
  void add_squares(int level, const CellBox& shifts, const std::vector<Cell>& cells,
                   std::vector<Candidate>& stack) const;
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
