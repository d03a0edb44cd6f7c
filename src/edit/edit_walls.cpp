// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "editable.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas::edit {
namespace {

constexpr double kMostTurn_rad = radians(10.0);  // of a face from the wall that is told
constexpr double kLeastShared = 0.5;             // of the told wall that a face runs along
constexpr double kSmallestRoom_m2 = 0.5;
constexpr double kTouching_m = 0.01;  // what is added to a room begins so far inside of it
constexpr double kSliver_m2 = 0.02;   // left at a corner that is not quite square to the told line
constexpr double kDeepest_m = 2.0;    // furniture, from the floor before it to the wall behind it
constexpr double kLongest_m = 5.0;    // that a wall is moved: farther is another wall

/// The face of a room along a wall: the room, and how far to the wall's left the face lies.
struct Face {
  RoomId room = 0;
  double offset_m = 0.0;  ///< of its middle
  double shared_m = 0.0;
  double slant_m = 0.0;  ///< of its ends from each other, across the wall
};

/// Of a ring's edge, where it runs along the wall with its room on the side asked for.
std::optional<Face> face_of(const Segment2& edge, const Segment2& wall, bool is_room_left) {
  const Point2 along = (wall.b - wall.a).normalized();
  const Point2 left = left_of(wall);
  const Point2 way = edge.b - edge.a;
  const double length_m = way.norm();
  if (length_m <= 0.0) return std::nullopt;
  const double turn = std::abs(cross(along, way)) / length_m;
  if (turn > std::sin(kMostTurn_rad) || (along.dot(way) > 0.0) != is_room_left) return std::nullopt;
  const double first_m = along.dot(edge.a - wall.a);
  const double second_m = along.dot(edge.b - wall.a);
  const double from_m = std::max(0.0, std::min(first_m, second_m));
  const double to_m = std::min((wall.b - wall.a).norm(), std::max(first_m, second_m));
  if (to_m <= from_m) return std::nullopt;
  return Face{0, left.dot((edge.a + edge.b) / 2.0 - wall.a), to_m - from_m,
              std::abs(left.dot(way))};
}

/// The nearest face of a room on one side of the wall.
std::optional<Face> face_beside(const MappedBuilding& building, const Segment2& wall,
                                bool is_room_left) {
  std::optional<Face> best;
  const double least_m = kLeastShared * (wall.b - wall.a).norm();
  const auto consider = [&](RoomId room, const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      auto face = face_of({ring[i], ring[(i + 1) % ring.size()]}, wall, is_room_left);
      if (!face || face->shared_m < least_m || std::abs(face->offset_m) > kEditReach_m) continue;
      if (best && std::abs(best->offset_m) <= std::abs(face->offset_m)) continue;
      face->room = room;
      best = face;
    }
  };
  for (const PlacedOutline& outline : building.outlines) {
    consider(outline.room, outline.outline.outer);
    for (const Ring& hole : outline.outline.holes) consider(outline.room, hole);
  }
  return best;
}

Segment2 moved(const Segment2& line, const Point2& by) { return {line.a + by, line.b + by}; }

/// Of the doors in the wall between its faces.
void move_doors(const Segment2& wall, double low_m, double high_m, const Point2& by,
                MappedBuilding& building) {
  constexpr double kBeside_m = 0.1;
  for (Door& door : building.doors) {
    const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
    const Polygon in = band(wall, high_m + kBeside_m, kBeside_m - low_m, 0.0);
    if (!contains(in, middle)) continue;
    door.jambs = moved(door.jambs, by);
    door.frame_from_pivot = Pose2{by.x(), by.y(), 0.0} * door.frame_from_pivot;
    if (door.leaf) door.leaf = moved(*door.leaf, by);
  }
}

std::vector<PlanFurniture>::iterator furniture_near(MappedBuilding& building, const Point2& at) {
  auto nearest = building.furniture.end();
  double least_m = kEditReach_m;
  for (auto piece = building.furniture.begin(); piece != building.furniture.end(); ++piece) {
    const double apart_m =
        contains(piece->outline, at) ? 0.0 : distance_to_boundary(piece->outline.outer, at);
    if (apart_m > least_m || (apart_m == least_m && nearest != building.furniture.end())) continue;
    least_m = apart_m;
    nearest = piece;
  }
  return nearest;
}

/// The room in which a hole about the point is, and the hole.
std::optional<PlacedOutline> hole_at(const MappedBuilding& building, const Point2& at) {
  for (const PlacedOutline& outline : building.outlines) {
    for (const Ring& hole : outline.outline.holes) {
      if (contains(hole, at)) return PlacedOutline{outline.asr, outline.room, {hole, {}}};
    }
  }
  return std::nullopt;
}

/// The room with the most floor about an outline.
RoomId room_about(const MappedBuilding& building, const Ring& outline) {
  constexpr double kAbout_m = 0.1;
  Shapes about{{outline, {}}};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Segment2 side{outline[i], outline[(i + 1) % outline.size()]};
    if ((side.b - side.a).norm() > 0.0) about.push_back(band(side, kAbout_m, kAbout_m, kAbout_m));
  }
  const Shapes near = union_of(about);
  RoomId room = 0;
  double most_m2 = 0.0;
  for (const PlacedOutline& placed : building.outlines) {
    const double shared_m2 = overlap_area(near, {placed.outline});
    if (shared_m2 <= most_m2) continue;
    most_m2 = shared_m2;
    room = placed.room;
  }
  return room;
}

