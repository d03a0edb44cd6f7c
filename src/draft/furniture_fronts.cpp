// SPDX-License-Identifier: GPL-3.0-or-later
#include "furniture_fronts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kFaceStep_m = 0.05;    // between places along a face
constexpr double kParallelSine = 0.03;  // faces that turn by less are parallel
constexpr double kBackClear_m = 0.05;   // a wall's other side lies so much before the wall behind
constexpr double kBackShare = 0.4;      // of a front, that has another side
constexpr double kAlongFront_m = 0.05;  // a front that adds less does not count
constexpr double kShortestFront_m = 0.3;
constexpr double kBehindFace_m = 0.05;             // before it there may be a slit behind furniture
constexpr std::array kBehind_m = {0.6, 0.9, 1.2};  // tables are not deeper

/// A stretch of a face.
struct Piece {
  std::size_t face = 0;
  std::size_t stretch = 0;
};

class Fronts {
 public:
  Fronts(const Occupancy& occupancy, const WallOptions& options, std::vector<WallFace>& faces)
      : occupancy_(occupancy),
        walls_(options),
        options_(options.fronts),
        faces_(faces),
        near_obstacle_(dilated(occupancy.obstacle, 1)) {
    for (const WallFace& face : faces) is_front_.emplace_back(face.seen.size(), false);
  }

