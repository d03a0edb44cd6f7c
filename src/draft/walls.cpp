// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "furniture_fronts.hpp"
#include "straight_runs.hpp"
#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kPlaceStep_m = 0.05;  // between places along a face
constexpr int kGapSteps = 2;           // of few reflections in a face
constexpr double kShortestStretch_m = 0.08;
constexpr std::array kShifts_m = {-0.05, 0.0, 0.05};
constexpr double kOppositeCosine = -0.9995;
constexpr double kShortestOverlap_m = 0.2;  // of the two faces of a wall
constexpr double kStrongLine_m = 2.5;       // of prominence, for a line that hidden walls run to
constexpr double kStrongFace_m = 2.0;       // faces less prominent do not run on
constexpr double kHiddenReach_m = 1.2;      // the line's own ends may be hidden too
constexpr double kCrossingSine = 0.5;       // lines that cross at less do not end each other
constexpr double kBehind_m = 0.05;          // a face
constexpr std::array kInside = {0.25, 0.5, 0.75};  // of a wall's thickness
constexpr double kCorner_m = 0.1;  // beside what hides a wall there is floor before it
constexpr double kNested_m = 0.5;  // support of a thinner wall that hides a thicker one

/// Places along a stretch.
std::vector<double> places_on(const Interval& stretch) {
  const int count = std::max(2, static_cast<int>(stretch.length_m() / kPlaceStep_m));
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    places.push_back(stretch.low_m + stretch.length_m() * i / (count - 1));
  }
  return places;
}

/// Where along a face its cells reflect.
std::vector<Interval> confirmed(const WallFace& face, const ReflectionMap& counts, double share) {
  std::vector<Interval> kept;
  for (const Interval& stretch : face.seen) {
    const std::vector<double> places = places_on(stretch);
    std::vector<int> good;
    for (std::size_t i = 0; i < places.size(); ++i) {
      double most = 0.0;
      for (const double across_m : kShifts_m) {
        const Point2 at = face.at(places[i]) + across_m * face.normal();
        most = std::max(most, counts.at(counts.frame().cell_of(at)).reflected_share());
      }
      if (most >= share) good.push_back(static_cast<int>(i));
    }
    for (const auto& [first, last] : runs_of(good, kGapSteps)) {
      const Interval one{places[static_cast<std::size_t>(good[first])],
                         places[static_cast<std::size_t>(good[last])]};
      if (one.length_m() >= kShortestStretch_m) kept.push_back(one);
    }
  }
  return kept;
}

/// How far along a face the strongest line crosses it, at most `reach_m` beyond an end.
std::optional<double> end_behind(const WallFace& face, double end_m, double sign, double reach_m,
                                 const std::vector<WallFace>& faces) {
  std::optional<double> best_m;
  double strongest_m = 0.0;
  for (const WallFace& line : faces) {
    if (!line.is_regular || line.prominence_m < std::max(kStrongLine_m, strongest_m)) continue;
    const double sine = face.along().dot(line.normal());
    if (std::abs(sine) < kCrossingSine) continue;
    const double beyond_m = (line.offset_m - face.at(end_m).dot(line.normal())) / sine;
    if (beyond_m * sign < 0.02 || std::abs(beyond_m) > reach_m) continue;
    const double on_line_m = face.at(end_m + beyond_m).dot(line.along());
    if (on_line_m < line.cover.front().low_m - kHiddenReach_m ||
        on_line_m > line.cover.back().high_m + kHiddenReach_m) {
      continue;
    }
    if (line.prominence_m > strongest_m) {
      strongest_m = line.prominence_m;
      best_m = end_m + beyond_m;
    }
  }
  return best_m;
}

class Builder {
 public:
  Builder(Walls& walls, const Occupancy& occupancy, const WallOptions& options)
      : walls_(walls), occupancy_(occupancy), options_(options) {
    near_obstacle_ = dilated(occupancy.obstacle, 1);
  }

