// SPDX-License-Identifier: GPL-3.0-or-later
#include "floors.hpp"

#include "roomatlas/planar/heal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
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

void report_absorbed(const Absorbed& piece, const std::vector<RoomEntry>& rooms, Issues& issues) {
  const RoomId from = rooms[static_cast<std::size_t>(piece.from)].id;
  const std::string to =
      piece.to < 0 ? "unknown" : room_field(rooms[static_cast<std::size_t>(piece.to)].id);
  issues.push_back({Severity::note, "", 0, room_field(from),
                    "a piece of " + square_metres(piece.area_mm2) + " became " + to});
}

/// The area of each room: of what its outlines cover together.
std::vector<double> room_areas(const PlanarMap& map, int first_outline, const Outlines& outlines) {
  std::vector<double> room_mm2(outlines.rooms.size(), 0.0);
  const auto first = static_cast<std::size_t>(first_outline);
  for (int region = 0; region < map.region_count(); ++region) {
    int last_room = -1;  // shapes are in the order of rooms
    for (const int shape : map.covering(region)) {
      const auto outline = static_cast<std::size_t>(shape) - first;
      if (shape < first_outline || outline >= outlines.room_of_shape.size()) continue;
      const int room = outlines.room_of_shape[outline];
      if (room != last_room) room_mm2[static_cast<std::size_t>(room)] += map.area_mm2(region);
      last_room = room;
    }
  }
  return room_mm2;
}

/// An outline on the grid, before it is healed.
struct Entry {
  const PlacedOutline* outline;
  Polygon drawn_mm;
  Dropped dropped;
};

std::vector<Entry> sorted_entries(const std::vector<PlacedOutline>& outlines,
                                  const MillimetreGrid& grid) {
  std::vector<Entry> entries;
  entries.reserve(outlines.size());
  for (const PlacedOutline& outline : outlines) {
    Entry entry{&outline, {}, {}};
    entry.drawn_mm = on_grid(grid, outline.outline, &entry.dropped);
    entries.push_back(std::move(entry));
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    const auto ids = [](const Entry& e) { return std::pair(e.outline->room, e.outline->asr); };
    if (ids(a) != ids(b)) return ids(a) < ids(b);
    return ring_less(a.drawn_mm.outer, b.drawn_mm.outer);
  });
  return entries;
}

}  // namespace

Outlines outlines_of(const std::vector<PlacedOutline>& outlines, const MillimetreGrid& grid,
                     Issues& issues) {
  Outlines all;
  Issues healing;
  for (const Entry& entry : sorted_entries(outlines, grid)) {
    const AsrId asr = entry.outline->asr;
    report(asr, entry.dropped, entry.drawn_mm, issues);
    if (all.rooms.empty() || all.rooms.back().id != entry.outline->room) {
      all.rooms.push_back({entry.outline->room, {}});
    }
    std::vector<AsrId>& asrs = all.rooms.back().asrs;
    if (asrs.empty() || asrs.back() != asr) asrs.push_back(asr);
    double healed_mm2 = 0.0;
    for (Polygon& shape : healed(entry.drawn_mm, grid.fine())) {
      healed_mm2 += area(shape);
      all.shapes_mm.push_back(std::move(shape));
      all.room_of_shape.push_back(static_cast<int>(all.rooms.size()) - 1);
    }
    report_healed(asr, entry.drawn_mm, healed_mm2, healing);
  }
  issues.insert(issues.end(), healing.begin(), healing.end());
  return all;
}

Label owner(std::span<const int> covering, const std::vector<int>& room_of_shape,
            const std::vector<double>& room_mm2) {
  Label best = kUnknown;
  std::ptrdiff_t most = 0;
  const auto room_of = [&](int shape) { return room_of_shape[static_cast<std::size_t>(shape)]; };
  for (auto first = covering.begin(); first != covering.end();) {
    const int room = room_of(*first);
    const auto next =
        std::find_if(first, covering.end(), [&](int shape) { return room_of(shape) != room; });
    const std::ptrdiff_t votes = next - first;
    const bool is_smaller = best >= 0 && room_mm2[static_cast<std::size_t>(room)] <
                                             room_mm2[static_cast<std::size_t>(best)];
    if (votes > most || (votes == most && is_smaller)) best = room;
    most = std::max(most, votes);
    first = next;
  }
  return best;
}

std::vector<Label> floor_labels(const RegionMap& regions, int first_outline,
                                const Outlines& outlines, double min_part_area_mm2,
                                Issues& issues) {
  const PlanarMap& map = regions.map();
  const std::vector<double> room_mm2 = room_areas(map, first_outline, outlines);
  const int count = static_cast<int>(outlines.shapes_mm.size());
  std::vector<Label> labels;
  labels.reserve(static_cast<std::size_t>(map.region_count()));
  std::vector<int> covering;
  for (int region = 0; region < map.region_count(); ++region) {
    covering.clear();
    for (const int shape : map.covering(region)) {
      const int outline = shape - first_outline;
      if (outline >= 0 && outline < count) covering.push_back(outline);
    }
    labels.push_back(owner(covering, outlines.room_of_shape, room_mm2));
  }
  fill_pinholes(regions, kPinhole_mm2, labels);
  for (const Absorbed& piece : absorb_small_rooms(regions, min_part_area_mm2, labels)) {
    if (piece.area_mm2 >= kHealedArea_mm2) report_absorbed(piece, outlines.rooms, issues);
  }
  return labels;
}

}  // namespace roomatlas::planar