  void find() {
    look();  // a front may hide behind another, ...
    const auto may_be_front = is_front_;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      is_front_[i].assign(faces_[i].seen.size(), false);
      faces_[i].hidden.clear();
    }
    look(&may_be_front);  // ... but what goes on behind fronts is a wall
  }

  void note_what_is_behind() {
    for (WallFace& face : faces_) face.is_closed_behind = is_closed_behind(face);
  }

  void apart() {
    std::vector<WallFace> fronts;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      WallFace& face = faces_[i];
      std::vector<Interval> rest;
      for (std::size_t k = 0; k < face.seen.size(); ++k) {
        if (!is_front_[i][k]) {
          rest.push_back(face.seen[k]);
          continue;
        }
        WallFace front = face;
        front.seen = {face.seen[k]};
        front.hidden.clear();
        front.is_furniture = true;
        fronts.push_back(std::move(front));
      }
      face.seen = std::move(rest);
    }
    std::erase_if(faces_, [](const WallFace& face) { return face.seen.empty(); });
    faces_.insert(faces_.end(), fronts.begin(), fronts.end());
  }

 private:
  using Flags = std::vector<std::vector<bool>>;  ///< of stretches, by face

  /// @param no_walls stretches behind which nothing goes on
  void look(const Flags* no_walls = nullptr) {
    for (std::size_t wall = 0; wall < faces_.size(); ++wall) {
      if (!faces_[wall].is_regular || faces_[wall].is_furniture) continue;
      const double line_m = seen_on_line_m(faces_[wall], faces_, walls_.same_line_m);
      if (line_m < options_.least_wall_m) continue;
      const std::vector<Interval> seen = faces_[wall].seen;
      for (std::size_t k = 0; k < seen.size(); ++k) {
        if (no_walls != nullptr && (*no_walls)[wall][k]) continue;
        follow(wall, seen[k].low_m, -1.0, line_m);
        follow(wall, seen[k].high_m, 1.0, line_m);
      }
    }
  }

  /// From where a wall is lost, along the fronts that hide it.
  void follow(std::size_t wall, double end_m, double sign, double wall_line_m) {
    const double from_m = end_m;
    while (const auto next = front_at(wall, end_m, sign, wall_line_m)) {
      const Interval reach = along(faces_[wall], *next);
      end_m = sign > 0.0 ? reach.high_m : reach.low_m;
      is_front_[next->face][next->stretch] = true;
    }
    if (end_m != from_m) {
      faces_[wall].hidden.push_back({std::min(from_m, end_m), std::max(from_m, end_m)});
    }
  }

  [[nodiscard]] Interval along(const WallFace& wall, const Piece& piece) const {
    const WallFace& face = faces_[piece.face];
    const double a_m = face.at(face.seen[piece.stretch].low_m).dot(wall.along());
    const double b_m = face.at(face.seen[piece.stretch].high_m).dot(wall.along());
    return {std::min(a_m, b_m), std::max(a_m, b_m)};
  }

  /// The front before a wall that begins where the wall is lost.
  [[nodiscard]] std::optional<Piece> front_at(std::size_t wall, double end_m, double sign,
                                              double wall_line_m) const {
    const WallFace& behind = faces_[wall];
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const WallFace& face = faces_[i];
      if (!face.is_regular || face.normal_rad != behind.normal_rad) continue;
      const double depth_m = face.offset_m - behind.offset_m;
      if (depth_m < options_.shallowest_m || depth_m > options_.deepest_m) continue;
      for (std::size_t k = 0; k < face.seen.size(); ++k) {
        const Interval reach = along(behind, {i, k});
        const double begins_m = sign > 0.0 ? reach.low_m - end_m : end_m - reach.high_m;
        const double beyond_m = sign > 0.0 ? reach.high_m - end_m : end_m - reach.low_m;
        if (std::abs(begins_m) > options_.beside_m || beyond_m < kAlongFront_m) continue;
        if (reach.length_m() > options_.longest_m || reach.length_m() < kShortestFront_m) continue;
        if (wall_line_m < options_.least_share * reach.length_m()) continue;
        const Interval lost =
            sign > 0.0 ? Interval{end_m, reach.high_m} : Interval{reach.low_m, end_m};
        if (free_share(behind, lost, -kBehindFace_m, occupancy_, near_obstacle_) >
                walls_.hidden_free_share ||
            free_share(behind, lost, depth_m / 2.0, occupancy_, near_obstacle_) >
                walls_.hidden_free_share ||
            has_other_side(face, face.seen[k], depth_m)) {
          continue;
        }
        return Piece{i, k};
      }
    }
    return std::nullopt;
  }

  /// Whether a stretch was seen from behind too, before the wall: then it is a wall itself.
  [[nodiscard]] bool has_other_side(const WallFace& face, const Interval& stretch,
                                    double depth_m) const {
    return other_side_m(face, stretch, depth_m - kBackClear_m) > kBackShare * stretch.length_m();
  }

  /// Whether a face is a wall's by what is behind it: its other side, or nothing that was seen.
  /// Behind a table's side there is floor again.
  [[nodiscard]] bool is_closed_behind(const WallFace& face) const {
    double other_m = 0.0;
    double open_m = 0.0;
    for (const Interval& stretch : face.seen) {
      other_m += other_side_m(face, stretch, walls_.thickest_m);
      double open = 0.0;
      for (const double behind_m : kBehind_m) {
        open = std::max(open, free_share(face, stretch, -behind_m, occupancy_, near_obstacle_));
      }
      open_m += open * stretch.length_m();
    }
    const double all_m = face.support_m();
    return other_m > kBackShare * all_m || open_m < options_.open_share * all_m;
  }

  /// How much of a stretch was seen from behind, up to so far behind.
  [[nodiscard]] double other_side_m(const WallFace& face, const Interval& stretch,
                                    double within_m) const {
    double seen_m = 0.0;
    for (const WallFace& back : faces_) {
      if (back.normal().dot(face.normal()) > -1.0 + kParallelSine * kParallelSine) continue;
      const double thickness_m = face.offset_m + back.offset_m;
      if (thickness_m <= 0.0 || thickness_m > within_m) continue;
      for (const Interval& one : back.seen) {
        const Interval both{std::max(stretch.low_m, -one.high_m),
                            std::min(stretch.high_m, -one.low_m)};
        seen_m += std::max(0.0, both.length_m());
      }
    }
    return seen_m;
  }

  const Occupancy& occupancy_;
  const WallOptions& walls_;
  const FrontOptions& options_;
  std::vector<WallFace>& faces_;
  CellMask near_obstacle_;
  Flags is_front_;  ///< parallel to the stretches of the faces
};

}  // namespace

double free_share(const WallFace& face, const Interval& stretch, double off_m,
                  const Occupancy& occupancy, const CellMask& near_obstacle) {
  const int count = std::max(1, static_cast<int>(stretch.length_m() / kFaceStep_m));
  int free = 0;
  for (int i = 0; i < count; ++i) {
    const double along_m = stretch.low_m + (i + 0.5) * stretch.length_m() / count;
    const Cell cell = occupancy.frame.cell_of(face.at(along_m) + off_m * face.normal());
    if (occupancy.free.at(cell) && !near_obstacle.at(cell)) ++free;
  }
  return static_cast<double>(free) / count;
}

void set_fronts_apart(const Occupancy& occupancy, const WallOptions& options,
                      std::vector<WallFace>& faces) {
  Fronts fronts(occupancy, options, faces);
  fronts.find();
  fronts.apart();
  fronts.note_what_is_behind();
}

}  // namespace roomatlas
