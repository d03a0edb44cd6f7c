// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <boost/pending/disjoint_sets.hpp>

#include "roomatlas/core/place_index.hpp"
#include "roomatlas/rooms/openings.hpp"

namespace roomatlas {

/// Which openings a straight line crosses.
class OpeningsCrossed {
 public:
  explicit OpeningsCrossed(const std::vector<Doorway>& openings);
  [[nodiscard]] std::vector<std::size_t> between(const Point2& from, const Point2& to) const;

 private:
  std::vector<Segment2> lines_;
  PlaceIndex index_;
};

/// The path as places, and which of them belong together: those that were driven to from each
/// other, and those that see each other or one and the same spot.
class PathPlaces {
 public:
  /// @param grid has to outlive this
  PathPlaces(const BuildingGrid& grid, const std::vector<Pose2>& path,
             const std::vector<Doorway>& openings, double see_m);

  /// A number for the set of each place, while some openings are closed.
  /// @param joined places that belong together whatever is closed
  [[nodiscard]] std::vector<std::size_t> sets(
      const std::vector<bool>& is_closed,
      const std::vector<std::pair<std::size_t, std::size_t>>& joined) const;
  /// The place of each pose.
  [[nodiscard]] const std::vector<std::size_t>& of_poses() const { return place_of_pose_; }
  /// The places before and behind an opening, each time that the robot drove through it.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> drives_through(
      std::size_t opening) const;

 private:
  using Sets = boost::disjoint_sets_with_storage<>;
  /// Two places that belong together unless one of these openings parts them.
  struct Link {
    std::size_t a = 0;
    std::size_t b = 0;
    std::vector<std::size_t> crossed;
  };

  void take_places(const std::vector<Pose2>& path);
  void link_driven(const std::vector<Pose2>& path);
  void link_seen(double see_m);
  void link_seen(const std::vector<std::size_t>& among, double see_m, Sets& known);
  void link_by_common_sight(const std::vector<std::size_t>& places, Sets& known);
  [[nodiscard]] bool can_see(const Point2& from, const Point2& to) const;

  const BuildingGrid& grid_;
  const OpeningsCrossed openings_;
  std::vector<Point2> points_;
  std::vector<std::size_t> place_of_pose_;
  std::vector<Link> links_;
  std::ptrdiff_t driven_links_ = 0;  ///< of `links_`, the first so many
};

}  // namespace roomatlas
