// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_chords.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "passage.hpp"

namespace roomatlas {
namespace {

constexpr double kBesideM = 0.05;     // the ray runs this far behind the face, and free before it
constexpr double kSampleM = 0.025;    // between samples of the ray
constexpr double kSkipM = 0.1;        // the corner itself may be rounded
constexpr double kMinLengthM = 0.35;  // of what is free
constexpr double kMaxLengthM = 6.0;   // longer openings part nothing
constexpr double kShortM = 2.2;       // a door's width: one of two kinds of support will do
constexpr double kShortNear = 0.4;    // on both sides, near the jambs ...
constexpr double kShortSum = 0.8;     // ... or of both together, farther off
constexpr double kLongSum = 1.0;      // wider openings need walls ...
constexpr double kLongLeast = 0.3;    // ... on both sides
constexpr double kSameM = 0.4;        // chords whose ends lie this near are one
constexpr double kAlongM = 0.3;       // from a chord to a gap beside it: posts stand out so far
constexpr double kEndShare = 0.05;    // crossings this near to an end are touches
constexpr double kBeyondM = 0.1;      // a cut reaches this far into the walls

std::optional<WallChord> chord_from(const OpenFloor& floor, const Point2& end, const Point2& along,
                                    const Point2& into_floor) {
  const Point2 start = end - kBesideM * into_floor;
  const int most = static_cast<int>(kMaxLengthM / kSampleM);
  for (int k = static_cast<int>(kSkipM / kSampleM); k <= most; ++k) {
    const Point2 off = k * kSampleM * along;
    if (floor.is_open(start + off) && floor.is_open(end + off + kBesideM * into_floor)) continue;
    if (k * kSampleM < kMinLengthM) return std::nullopt;
    WallChord chord;
    chord.line = {start, start + off};
    chord.at_a = wall_support(floor, chord.line.a, -along);
    chord.at_b = wall_support(floor, chord.line.b, along);
    return chord;
  }
  return std::nullopt;
}

bool is_supported(const WallChord& chord) {
  const double sum = chord.at_a.middle + chord.at_b.middle;
  if (chord.length_m() <= kShortM) {
    return std::min(chord.at_a.near, chord.at_b.near) >= kShortNear || sum >= kShortSum;
  }
  return sum >= kLongSum && std::min(chord.at_a.middle, chord.at_b.middle) >= kLongLeast;
}

double strength(const WallChord& chord) {
  return chord.at_a.middle + chord.at_b.middle +
         0.5 * std::min(chord.at_a.middle, chord.at_b.middle) - 0.25 * chord.length_m();
}

bool is_same(const Segment2& a, const Segment2& b) {
  const auto apart = [](const Point2& p, const Point2& q) { return (p - q).norm(); };
  return std::max(apart(a.a, b.a), apart(a.b, b.b)) < kSameM ||
         std::max(apart(a.a, b.b), apart(a.b, b.a)) < kSameM;
}

bool crosses(const Segment2& a, const Segment2& b) {
  const auto shortened = [](const Segment2& line) {
    const Point2 way = line.b - line.a;
    return Segment2{line.a + kEndShare * way, line.b - kEndShare * way};
  };
  return crossing_fraction(shortened(a), shortened(b)).has_value();
}

/// Whether a chord runs along a wall with a gap that is known: from what stands out of the wall on
/// one side of the gap to the like on the other.
bool runs_along(const Segment2& chord, const Segment2& gap) {
  return distance(chord, gap.a) < kAlongM && distance(chord, gap.b) < kAlongM;
}

}  // namespace

std::vector<WallChord> find_wall_chords(const OpenFloor& floor, const std::vector<FloorSide>& faces,
                                        const std::vector<Segment2>& known) {
  std::vector<WallChord> found;
  for (const FloorSide& face : faces) {
    const Point2 along = direction(face.heading_rad);
    const Point2 into_floor(-along.y(), along.x());
    for (const auto& [end, away] : {std::pair{face.ends.b, along}, {face.ends.a, Point2(-along)}}) {
      const std::optional<WallChord> chord = chord_from(floor, end, away, into_floor);
      if (!chord || !is_supported(*chord)) continue;
      if (!is_across_corridor(passage_at(floor, chord->line))) found.push_back(*chord);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const WallChord& a, const WallChord& b) {
    return strength(a) > strength(b);
  });
  std::vector<WallChord> all;
  for (const Segment2& gap : known) {
    const Point2 along = (gap.b - gap.a).normalized();
    all.push_back(
        {gap, wall_support(floor, gap.a, -along), wall_support(floor, gap.b, along), true});
  }
  for (const WallChord& chord : found) {
    if (std::none_of(known.begin(), known.end(),
                     [&](const Segment2& gap) { return runs_along(chord.line, gap); })) {
      all.push_back(chord);
    }
  }
  std::vector<WallChord> chords;
  for (const WallChord& chord : all) {
    if (std::none_of(chords.begin(), chords.end(), [&](const WallChord& stronger) {
          return is_same(chord.line, stronger.line) || crosses(chord.line, stronger.line);
        })) {
      chords.push_back(chord);
    }
  }
  return chords;
}

ChordCells::ChordCells(const OpenFloor& floor, const std::vector<WallChord>& chords)
    : domain_(floor.open.domain) {
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const Point2 beyond = kBeyondM * (chords[i].line.b - chords[i].line.a).normalized();
    for_each_cell_on_line(floor.frame.cell_of(chords[i].line.a - beyond),
                          floor.frame.cell_of(chords[i].line.b + beyond), [&](const Cell& cell) {
                            if (floor.open.at(cell))
                              chord_[domain_.find(cell)] = static_cast<std::int32_t>(i) + 1;
                            return true;
                          });
  }
}

CellMask ChordCells::cut_out_of(CellMask mask) const {
  for (const auto& [cell, chord] : chord_) mask.bits[cell] = 0;
  return mask;
}

}  // namespace roomatlas
