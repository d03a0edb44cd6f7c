// SPDX-License-Identifier: GPL-3.0-or-later
#include "floors.hpp"

#include "labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

namespace roomatlas::planar {
namespace {

constexpr double kSquareMillimetres = 1e6;  // in a square metre
constexpr double kHealedArea_mm2 = 1e3;     // less is not worth a message
constexpr double kPinhole_mm2 = 2e4;        // a hole of 14 cm x 14 cm is no structure

std::string square_metres(double area_mm2) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f m2", area_mm2 / kSquareMillimetres);
  return text;
}

std::string asr_field(AsrId asr) { return "outline of ASR " + std::to_string(asr); }
std::string room_field(RoomId room) { return "room " + std::to_string(room); }

bool ring_less(const Ring& a, const Ring& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](const Point2& p, const Point2& q) {
                                        return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
                                      });
}

void report(AsrId asr, const Dropped& dropped, const Polygon& shape_mm, Issues& issues) {
  if (dropped.implausible > 0) {
    issues.push_back({Severity::warning, "", 0, asr_field(asr),
                      std::to_string(dropped.implausible) +
                          " vertices are not finite or beyond 10000 km: left out"});
  }
  if (dropped.repeated > 0) {
    issues.push_back({Severity::note, "", 0, asr_field(asr),
                      std::to_string(dropped.repeated) + " repeated vertices left out"});
  }
  if (shape_mm.outer.size() < 3) {
    issues.push_back({Severity::warning, "", 0, asr_field(asr),
                      "fewer than three distinct vertices: this visit has no floor"});
  }
}

/// Area under the non-zero rule of each shape, and of each room's shapes together.
struct Areas {
  std::vector<double> shape_mm2;
  std::vector<double> room_mm2;
};

Areas areas_of(const PlanarMap& map, const std::vector<int>& room_of_shape, std::size_t rooms) {
  Areas areas{std::vector<double>(room_of_shape.size(), 0.0), std::vector<double>(rooms, 0.0)};
  for (int region = 0; region < map.region_count(); ++region) {
    int last_room = -1;  // shapes are in the order of rooms
    for (const int shape : map.covering(region)) {
      const int room = room_of_shape[static_cast<std::size_t>(shape)];
      areas.shape_mm2[static_cast<std::size_t>(shape)] += map.area_mm2(region);
      if (room != last_room) areas.room_mm2[static_cast<std::size_t>(room)] += map.area_mm2(region);
      last_room = room;
    }
  }
  return areas;
}

/// The room with most outlines over the region; a tie goes to the smaller room.
Label owner(std::span<const int> covering, const std::vector<int>& room_of_shape,
            const std::vector<double>& room_mm2) {
  std::map<int, int> votes;
  for (const int shape : covering) ++votes[room_of_shape[static_cast<std::size_t>(shape)]];
  Label best = kUnknown;
  int most = 0;
  for (const auto& [room, count] : votes) {
    const bool is_smaller = best >= 0 && room_mm2[static_cast<std::size_t>(room)] <
                                             room_mm2[static_cast<std::size_t>(best)];
    if (count > most || (count == most && is_smaller)) best = room;
    most = std::max(most, count);
  }
  return best;
}

void report_healed(AsrId asr, const Polygon& shape_mm, double healed_mm2, Issues& issues) {
  const double drawn_mm2 = signed_area(shape_mm.outer);
  if (drawn_mm2 < 0.0 && std::abs(-drawn_mm2 - healed_mm2) < kHealedArea_mm2) {
    issues.push_back({Severity::note, "", 0, asr_field(asr), "runs clockwise: reversed"});
  } else if (shape_mm.holes.empty() &&
             std::abs(std::abs(drawn_mm2) - healed_mm2) >= kHealedArea_mm2) {
    constexpr double kHarmlessShare = 0.01;  // a spike; a lobe of the room is another matter
    const double changed_mm2 = std::abs(std::abs(drawn_mm2) - healed_mm2);
    const bool is_harmless = changed_mm2 < kHarmlessShare * healed_mm2;
    issues.push_back({is_harmless ? Severity::note : Severity::warning, "", 0, asr_field(asr),
                      "crosses itself: its area counts as " + square_metres(healed_mm2) +
                          " under the non-zero rule, not " + square_metres(std::abs(drawn_mm2))});
  }
}

