// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/wall_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "roomatlas/core/for_each_index.hpp"
#include "slanted_faces.hpp"
#include "sonar_faces.hpp"
#include "straight_runs.hpp"
#include "trim_faces.hpp"

namespace roomatlas {
namespace {

constexpr double kQuarter = kPi / 2.0;
constexpr int kDirectionBins = 180;   // of half a degree
constexpr int kSmoothBins = 2;        // to each side
constexpr double kMostWeight = 5.0;   // of one surface: standing still must not decide
constexpr double kNearFace_m = 0.10;  // surfaces this near a face are explained by it ...
constexpr double kNearFace_rad = 25.0 * kPi / 180.0;  // ... when they look its way
constexpr double kBeyondEnds_m = 0.1;
constexpr double kWingApart_rad = 10.0 * kPi / 180.0;  // from the main direction
constexpr double kWingWidth_rad = 3.0 * kPi / 180.0;
constexpr std::size_t kFewest = 100;   // surfaces that may have a direction
constexpr double kLaserBand_m = 0.04;  // off a wall's line

/// @param normal, along the face's
bool explains(const WallFace& face, const Point2& normal, const Point2& along,
              const SurfacePoint& surface) {
  if (std::abs(wrap_angle(surface.normal_rad - face.normal_rad)) >= kNearFace_rad) return false;
  if (std::abs(surface.at.dot(normal) - face.offset_m) >= kNearFace_m) return false;
  const double along_m = surface.at.dot(along);
  return along_m > face.low_m() - kBeyondEnds_m && along_m < face.high_m() + kBeyondEnds_m;
}

void drop_explained(const std::vector<WallFace>& faces, std::vector<SurfacePoint>& surfaces) {
  std::vector<std::pair<Point2, Point2>> axes;
  for (const WallFace& face : faces) axes.emplace_back(face.normal(), face.along());
  std::erase_if(surfaces, [&](const SurfacePoint& surface) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (explains(faces[i], axes[i].first, axes[i].second, surface)) return true;
    }
    return false;
  });
}

