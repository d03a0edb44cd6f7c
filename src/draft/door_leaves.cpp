// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/door_leaves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kLeafStep_m = 0.05;    // along a leaf, and between hinges that are tried
constexpr double kTurn_rad = kPi / 72;  // between directions that are tried
constexpr int kMostGaps = 2;            // steps in a leaf where nothing was seen
constexpr double kBeside_m = 0.15;      // off a leaf, its sides are looked at
constexpr double kFromHinge_m = 0.25;   // nearer to the hinge the wall is beside it
constexpr double kRound_m = 0.17;       // off the free end all is floor, in these directions
constexpr std::array kRound_rad = {-1.2, -0.6, 0.0, 0.6, 1.2};  // of a leaf's direction
constexpr double kOwn_m = 0.09;      // surfaces this near a leaf are its own ...
constexpr double kOwnSine = 0.5;     // ... when they look its way
constexpr double kCut_m = 0.02;      // between places on a face that are asked
constexpr double kWall_m = 0.08;     // of its length that is the wall's
constexpr double kSame_m = 0.3;      // leaves whose middles are nearer are one
constexpr double kSameGap_m = 0.45;  // from a gap's middle to the door in it

/// A leaf that may be, and how well it agrees with what was seen.
struct Candidate {
  Segment2 line;
  double score = 0.0;
};

class Finder {
 public:
  Finder(const Occupancy& occupancy, const LeafOptions& options)
      : occupancy_(occupancy), options_(options), near_obstacle_(dilated(occupancy.obstacle, 1)) {}

  [[nodiscard]] std::optional<Candidate> at(const Segment2& gap) const {
    std::optional<Candidate> best;
    const double cell_m = occupancy_.frame.cell_m;
    const double width_m = (gap.b - gap.a).norm() + 2.0 * cell_m;  // a gap ends before its jambs
    if (width_m < options_.narrowest_m || width_m > options_.widest_m) return best;
    for (const Segment2& way : {gap, Segment2{gap.b, gap.a}}) {
      const Point2 shut = (way.b - way.a).normalized();
      for (const double side : {-1.0, 1.0}) {
        const Point2 out = side * Point2(-shut.y(), shut.x());
        for_each_hinge(way.a, shut, out, [&](const Point2& hinge) {
          for (double turn_rad = radians(options_.least_turn_deg);
               turn_rad <= radians(options_.most_turn_deg); turn_rad += kTurn_rad) {
            const Point2 along = std::cos(turn_rad) * shut + std::sin(turn_rad) * out;
            const auto one = leaf(hinge, along, width_m);
            if (one && (!best || one->score > best->score)) best = one;
          }
        });
      }
    }
    return best;
  }

 private:
  template <typename Visit>
  void for_each_hinge(const Point2& jamb, const Point2& shut, const Point2& out,
                      Visit visit) const {
    for (double along_m = -options_.hinge_m; along_m <= options_.hinge_m + 1e-9;
         along_m += kLeafStep_m) {
      for (double off_m = 0.0; off_m <= options_.depth_m + 1e-9; off_m += kLeafStep_m) {
        const Point2 hinge = jamb + along_m * shut + off_m * out;
        if (is_solid(hinge)) visit(hinge);
      }
    }
  }

  [[nodiscard]] bool is_solid(const Point2& at) const {
    return occupancy_.obstacle.at(occupancy_.frame.cell_of(at));
  }
  /// The same for a leaf along a direction: the cells of a slanted one are steps.
  [[nodiscard]] bool is_solid(const Point2& at, const Point2& along) const {
    const Point2 aside = occupancy_.frame.cell_m / 2.0 * Point2(-along.y(), along.x());
    return is_solid(at) || is_solid(at + aside) || is_solid(at - aside);
  }
  [[nodiscard]] bool is_floor(const Point2& at) const {
    const Cell cell = occupancy_.frame.cell_of(at);
    return occupancy_.free.at(cell) && !near_obstacle_.at(cell);
  }

  /// How far something stands without a break.
  [[nodiscard]] double solid_m(const Point2& hinge, const Point2& along, double most_m) const {
    double last_m = 0.0;
    for (double at_m = kLeafStep_m; at_m <= most_m; at_m += kLeafStep_m) {
      if (is_solid(hinge + at_m * along, along)) last_m = at_m;
      if (at_m - last_m > (kMostGaps + 0.5) * kLeafStep_m) break;
    }
    return last_m;
  }