void report_absorbed(const Absorbed& piece, const std::vector<RoomOutlines>& rooms,
                     Issues& issues) {
  const RoomId from = rooms[static_cast<std::size_t>(piece.from)].id;
  const std::string to =
      piece.to < 0 ? "unknown" : room_field(rooms[static_cast<std::size_t>(piece.to)].id);
  issues.push_back({Severity::note, "", 0, room_field(from),
                    "a piece of " + square_metres(piece.area_mm2) + " became " + to});
}

}  // namespace

std::vector<RoomOutlines> room_outlines(const std::vector<PlacedOutline>& outlines,
                                        const MillimetreGrid& grid, Issues& issues) {
  struct Entry {
    const PlacedOutline* outline;
    Polygon shape_mm;
    Dropped dropped;
  };
  std::vector<Entry> entries;
  for (const PlacedOutline& outline : outlines) {
    Entry entry{&outline, {}, {}};
    entry.shape_mm = on_grid(grid, outline.outline, &entry.dropped);
    entries.push_back(std::move(entry));
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    const auto ids = [](const Entry& e) { return std::pair(e.outline->room, e.outline->asr); };
    if (ids(a) != ids(b)) return ids(a) < ids(b);
    return ring_less(a.shape_mm.outer, b.shape_mm.outer);
  });
  std::vector<RoomOutlines> rooms;
  for (Entry& entry : entries) {
    const AsrId asr = entry.outline->asr;
    report(asr, entry.dropped, entry.shape_mm, issues);
    if (rooms.empty() || rooms.back().id != entry.outline->room) {
      rooms.push_back({entry.outline->room, {}, {}, {}});
    }
    RoomOutlines& room = rooms.back();
    if (room.asrs.empty() || room.asrs.back() != asr) room.asrs.push_back(asr);
    room.shapes_mm.push_back(std::move(entry.shape_mm));
    room.shape_asrs.push_back(asr);
  }
  return rooms;
}

std::vector<std::vector<Polygon>> floors_of(const std::vector<RoomOutlines>& rooms,
                                            double min_part_area_mm2, Issues& issues) {
  std::vector<Polygon> shapes_mm;
  std::vector<int> room_of_shape;
  std::vector<AsrId> asrs;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    shapes_mm.insert(shapes_mm.end(), rooms[r].shapes_mm.begin(), rooms[r].shapes_mm.end());
    asrs.insert(asrs.end(), rooms[r].shape_asrs.begin(), rooms[r].shape_asrs.end());
    room_of_shape.resize(shapes_mm.size(), static_cast<int>(r));
  }
  const PlanarMap map(shapes_mm);
  const Areas areas = areas_of(map, room_of_shape, rooms.size());
  for (std::size_t s = 0; s < shapes_mm.size(); ++s) {
    report_healed(asrs[s], shapes_mm[s], areas.shape_mm2[s], issues);
  }
  std::vector<Label> labels;
  for (int region = 0; region < map.region_count(); ++region) {
    labels.push_back(owner(map.covering(region), room_of_shape, areas.room_mm2));
  }
  fill_pinholes(map, kPinhole_mm2, labels);
  for (const Absorbed& piece : absorb_small_rooms(map, min_part_area_mm2, labels)) {
    if (piece.area_mm2 >= kHealedArea_mm2) report_absorbed(piece, rooms, issues);
  }
  std::vector<std::vector<Polygon>> floors_mm = map.trace(labels, static_cast<int>(rooms.size()));
  for (auto& parts : floors_mm) {
    for (Polygon& part : parts) part = rounded(part);
    std::erase_if(parts, [](const Polygon& part) { return part.outer.size() < 3; });
  }
  return floors_mm;
}

}  // namespace roomatlas::planar