  void find_bodies() {
    for (WallFace& face : walls_.faces) face.cover = cover_of(face);
    std::vector<std::vector<Interval>> covers;
    for (const WallFace& face : walls_.faces) covers.push_back(cover_to_next_walls(face));
    for (std::size_t i = 0; i < covers.size(); ++i) walls_.faces[i].cover = std::move(covers[i]);
    std::vector<WallBody> bodies;
    for (std::size_t i = 0; i < walls_.faces.size(); ++i) {
      for (std::size_t j = i + 1; j < walls_.faces.size(); ++j) {
        if (auto body = body_of(i, j)) bodies.push_back(std::move(*body));
      }
    }
    std::stable_sort(bodies.begin(), bodies.end(), [](const WallBody& a, const WallBody& b) {
      return a.thickness_m < b.thickness_m;
    });
    for (WallBody& body : bodies) {
      if (!hides_a_cupboard(body)) walls_.bodies.push_back(std::move(body));
    }
  }

 private:
  /// Just behind its face a wall is not free; before it there may be a slit behind furniture.
  [[nodiscard]] bool is_hidden(const WallFace& face, const Interval& stretch,
                               double off_m = -kBehind_m) const {
    return free_share(face, stretch, off_m, occupancy_, near_obstacle_) <
           options_.hidden_free_share;
  }

  /// Where a face goes on, seen or hidden.
  [[nodiscard]] std::vector<Interval> cover_of(const WallFace& face) const {
    std::vector<Interval> known = face.seen;
    known.insert(known.end(), face.hidden.begin(), face.hidden.end());
    std::sort(known.begin(), known.end(),
              [](const Interval& a, const Interval& b) { return a.low_m < b.low_m; });
    std::vector<Interval> cover;
    for (const Interval& stretch : known) {
      const bool goes_on =
          !cover.empty() && (stretch.low_m - cover.back().high_m <= options_.door_m ||
                             is_hidden(face, {cover.back().high_m, stretch.low_m}));
      if (goes_on) {
        cover.back().high_m = std::max(cover.back().high_m, stretch.high_m);
      } else {
        cover.push_back(stretch);
      }
    }
    return cover;
  }

  /// The same, and on beyond both ends where that is hidden: up to where the face's line is seen
  /// again, else up to the next wall that crosses it.
  [[nodiscard]] std::vector<Interval> cover_to_next_walls(const WallFace& face) const {
    std::vector<Interval> cover = face.cover;
    if (!face.is_regular || face.is_furniture || face.prominence_m < kStrongFace_m) return cover;
    cover.front().low_m = hidden_end(face, cover.front().low_m, -1.0);
    cover.back().high_m = hidden_end(face, cover.back().high_m, 1.0);
    return cover;
  }

  [[nodiscard]] double hidden_end(const WallFace& face, double end_m, double sign) const {
    for (const auto& further_m :
         {seen_again(face, end_m, sign),
          end_behind(face, end_m, sign, options_.hidden_end_m, walls_.faces)}) {
      if (!further_m) continue;
      if (is_hidden(face, {std::min(end_m, *further_m), std::max(end_m, *further_m)})) {
        return *further_m;
      }
    }
    return end_m;
  }

  /// Where a face's line is next seen from the same side, beyond an end.
  [[nodiscard]] std::optional<double> seen_again(const WallFace& face, double end_m,
                                                 double sign) const {
    std::optional<double> next_m;
    for (const WallFace& other : walls_.faces) {
      if (other.is_furniture || other.normal_rad != face.normal_rad) continue;
      if (std::abs(other.offset_m - face.offset_m) > options_.same_line_m) continue;
      const double at_m = sign > 0.0 ? other.low_m() : other.high_m();
      const double beyond_m = sign * (at_m - end_m);
      if (beyond_m <= 0.0 || beyond_m > options_.hidden_reach_m) continue;
      if (!next_m || beyond_m < sign * (*next_m - end_m)) next_m = at_m;
    }
    return next_m;
  }

  /// A wall goes on where one of its faces does and furniture hides the other.
  [[nodiscard]] Interval extended(const Interval& both, const Interval& front, const Interval& back,
                                  const WallBody& body) const {
    const WallFace& face = walls_.faces[body.front];
    const auto is_solid = [&](double along_m) {
      const Interval step{along_m - kPlaceStep_m / 2.0, along_m + kPlaceStep_m / 2.0};
      return std::all_of(kInside.begin(), kInside.end(), [&](double share) {
        return is_hidden(face, step, -share * body.thickness_m);
      });
    };
    Interval whole = both;
    const double low_m = std::min(front.low_m, back.low_m);
    while (whole.low_m > low_m && is_solid(whole.low_m - kCorner_m)) whole.low_m -= kPlaceStep_m;
    const double high_m = std::max(front.high_m, back.high_m);
    while (whole.high_m < high_m && is_solid(whole.high_m + kCorner_m))
      whole.high_m += kPlaceStep_m;
    return whole;
  }