void append(std::vector<WallFace> more, std::vector<WallFace>& faces) {
  faces.insert(faces.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

/// Faces that follow a direction of the building.
std::vector<WallFace> regular(std::vector<WallFace> faces) {
  for (WallFace& face : faces) face.is_regular = true;
  return faces;
}

std::vector<WallFace> faces_along(double direction_rad, const std::vector<SurfacePoint>& surfaces,
                                  const RunOptions& runs, double max_turn_rad, int jobs) {
  std::vector<WallFace> faces;
  for (auto& of_quarter : results_of<std::vector<WallFace>>(4, jobs, [&](std::size_t quarter) {
         const double normal_rad =
             wrap_angle(direction_rad + static_cast<double>(quarter) * kQuarter);
         return straight_runs(looking(surfaces, normal_rad, max_turn_rad), normal_rad, runs);
       })) {
    append(regular(std::move(of_quarter)), faces);
  }
  return faces;
}

std::vector<WallFace> laser_faces(std::vector<SurfacePoint> surfaces,
                                  const WallFaceOptions& options, int jobs) {
  if (surfaces.empty()) return {};
  const double max_turn_rad = options.max_turn_deg * kPi / 180.0;
  RunOptions runs{options.bin_along_m, kLaserBand_m,          static_cast<double>(options.min_hits),
                  options.max_gap_m,   options.min_support_m, true};
  const double main_rad = main_direction_rad(surfaces);
  const auto all = static_cast<double>(surfaces.size());
  std::vector<WallFace> faces = faces_along(main_rad, surfaces, runs, max_turn_rad, jobs);
  drop_explained(faces, surfaces);
  runs.min_support_m = options.min_wing_support_m;
  for (int wing = 0; wing < options.max_wings && surfaces.size() >= kFewest; ++wing) {
    const double wing_rad = main_direction_rad(surfaces);
    const auto along = std::count_if(surfaces.begin(), surfaces.end(), [&](const auto& surface) {
      return std::abs(wrap_quarter(surface.normal_rad - wing_rad)) < kWingWidth_rad;
    });
    if (static_cast<double>(along) < options.wing_share * all) break;
    if (std::abs(wrap_quarter(wing_rad - main_rad)) < kWingApart_rad) break;
    std::vector<WallFace> of_wing = faces_along(wing_rad, surfaces, runs, max_turn_rad, jobs);
    if (of_wing.empty()) break;
    drop_explained(of_wing, surfaces);
    append(std::move(of_wing), faces);
  }
  append(slanted_faces(surfaces, options.min_slanted_support_m), faces);
  return faces;
}

/// One line from all faces that nearly share one.
struct Line {
  std::vector<const WallFace*> faces;
  double offset_m = 0.0;
  Interval reach;
};

WallFace joined(const Line& line) {
  WallFace face = *line.faces.front();
  face.offset_m = line.offset_m;
  std::vector<Interval> all;
  for (const WallFace* one : line.faces) all.insert(all.end(), one->seen.begin(), one->seen.end());
  std::sort(all.begin(), all.end(),
            [](const Interval& a, const Interval& b) { return a.low_m < b.low_m; });
  face.seen.clear();
  for (const Interval& one : all) {
    if (!face.seen.empty() && one.low_m <= face.seen.back().high_m + kBeyondEnds_m / 2.0) {
      face.seen.back().high_m = std::max(face.seen.back().high_m, one.high_m);
    } else {
      face.seen.push_back(one);
    }
  }
  return face;
}

/// Adds a face to the first line that it nearly shares, or makes one of its own.
void add_to(std::vector<Line>& lines, const WallFace& face, const WallFaceOptions& options) {
  for (Line& line : lines) {
    const bool is_near = std::abs(face.offset_m - line.offset_m) <= options.snap_m &&
                         face.low_m() < line.reach.high_m + options.snap_gap_m &&
                         face.high_m() > line.reach.low_m - options.snap_gap_m;
    if (!is_near) continue;
    line.faces.push_back(&face);
    double support_m = 0.0;
    line.offset_m = 0.0;
    for (const WallFace* one : line.faces) {
      line.offset_m += one->support_m() * one->offset_m;
      support_m += one->support_m();
    }
    line.offset_m /= support_m;
    line.reach = {std::min(line.reach.low_m, face.low_m()),
                  std::max(line.reach.high_m, face.high_m())};
    return;
  }
  lines.push_back({{&face}, face.offset_m, {face.low_m(), face.high_m()}});
}

/// Faces of one direction and side that nearly share a line become one.
std::vector<WallFace> snapped(const std::vector<WallFace>& faces, const WallFaceOptions& options) {
  std::vector<double> directions;
  for (const WallFace& face : faces) {
    if (!face.is_regular) continue;
    if (std::find(directions.begin(), directions.end(), face.normal_rad) == directions.end()) {
      directions.push_back(face.normal_rad);
    }
  }
  std::vector<WallFace> result;
  for (const double normal_rad : directions) {
    std::vector<const WallFace*> alike;
    for (const WallFace& face : faces) {
      if (face.is_regular && face.normal_rad == normal_rad) alike.push_back(&face);
    }
    std::stable_sort(alike.begin(), alike.end(), [](const WallFace* a, const WallFace* b) {
      return a->support_m() > b->support_m();
    });
    std::vector<Line> lines;
    for (const WallFace* face : alike) add_to(lines, *face, options);
    for (const Line& line : lines) result.push_back(joined(line));
  }
  for (const WallFace& face : faces) {
    if (!face.is_regular) result.push_back(face);
  }
  return result;
}

}  // namespace

double WallFace::support_m() const {
  double sum_m = 0.0;
  for (const Interval& stretch : seen) sum_m += stretch.length_m();
  return sum_m;
}

double main_direction_rad(const std::vector<SurfacePoint>& surfaces) {
  std::vector<double> bins(kDirectionBins, 0.0);
  for (const SurfacePoint& surface : surfaces) {
    const double turns = surface.normal_rad / kQuarter;
    const auto bin = static_cast<std::size_t>((turns - std::floor(turns)) * kDirectionBins);
    bins[bin % kDirectionBins] += std::min(surface.weight, kMostWeight);
  }
  int peak = 0;
  double most = -1.0;
  for (int bin = 0; bin < kDirectionBins; ++bin) {
    double sum = 0.0;
    for (int off = -kSmoothBins; off <= kSmoothBins; ++off) {
      sum += bins[static_cast<std::size_t>((bin + off + kDirectionBins) % kDirectionBins)];
    }
    if (sum > most) {
      most = sum;
      peak = bin;
    }
  }
  double center_rad = (peak + 0.5) * kQuarter / kDirectionBins;
  for (const double within_deg : {4.0, 2.0}) {
    double sum = 0.0;
    double weights = 0.0;
    for (const SurfacePoint& surface : surfaces) {
      const double off_rad = wrap_quarter(surface.normal_rad - center_rad);
      if (std::abs(off_rad) >= within_deg * kPi / 180.0) continue;
      const double weight = std::min(surface.weight, kMostWeight);
      sum += weight * off_rad;
      weights += weight;
    }
    if (weights > 0.0) center_rad += sum / weights;
  }
  return center_rad - kQuarter * std::floor(center_rad / kQuarter);
}

std::vector<WallFace> find_wall_faces(const BuildingEvidence& evidence,
                                      const WallFaceOptions& options, int jobs) {
  if (evidence.kind == SensorKind::laser) {
    return snapped(laser_faces(evidence.surfaces, options, jobs), options);
  }
  std::vector<WallFace> faces = snapped(sonar_faces(evidence, options, jobs), options);
  trim_at_corners(evidence.counts, faces);
  return faces;
}

}  // namespace roomatlas
