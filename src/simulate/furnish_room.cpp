// SPDX-License-Identifier: GPL-3.0-or-later
#include "furnish_room.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/polyline/simplify.hpp"

namespace roomatlas {
namespace {

constexpr int kTriesOfPiece = 25;       // of a piece; more fill a room more
constexpr double kStraightM = 0.08;     // the steps of a raster in a room's outline make no corners
constexpr double kLeastStretchM = 0.6;  // of wall, for a piece along it
constexpr double kFromWallM = 0.03;     // half of the pieces stand off by this: skirting, cables
constexpr double kInsideM = 0.02;       // how far inside of its outline a piece's corners are asked
constexpr double kChairM = 0.45;
constexpr double kLegM = 0.04;
constexpr double kChairPitchM = 0.65;   // between chairs at a table
constexpr double kChairTurnDeg = 15.0;  // they do not stand quite straight
constexpr double kLeggedShare = 0.5;    // of the groups have chairs on four thin legs

/// The straight stretches of the room's outline, the room on their left.
std::vector<Segment2> stretches_of(const PlanRoom& room) {
  std::vector<Segment2> stretches;
  const auto append = [&](Ring ring, bool counter_clockwise) {
    if (ring.size() < 3) return;
    if ((signed_area(ring) > 0.0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
    ring.push_back(ring.front());
    const auto kept = douglas_peucker(ring, kStraightM);
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
      const Segment2 stretch{ring[kept[i]], ring[kept[i + 1]]};
      if ((stretch.b - stretch.a).norm() >= kLeastStretchM) stretches.push_back(stretch);
    }
  };
  for (const Polygon& part : room.parts) {
    append(part.outer, true);
    for (const Ring& hole : part.holes) append(hole, false);
  }
  return stretches;
}

double length_of(const Segment2& segment) { return (segment.b - segment.a).norm(); }

double heading_of(const Segment2& segment) {
  return std::atan2(segment.b.y() - segment.a.y(), segment.b.x() - segment.a.x());
}

/// The rectangle around a frame's origin.
Ring centred(const Pose2& world_from_frame, double length_m, double depth_m) {
  const Point2 half(length_m / 2.0, depth_m / 2.0);
  return rectangle_in(world_from_frame, -half, half);
}

}  // namespace

RoomFurnisher::RoomFurnisher(const PlanRoom& room, const FurnishOptions& options, FurnishSite& site,
                             RoomWays& ways, std::vector<PlanFurniture>& furniture,
                             RandomStream& random)
    : room_(room),
      options_(options),
      site_(site),
      ways_(ways),
      furniture_(furniture),
      random_(random),
      walls_(stretches_of(room)) {
  const auto longest = std::max_element(
      walls_.begin(), walls_.end(),
      [](const Segment2& a, const Segment2& b) { return length_of(a) < length_of(b); });
  if (longest != walls_.end()) direction_rad_ = heading_of(*longest);
}

double RoomFurnisher::between(double low, double high) {
  return low + (high - low) * random_.uniform();
}

void RoomFurnisher::put(const Inventory& inventory) {
  for (int i = 0; i < inventory.rows; ++i) put_row(inventory);
  for (int i = 0; i < inventory.islands; ++i) put_island();
  for (int i = 0; i < inventory.desks; ++i) put_desk();
  for (int i = 0; i < inventory.tables; ++i) put_table();
  for (int i = 0; i < inventory.boxes; ++i) put_box();
}

void RoomFurnisher::put_row(const Inventory& inventory) {
  (void)put_at_wall({between(0.8, inventory.longest_row_m), between(0.4, inventory.deepest_row_m)});
}

void RoomFurnisher::put_island() { (void)put_free({between(1.6, 4.0), between(0.4, 0.8)}, true); }

void RoomFurnisher::put_desk() {
  const Size size{between(1.2, 1.8), between(0.6, 0.8)};
  const bool has_legs = random_.uniform() < kLeggedShare;
  const auto desk = put_at_wall(size);
  if (!desk) return;
  const Pose2 desk_from_chair{between(-0.2, 0.2), size.depth_m + between(0.25, 0.5),
                              radians(between(-kChairTurnDeg, kChairTurnDeg))};
  (void)put_chair(*desk * desk_from_chair, has_legs);
}

void RoomFurnisher::put_table() {
  const Size size{between(1.2, 2.4), between(0.7, 1.0)};
  const bool is_straight = random_.uniform() < 0.8;
  const bool has_legs = random_.uniform() < kLeggedShare;
  if (const auto table = put_free(size, is_straight)) put_chairs(*table, size, has_legs);
}

void RoomFurnisher::put_chairs(const Pose2& world_from_table, const Size& table, bool has_legs) {
  const int seats = static_cast<int>(table.length_m / kChairPitchM);
  for (const double side : {-1.0, 1.0}) {
    for (int seat = 0; seat < seats; ++seat) {
      const double x = (seat + 0.5 - seats / 2.0) * kChairPitchM;
      const double away_m = table.depth_m / 2.0 + kChairM / 2.0 + between(0.05, 0.25);
      const Pose2 table_from_chair{x, side * away_m,
                                   radians(between(-kChairTurnDeg, kChairTurnDeg))};
      if (random_.uniform() < 0.8) (void)put_chair(world_from_table * table_from_chair, has_legs);
    }
  }
}

bool RoomFurnisher::put_chair(const Pose2& world_from_chair, bool has_legs) {
  const Ring outline = centred(world_from_chair, kChairM, kChairM);
  if (!has_legs) return put_piece(outline, {outline}, FurnitureKind::free_standing);
  const double to_leg_m = (kChairM - kLegM) / 2.0;
  std::vector<Ring> legs;
  for (const Point2& corner : {Point2(-1, -1), Point2(1, -1), Point2(1, 1), Point2(-1, 1)}) {
    const Point2 at = to_leg_m * corner;
    legs.push_back(centred(world_from_chair * Pose2{at.x(), at.y(), 0.0}, kLegM, kLegM));
  }
  return put_piece(outline, legs, FurnitureKind::free_standing);
}

void RoomFurnisher::put_box() { (void)put_free({between(0.3, 0.5), between(0.3, 0.5)}, false); }

std::optional<Pose2> RoomFurnisher::put_at_wall(const Size& size) {
  if (walls_.empty()) return std::nullopt;
  double total_m = 0.0;
  for (const Segment2& wall : walls_) total_m += length_of(wall);
  for (int i = 0; i < kTriesOfPiece; ++i) {
    double along_m = total_m * random_.uniform();
    auto wall = walls_.begin();
    for (; std::next(wall) != walls_.end() && along_m > length_of(*wall); ++wall) {
      along_m -= length_of(*wall);
    }
    const double free_m = length_of(*wall) - size.length_m;
    const double share = random_.uniform();
    const double off_m = random_.uniform() < 0.5 ? 0.0 : kFromWallM;
    if (free_m < 0.0) continue;
    const Pose2 world_from_line =
        Pose2{wall->a.x(), wall->a.y(), heading_of(*wall)} * Pose2{share * free_m, 0.0, 0.0};
    const auto face_m = site_.wall_face_m(world_from_line, size.length_m);
    if (!face_m) continue;
    const Pose2 back = world_from_line * Pose2{size.length_m / 2.0, *face_m + off_m, 0.0};
    const Ring outline =
        centred(back * Pose2{0.0, size.depth_m / 2.0, 0.0}, size.length_m, size.depth_m);
    if (put_piece(outline, {outline}, FurnitureKind::against_wall)) return back;
  }
  return std::nullopt;
}

std::optional<Pose2> RoomFurnisher::put_free(const Size& size, bool along_walls) {
  for (int i = 0; i < kTriesOfPiece; ++i) {
    const auto place = some_place();
    const double turn_rad = 2.0 * kPi * random_.uniform();
    if (!place) continue;
    const double quarters = std::floor(turn_rad / (kPi / 2.0));
    const double heading_rad = along_walls ? direction_rad_ + quarters * kPi / 2.0 : turn_rad;
    const Pose2 at{place->x(), place->y(), wrap_angle(heading_rad)};
    const Ring outline = centred(at, size.length_m, size.depth_m);
    if (put_piece(outline, {outline}, FurnitureKind::free_standing)) return at;
  }
  return std::nullopt;
}

/// A point of the room, by chance; sometimes none is found in a room of odd shape.
std::optional<Point2> RoomFurnisher::some_place() {
  if (room_.parts.empty()) return std::nullopt;
  const Box2 box = bounds(room_.parts.front().outer);
  for (int i = 0; i < kTriesOfPiece; ++i) {
    const double x = between(box.min.x(), box.max.x());
    const Point2 place(x, between(box.min.y(), box.max.y()));
    if (contains(room_.parts.front(), place)) return place;
  }
  return std::nullopt;
}

bool RoomFurnisher::is_in_room(const Ring& outline) const {
  Point2 middle = Point2::Zero();
  for (const Point2& corner : outline) middle += corner / static_cast<double>(outline.size());
  const auto inside = [&](const Point2& point) {
    return std::any_of(room_.parts.begin(), room_.parts.end(),
                       [&](const Polygon& part) { return contains(part, point); });
  };
  return inside(middle) && std::all_of(outline.begin(), outline.end(), [&](const Point2& corner) {
           const Point2 in = middle - corner;
           return inside(corner + kInsideM / in.norm() * in);
         });
}

bool RoomFurnisher::put_piece(const Ring& outline, const std::vector<Ring>& bodies,
                              FurnitureKind kind) {
  if (!is_in_room(outline) || !site_.has_place_for(outline)) return false;
  if (!ways_.add(outline, options_.way_width_m / 2.0)) return false;
  site_.add(outline);
  for (const Ring& body : bodies) furniture_.push_back({{body, {}}, kind});
  return true;
}

}  // namespace roomatlas