/// The part of a piece that lies farther from all walls of a room than furniture does.
double too_deep_m2(const Shapes& piece, const Shapes& room) {
  Shapes reached;
  const auto reach = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment2 side{ring[i], ring[(i + 1) % ring.size()]};
      if ((side.b - side.a).norm() <= 0.0) continue;
      reached.push_back(band(side, kDeepest_m, kDeepest_m, kDeepest_m));
    }
  };
  for (const Polygon& part : room) {
    reach(part.outer);
    for (const Ring& hole : part.holes) reach(hole);
  }
  return area_of(difference_of(piece, reached));
}

}  // namespace

Why move_wall(const Edit& edit, MappedBuilding& building) {
  const Segment2& wall = edit.line;
  if (std::abs(edit.by_m) > kLongest_m) return "a wall is moved by at most 5 m";
  const std::optional<Face> left = face_beside(building, wall, true);
  const std::optional<Face> right = face_beside(building, wall, false);
  if (!left && !right) return "no wall runs along the line that is told";
  const double by_m = edit.by_m;
  // What a face sweeps, about the told line: from where it is, all of it, to where it goes.
  const auto swept = [&](const Face& face) {
    const double from_m = face.offset_m - std::copysign(face.slant_m + kTouching_m, by_m);
    const double to_m = face.offset_m + by_m;
    return band(wall, std::max(from_m, to_m), -std::min(from_m, to_m), 0.0);
  };
  const auto reshaped = [&](const Face& face, bool is_room_left) {
    const Shapes room = shapes_of(building.outlines, face.room);
    if (is_room_left == (by_m > 0.0)) return difference_of(room, {swept(face)});
    Shapes all = room;
    all.push_back(swept(face));
    Shapes others;
    for (const PlacedOutline& outline : building.outlines) {
      const bool gives_way =
          (left && outline.room == left->room) || (right && outline.room == right->room);
      if (!gives_way) others.push_back(outline.outline);
    }
    return difference_of(union_of(all), others);
  };
  Shapes left_now;
  Shapes right_now;
  if (left) left_now = reshaped(*left, true);
  if (right) right_now = reshaped(*right, false);
  for (Shapes* now : {left ? &left_now : nullptr, right ? &right_now : nullptr}) {
    if (now == nullptr) continue;
    std::erase_if(*now, [](const Polygon& part) { return area(part) < kSliver_m2; });
    if (now->size() != 1 || area_of(*now) < kSmallestRoom_m2) {
      return "the room beside it would be cut in parts, or nothing would be left of it";
    }
  }
  if (left && right && left->room == right->room) return "one room lies on both sides of it";
  if (left) set_shapes(building, left->room, left_now);
  if (right) set_shapes(building, right->room, right_now);
  const double high_m = left ? left->offset_m : right->offset_m;
  const double low_m = right ? right->offset_m : left->offset_m;
  if (high_m > low_m) {
    building.wall_bodies.push_back(band(wall, high_m + by_m, -(low_m + by_m), 0.0));
  }
  move_doors(wall, low_m, high_m, by_m * left_of(wall), building);
  return {};
}

Why furniture_to_wall(const Edit& edit, MappedBuilding& building) {
  const auto piece = furniture_near(building, edit.at);
  if (piece == building.furniture.end()) return "no furniture is near the place";
  const Polygon body = piece->outline;
  building.furniture.erase(piece);
  const RoomId room = room_about(building, body.outer);
  if (room != 0) {
    Shapes rest = difference_of(shapes_of(building.outlines, room), {body});
    std::erase_if(rest, [](const Polygon& part) { return area(part) < kSmallestRoom_m2; });
    if (!rest.empty()) set_shapes(building, room, rest);
  }
  building.wall_bodies.push_back(body);
  return {};
}

Why wall_to_furniture(const Edit& edit, MappedBuilding& building) {
  PlanFurniture piece;
  piece.outline.outer = edit.outline;
  RoomId room = 0;
  if (const auto hole = hole_at(building, edit.at); hole && edit.outline.empty()) {
    room = hole->room;
    piece.outline = union_of({hole->outline}).front();
  } else if (edit.outline.empty()) {
    return "no piece of wall stands free there: tell its outline_m";
  } else {
    room = room_about(building, edit.outline);
    if (room == 0) return "no room lies beside the outline";
    if (!contains(Polygon{edit.outline, {}}, edit.at) &&
        distance_to_boundary(edit.outline, edit.at) > kEditReach_m) {
      return "its at_m is not in its outline_m";
    }
    piece.kind = FurnitureKind::against_wall;
  }
  Shapes floors;
  for (const PlacedOutline& outline : building.outlines) floors.push_back(outline.outline);
  const Shapes fresh = difference_of({piece.outline}, floors);
  if (area_of(fresh) < 0.5 * area(piece.outline)) return "what is there is floor already, no wall";
  Shapes all = shapes_of(building.outlines, room);
  if (too_deep_m2(fresh, all) > kSliver_m2) {
    return "it goes more than 2 m beyond the floor of room " + std::to_string(room) +
           ", and furniture is no deeper";
  }
  all.insert(all.end(), fresh.begin(), fresh.end());
  set_shapes(building, room, union_of(all));
  building.wall_bodies = difference_of(building.wall_bodies, {piece.outline});
  building.furniture.push_back(piece);
  return {};
}

}  // namespace roomatlas::edit