  [[nodiscard]] std::optional<WallBody> body_of(std::size_t i, std::size_t j) const {
    const WallFace& front = walls_.faces[i];
    const WallFace& back = walls_.faces[j];
    if (front.is_furniture || back.is_furniture) return std::nullopt;
    if (front.normal().dot(back.normal()) > kOppositeCosine) return std::nullopt;
    WallBody body{i, j, front.offset_m + back.offset_m, {}};
    if (body.thickness_m <= options_.thinnest_m || body.thickness_m > options_.thickest_m) {
      return std::nullopt;
    }
    for (const Interval& a : front.cover) {
      for (const Interval& b : back.cover) {  // counts the other way
        const Interval both{std::max(a.low_m, -b.high_m), std::min(a.high_m, -b.low_m)};
        if (both.length_m() > kShortestOverlap_m) {
          body.stretches.push_back(extended(both, a, {-b.high_m, -b.low_m}, body));
        }
      }
    }
    if (body.stretches.empty()) return std::nullopt;
    const bool is_thin = body.thickness_m <= options_.thin_m;
    const double least_m = is_thin ? options_.min_thin_support_m : options_.min_body_support_m;
    if (std::min(front.support_m(), back.support_m()) < least_m) return std::nullopt;
    return body;
  }

  /// A thinner wall on one of its faces: what stands before that is furniture.
  [[nodiscard]] bool hides_a_cupboard(const WallBody& body) const {
    return std::any_of(walls_.bodies.begin(), walls_.bodies.end(), [&](const WallBody& thin) {
      if (thin.thickness_m < 2.0 * options_.thinnest_m ||
          thin.thickness_m >= body.thickness_m - options_.nested_m) {
        return false;
      }
      // A face is front in one wall and may be back in another: it is the number that counts.
      for (const auto& [own, other] :
           {std::pair(thin.front, thin.back), std::pair(thin.back, thin.front)}) {
        const bool is_shared = own == body.front || own == body.back;
        const bool is_same = other == body.front || other == body.back;
        if (is_shared && !is_same && walls_.faces[other].support_m() >= kNested_m) return true;
      }
      return false;
    });
  }

  Walls& walls_;
  const Occupancy& occupancy_;
  const WallOptions& options_;
  CellMask near_obstacle_{CellBox{}};
};

}  // namespace

std::vector<WallFace> confirmed_faces(std::vector<WallFace> faces, const BuildingEvidence& evidence,
                                      const WallOptions& options) {
  const bool is_sonar = evidence.kind == SensorKind::sonar;
  std::vector<WallFace> kept;
  for (WallFace& face : faces) {
    face.seen =
        confirmed(face, evidence.counts, is_sonar ? options.sonar_share : options.laser_share);
    if (face.seen.empty()) continue;
    const double shortest_m = is_sonar ? options.min_sonar_face_m : options.min_laser_face_m;
    if (face.support_m() >= shortest_m) kept.push_back(std::move(face));
  }
  return kept;
}

Walls build_walls(std::vector<WallFace> faces, const Occupancy& occupancy,
                  const WallOptions& options) {
  set_fronts_apart(occupancy, options, faces);
  Walls walls{std::move(faces), {}};
  for (WallFace& face : walls.faces) {
    face.prominence_m =
        face.is_furniture ? 0.0 : seen_on_line_m(face, walls.faces, options.same_line_m);
  }
  Builder(walls, occupancy, options).find_bodies();
  for (const WallBody& body : walls.bodies) {
    WallFace& front = walls.faces[body.front];
    WallFace& back = walls.faces[body.back];
    const double both_m = front.support_m() + back.support_m();
    front.prominence_m = std::max(front.prominence_m, both_m);
    back.prominence_m = std::max(back.prominence_m, both_m);
  }
  return walls;
}

}  // namespace roomatlas
