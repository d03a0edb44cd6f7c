// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/doors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sonar_jambs.hpp"

namespace roomatlas {
namespace {

constexpr double kNearWall_m = 2.0;   // a wall is seen this near an opening, or it is another's
constexpr double kMostAside_m = 0.3;  // of a door's middle from that of the opening in the floor
constexpr double kMostWider_m = 0.5;  // than the opening in the floor, which margins narrow
constexpr double kBand_m = 0.06;      // off a face's line: surfaces of the wall
constexpr double kFaceTurn_rad = 30.0 * kPi / 180.0;
constexpr double kBin_m = 0.02;
constexpr double kReach_m = 3.0;      // along the wall from the opening's middle
constexpr double kEnough = 4.0;       // beams in the first part of a wall beside an opening ...
constexpr double kFirstPart_m = 0.1;  // ... of this length
constexpr double kReveal_m = 0.12;    // jambs' own surfaces, from where the wall begins

/// The wall that an opening is in: one or two faces that run along it.
struct WallAt {
  double along_rad = 0.0;  ///< of the front face
  const WallFace* front = nullptr;
  double depth_low_m = 0.0;  ///< of the wall, along the front's normal
  double depth_high_m = 0.0;
};

double distance_along_m(const WallFace& face, double along_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Interval& seen : face.seen) {
    nearest_m = std::min(nearest_m, std::max({0.0, seen.low_m - along_m, along_m - seen.high_m}));
  }
  return nearest_m;
}

/// The most prominent face along an opening, and the one behind or before it.
std::optional<WallAt> wall_at(const Door& opening, const Walls& walls, const DoorOptions& options) {
  const Point2 middle = opening.frame_from_pivot.position();
  const Point2 way = direction(opening.frame_from_pivot.theta_rad);
  const double least_cosine = std::cos(options.max_turn_deg * kPi / 180.0);
  std::vector<const WallFace*> near;
  for (const WallFace& face : walls.faces) {
    if (std::abs(face.normal().dot(way)) < least_cosine) continue;
    if (std::abs(middle.dot(face.normal()) - face.offset_m) > options.reach_m) continue;
    if (distance_along_m(face, middle.dot(face.along())) > kNearWall_m) continue;
    near.push_back(&face);
  }
  if (near.empty()) return std::nullopt;
  // Near and prominent: a wall 0.3 m farther off, or farther along, is e times as prominent.
  constexpr double kOff_m = 0.3;
  const auto cost = [&](const WallFace* face) {
    const double off_m = std::abs(middle.dot(face->normal()) - face->offset_m);
    const double along_m = distance_along_m(*face, middle.dot(face->along()));
    return (off_m + along_m) / kOff_m - std::log(std::max(0.1, face->prominence_m));
  };
  const WallFace* front =
      *std::min_element(near.begin(), near.end(),
                        [&](const WallFace* a, const WallFace* b) { return cost(a) < cost(b); });
  WallAt wall{front->normal_rad, front, front->offset_m, front->offset_m};
  for (const WallBody& body : walls.bodies) {
    const WallFace* other = &walls.faces[body.front] == front  ? &walls.faces[body.back]
                            : &walls.faces[body.back] == front ? &walls.faces[body.front]
                                                               : nullptr;
    if (other == nullptr || std::find(near.begin(), near.end(), other) == near.end()) continue;
    wall.depth_low_m = front->offset_m - body.thickness_m;
    break;
  }
  return wall;
}

/// Beams on a wall's surfaces in bins along it.
struct Profile {
  double from_m = 0.0;
  std::vector<double> faces;    ///< on the wall's own faces
  std::vector<double> reveals;  ///< between them, on surfaces that look along the wall