  [[nodiscard]] std::optional<Candidate> leaf(const Point2& hinge, const Point2& along,
                                              double width_m) const {
    const double length_m = solid_m(hinge, along, width_m + options_.longer_m + 3 * kLeafStep_m);
    if (length_m < width_m - options_.shorter_m || length_m > width_m + options_.longer_m) {
      return std::nullopt;
    }
    const Point2 end = hinge + length_m * along;
    for (const double turn_rad : kRound_rad) {
      if (!is_floor(end + kRound_m * (Pose2{0.0, 0.0, turn_rad} * along))) return std::nullopt;
    }
    const Point2 aside = kBeside_m * Point2(-along.y(), along.x());
    int solid = 0;
    int steps = 0;
    int open = 0;
    int sides = 0;
    for (double at_m = kLeafStep_m; at_m <= length_m + 1e-9; at_m += kLeafStep_m) {
      ++steps;
      const Point2 at = hinge + at_m * along;
      if (is_solid(at, along)) ++solid;
      if (at_m < kFromHinge_m) continue;
      sides += 2;
      open += is_floor(at + aside) ? 1 : 0;
      open += is_floor(at - aside) ? 1 : 0;
    }
    const double solid_share = static_cast<double>(solid) / std::max(1, steps);
    const double open_share = static_cast<double>(open) / std::max(1, sides);
    if (solid_share < options_.solid_share || open_share < options_.open_share) {
      return std::nullopt;
    }
    return Candidate{{hinge, end}, solid_share + open_share - std::abs(length_m - width_m)};
  }

  const Occupancy& occupancy_;
  const LeafOptions& options_;
  CellMask near_obstacle_;
};

/// A leaf but for its end at the wall.
Segment2 own_part(const DoorLeaf& leaf) {
  return {leaf.line.a + kWall_m * (leaf.line.b - leaf.line.a).normalized(), leaf.line.b};
}

/// Takes out of a face what lies on a leaf.
void cut(const DoorLeaf& leaf, WallFace& face) {
  const Segment2 own = own_part(leaf);
  if (std::abs((own.b - own.a).normalized().dot(face.normal())) > kOwnSine) return;
  std::vector<Interval> kept;
  for (const Interval& stretch : face.seen) {
    const std::vector<Interval> parts =
        kept_parts(stretch, kCut_m, kLeafStep_m,
                   [&](double along_m) { return distance(own, face.at(along_m)) > kOwn_m; });
    kept.insert(kept.end(), parts.begin(), parts.end());
  }
  face.seen = std::move(kept);
}

Point2 middle_of(const Segment2& line) { return (line.a + line.b) / 2.0; }

}  // namespace

std::vector<DoorLeaf> find_leaves(const std::vector<Segment2>& gaps, const Occupancy& occupancy,
                                  const LeafOptions& options) {
  const Finder finder(occupancy, options);
  std::vector<DoorLeaf> leaves;
  for (const Segment2& gap : gaps) {
    const auto found = finder.at(gap);
    if (!found) continue;
    const bool is_known = std::any_of(leaves.begin(), leaves.end(), [&](const DoorLeaf& leaf) {
      return (middle_of(leaf.line) - middle_of(found->line)).norm() < kSame_m ||
             (middle_of(leaf.gap) - middle_of(gap)).norm() < kSame_m;
    });
    if (!is_known) leaves.push_back({found->line, gap});
  }
  return leaves;
}

std::vector<WallFace> without_leaves(std::vector<WallFace> faces,
                                     const std::vector<DoorLeaf>& leaves) {
  for (WallFace& face : faces) {
    for (const DoorLeaf& leaf : leaves) cut(leaf, face);
  }
  std::erase_if(faces, [](const WallFace& face) { return face.seen.empty(); });
  return faces;
}

void clear_leaves(const std::vector<DoorLeaf>& leaves, Occupancy& occupancy) {
  for (const DoorLeaf& leaf : leaves) {
    const Segment2 own = own_part(leaf);
    Box2 around;
    for (const Point2& at : {own.a, own.b}) {
      around.extend(at - Point2::Constant(kOwn_m));
      around.extend(at + Point2::Constant(kOwn_m));
    }
    const CellBox box{occupancy.frame.cell_of(around.min), occupancy.frame.cell_of(around.max)};
    for_each_cell(box, [&](const Cell& cell) {
      if (distance(own, occupancy.frame.center_of(cell)) > kOwn_m) return;
      occupancy.obstacle.set(cell, false);
      occupancy.free.set(cell, true);
      occupancy.seen.set(cell, true);
    });
  }
}

void hang_leaves(const std::vector<DoorLeaf>& leaves, std::vector<Door>& doors) {
  for (const DoorLeaf& leaf : leaves) {
    Door* nearest = nullptr;
    double nearest_m = kSameGap_m;
    for (Door& door : doors) {
      const double off_m = (door.frame_from_pivot.position() - middle_of(leaf.gap)).norm();
      if (door.kind != DoorKind::door || door.leaf || off_m >= nearest_m) continue;
      nearest = &door;
      nearest_m = off_m;
    }
    if (nearest != nullptr) nearest->leaf = leaf.line;
  }
}

}  // namespace roomatlas
