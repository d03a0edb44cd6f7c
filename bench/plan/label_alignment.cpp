// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_alignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomatlas/correct/correct.hpp"
#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/polyline/distance_field.hpp"

namespace roomatlas::bench {
namespace {

constexpr double kPixelsM[] = {0.054, 0.056, 0.058, 0.060, 0.062};  // where the search begins
constexpr double kFarM = 0.4;  // borders farther from any hit than this are as wrong as can be
constexpr int kMinHits = 3;
constexpr double kMinShare = 0.25;  // of a cell's beams
constexpr double kOutliers = 0.02;  // share of the cells that may lie outside of the building
constexpr int kBestStarts = 40;     // how many starts are refined; walls repeat, fewer stop early

/// How far the nearest cell is in which beams ended.
class HitDistance {
 public:
  explicit HitDistance(const ReflectionMap& counts) : frame_(counts.frame()) {
    const int margin = static_cast<int>(std::ceil(kFarM / frame_.cell_m));  // its rim counts as hit
    const CellBox seen = counts.box();
    CellMask nothing_hit(CellBox{{seen.min.x - margin, seen.min.y - margin},
                                 {seen.max.x + margin, seen.max.y + margin}});
    std::vector<double> xs;
    std::vector<double> ys;
    for_each_cell(nothing_hit.domain, [&](const Cell& cell) {
      const CellCounts count = counts.at(cell);
      const bool is_hit = count.hits >= kMinHits && count.reflected_share() >= kMinShare;
      nothing_hit.set(cell, !is_hit);
      if (!is_hit) return;
      xs.push_back(frame_.center_of(cell).x());
      ys.push_back(frame_.center_of(cell).y());
    });
    if (xs.empty()) return;
    cells_ = distance_inside(nothing_hit);
    middle_m_ = {middle_of(xs), middle_of(ys)};
  }

  /// At most kFarM. Beyond the map nothing is known, and the nearest hit is far.
  [[nodiscard]] double at_m(const Point2& point) const {
    const Cell cell = frame_.cell_of(point);
    if (!cells_.domain.contains(cell)) return kFarM;
    return std::min(kFarM, frame_.cell_m * static_cast<double>(cells_.get(cell)));
  }
  [[nodiscard]] const Point2& middle_m() const { return middle_m_; }

 private:
  static double middle_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto cut = static_cast<std::size_t>(kOutliers * static_cast<double>(values.size()));
    return (values[cut] + values[values.size() - 1 - cut]) / 2.0;
  }

  CellFrame frame_;
  Raster<float> cells_;
  Point2 middle_m_ = Point2::Zero();
};

/// Points a pixel apart along all borders.
std::vector<Point2> border_points(const FloorPlan& labels) {
  std::vector<Point2> points;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2& from = ring[i];
      const Point2 step = ring[(i + 1) % ring.size()] - from;
      const int pieces = std::max(1, static_cast<int>(std::lround(step.norm())));
      for (int k = 0; k < pieces; ++k) points.push_back(from + step * (k / double(pieces)));
    }
  };
  for (const PlanRoom& room : labels.rooms) {
    for (const Polygon& part : room.parts) {
      add(part.outer);
      for (const Ring& hole : part.holes) add(hole);
    }
  }
  return points;
}

void judge(LabelAlignment& alignment, const std::vector<Point2>& borders_px,
           const HitDistance& hits) {
  double sum_m = 0.0;
  for (const Point2& point : borders_px) sum_m += hits.at_m(alignment.building_from_picture(point));
  alignment.mean_distance_m = sum_m / static_cast<double>(borders_px.size());
}

std::vector<LabelAlignment> starts(const Point2& middle_px, const std::vector<Point2>& borders_px,
                                   const HitDistance& hits) {
  std::vector<LabelAlignment> all;
  const auto add_shifts = [&](LabelAlignment start) {
    for (double dx_m = -4.0; dx_m <= 4.01; dx_m += 0.5) {
      for (double dy_m = -1.5; dy_m <= 1.51; dy_m += 0.5) {
        start.x_m = hits.middle_m().x() + dx_m;
        start.y_m = hits.middle_m().y() + dy_m;
        judge(start, borders_px, hits);
        all.push_back(start);
      }
    }
  };
  for (const bool is_half_turned : {false, true}) {
    for (const double pixel_x_m : kPixelsM) {
      for (const double pixel_y_m : kPixelsM) {
        add_shifts({middle_px, is_half_turned, 0.0, 0.0, pixel_x_m, pixel_y_m, 0.0, 0.0});
      }
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const LabelAlignment& a, const LabelAlignment& b) {
    return a.mean_distance_m < b.mean_distance_m;
  });
  all.resize(kBestStarts);
  return all;
}

struct Direction {
  double LabelAlignment::*value;
  double step;
};

/// Goes on while a step along one of the five values makes it better; then with half the steps.
LabelAlignment refined(LabelAlignment best, const std::vector<Point2>& borders_px,
                       const HitDistance& hits) {
  std::array<Direction, 5> directions = {{{&LabelAlignment::x_m, 0.32},
                                          {&LabelAlignment::y_m, 0.32},
                                          {&LabelAlignment::pixel_x_m, 0.0016},
                                          {&LabelAlignment::pixel_y_m, 0.0016},
                                          {&LabelAlignment::angle_rad, 0.016}}};
  for (int halvings = 0; halvings < 7;) {
    bool is_better = false;
    for (const Direction& direction : directions) {
      for (const double sign : {1.0, -1.0}) {
        LabelAlignment tried = best;
        tried.*direction.value += sign * direction.step;
        judge(tried, borders_px, hits);
        if (tried.mean_distance_m >= best.mean_distance_m) continue;
        best = tried;
        is_better = true;
      }
    }
    if (is_better) continue;
    for (Direction& direction : directions) direction.step /= 2.0;
    ++halvings;
  }
  return best;
}

}  // namespace

Point2 LabelAlignment::building_from_picture(const Point2& point_px) const {
  const Point2 from_middle = (point_px - picture_middle_px) * (is_half_turned ? -1.0 : 1.0);
  const Point2 stretched(from_middle.x() * pixel_x_m, from_middle.y() * pixel_y_m);
  return Pose2{x_m, y_m, angle_rad} * stretched;
}

LabelAlignment fit_labels(const FloorPlan& labels, const AsrSource& mission,
                          const Correction& correction) {
  const BuildingEvidence evidence = gather_evidence(mission, placement_of(correction), {}, {}, {});
  const HitDistance hits(evidence.counts);
  const std::vector<Point2> borders_px = border_points(labels);
  Point2 middle_px = Point2::Zero();
  for (const Point2& point : borders_px) middle_px += point / double(borders_px.size());
  LabelAlignment best;
  best.mean_distance_m = kFarM;
  for (const LabelAlignment& start : starts(middle_px, borders_px, hits)) {
    const LabelAlignment end = refined(start, borders_px, hits);
    if (end.mean_distance_m < best.mean_distance_m) best = end;
  }
  return best;
}

FloorPlan laid(const LabelAlignment& alignment, FloorPlan labels) {
  const auto lay = [&](Ring& ring) {
    for (Point2& point : ring) point = alignment.building_from_picture(point);
  };
  for (PlanRoom& room : labels.rooms) {
    for (Polygon& part : room.parts) {
      lay(part.outer);
      for (Ring& hole : part.holes) lay(hole);
    }
  }
  return labels;
}

}  // namespace roomatlas::bench