  [[nodiscard]] std::size_t bin_of(double along_m) const {
    return static_cast<std::size_t>(
        std::clamp((along_m - from_m) / kBin_m, 0.0, static_cast<double>(faces.size() - 1)));
  }
};

Profile profile_of(const WallAt& wall, double middle_m, const std::vector<SurfacePoint>& surfaces) {
  Profile profile;
  profile.from_m = middle_m - kReach_m;
  profile.faces.assign(static_cast<std::size_t>(2.0 * kReach_m / kBin_m), 0.0);
  profile.reveals = profile.faces;
  const Point2 normal = wall.front->normal();
  const Point2 along = wall.front->along();
  for (const SurfacePoint& surface : surfaces) {
    const double along_m = surface.at.dot(along);
    if (std::abs(along_m - middle_m) >= kReach_m) continue;
    const double depth_m = surface.at.dot(normal);
    if (depth_m < wall.depth_low_m - kBand_m || depth_m > wall.depth_high_m + kBand_m) continue;
    const double turn_rad = std::abs(wrap_angle(surface.normal_rad - wall.along_rad));
    const bool is_on_face =
        (turn_rad < kFaceTurn_rad && depth_m > wall.depth_high_m - kBand_m) ||
        (turn_rad > kPi - kFaceTurn_rad && depth_m < wall.depth_low_m + kBand_m);
    if (is_on_face) profile.faces[profile.bin_of(along_m)] += surface.weight;
    const bool looks_along = std::abs(turn_rad - kPi / 2.0) < kFaceTurn_rad;
    if (looks_along) profile.reveals[profile.bin_of(along_m)] += surface.weight;
  }
  return profile;
}

/// Where the wall begins, from the middle of its opening one way.
std::optional<double> wall_begins(const Profile& profile, double middle_m, int sign) {
  const auto window = static_cast<int>(kFirstPart_m / kBin_m);
  const auto size = static_cast<int>(profile.faces.size());
  for (int bin = static_cast<int>(profile.bin_of(middle_m)); bin >= 0 && bin < size; bin += sign) {
    if (profile.faces[static_cast<std::size_t>(bin)] <= 0.0) continue;
    double sum = 0.0;
    int filled = 0;
    for (int k = 0; k < window; ++k) {
      const int at = bin + sign * k;
      if (at < 0 || at >= size) break;
      sum += profile.faces[static_cast<std::size_t>(at)];
      if (profile.faces[static_cast<std::size_t>(at)] > 0.0) ++filled;
    }
    if (sum >= kEnough && 2 * filled >= window) {
      return profile.from_m + (bin + (sign > 0 ? 0.0 : 1.0)) * kBin_m;
    }
  }
  return std::nullopt;
}

/// The jamb's own surface near where the wall begins is where it is for certain.
double refined(double begins_m, const Profile& profile) {
  double sum = 0.0;
  double weights = 0.0;
  const auto low = profile.bin_of(begins_m - kReveal_m);
  const auto high = profile.bin_of(begins_m + kReveal_m);
  for (std::size_t bin = low; bin <= high; ++bin) {
    sum += profile.reveals[bin] * (profile.from_m + (static_cast<double>(bin) + 0.5) * kBin_m);
    weights += profile.reveals[bin];
  }
  return weights >= kEnough ? sum / weights : begins_m;
}

std::optional<Interval> laser_jambs(const WallAt& wall, double middle_m,
                                    const std::vector<SurfacePoint>& surfaces) {
  const Profile profile = profile_of(wall, middle_m, surfaces);
  const auto low_m = wall_begins(profile, middle_m, -1);
  const auto high_m = wall_begins(profile, middle_m, 1);
  if (!low_m || !high_m) return std::nullopt;
  return Interval{refined(*low_m, profile), refined(*high_m, profile)};
}

Door in_wall(const Door& opening, const Walls& walls, const BuildingEvidence& evidence,
             const DoorOptions& options) {
  const auto wall = wall_at(opening, walls, options);
  if (!wall) return opening;
  const double middle_m = opening.frame_from_pivot.position().dot(wall->front->along());
  std::optional<Interval> jambs = evidence.kind == SensorKind::sonar
                                      ? sonar_jambs(*wall->front, middle_m, evidence)
                                      : laser_jambs(*wall, middle_m, evidence.surfaces);
  const double a_m = opening.jambs.a.dot(wall->front->along());
  const double b_m = opening.jambs.b.dot(wall->front->along());
  const Interval found{std::min(a_m, b_m), std::max(a_m, b_m)};
  // Far from what the floor shows it is another opening's, or a wall that nobody saw.
  const bool is_wild =
      jambs && (std::abs(jambs->low_m - found.low_m) > options.reach_m ||
                std::abs(jambs->high_m - found.high_m) > options.reach_m ||
                std::abs(jambs->low_m + jambs->high_m - 2.0 * middle_m) > 2.0 * kMostAside_m ||
                jambs->length_m() > found.length_m() + kMostWider_m);
  if (!jambs || is_wild) jambs = found;
  const double depth_m = (wall->depth_low_m + wall->depth_high_m) / 2.0;
  const auto point = [&](double along_m) -> Point2 {
    return depth_m * wall->front->normal() + along_m * wall->front->along();
  };
  Segment2 line{point(jambs->low_m), point(jambs->high_m)};
  if ((line.b - line.a).dot(opening.jambs.b - opening.jambs.a) < 0.0) std::swap(line.a, line.b);
  Door door = opening;
  static_cast<Doorway&>(door) = doorway_between(line);
  return door;
}

/// The share of beams that something in an opening reflected.
double reflected_in(const Door& door, const ReflectionMap& counts) {
  double hits = 0.0;
  double all = 0.0;
  for (double share = 0.25; share <= 0.75; share += 0.05) {
    const Point2 at = door.jambs.a + share * (door.jambs.b - door.jambs.a);
    const CellCounts cell = counts.at(counts.frame().cell_of(at));
    hits += cell.hits;
    all += cell.hits + cell.passes;
  }
  return all > 0.0 ? hits / all : 0.0;
}

}  // namespace

std::vector<Door> placed_doors(const std::vector<Door>& openings, const Walls& walls,
                               const BuildingEvidence& evidence, const DoorOptions& options) {
  std::vector<Door> doors;
  for (const Door& opening : openings) {
    Door door = in_wall(opening, walls, evidence, options);
    if (door.width_m < options.narrowest_m) continue;  // a slit between two walls
    const bool is_unsure = evidence.kind == SensorKind::sonar && !door.is_driven;
    if (is_unsure && door.width_m < options.narrowest_unused_m) continue;  // wall nobody heard
    if (door.width_m > options.widest_door_m) door.kind = DoorKind::passage;
    const bool is_glass = evidence.kind == SensorKind::laser && !door.is_driven &&
                          reflected_in(door, evidence.counts) >= options.glass_share;
    if (is_glass) door.kind = DoorKind::window;
    doors.push_back(std::move(door));
  }
  return doors;
}

}  // namespace roomatlas
