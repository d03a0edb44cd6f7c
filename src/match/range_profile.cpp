// SPDX-License-Identifier: GPL-3.0-or-later
#include "range_profile.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/core/floored.hpp"

namespace roomatlas {
namespace {

constexpr double kNearError_deg = 0.01;  // of the direction below; measured: 0.005

/// The direction of a ray within `kNearError_deg`, (-180, 180], or none at its origin. An odd
/// polynomial of the slope, fitted to the least largest error over the first octant; the others
/// are its images. Millions of points are asked which degree they lie in, and most lie well in it.
double near_direction_deg(const Point2& ray) {
  const double x = std::abs(ray.x());
  const double y = std::abs(ray.y());
  const double slope = std::min(x, y) / std::max(x, y);
  const double square = slope * slope;
  double degree =
      slope * (57.25073 + square * (-18.40197 + square * (8.38033 + square * -2.23376)));
  if (y > x) degree = 90.0 - degree;
  if (ray.x() < 0.0) degree = 180.0 - degree;
  return ray.y() < 0.0 ? -degree : degree;
}

}  // namespace

void RangeProfile::Bin::add(const Bin& other) {
  if (other.largest_m <= 0.0F) return;
  least_m = largest_m > 0.0F ? std::min(least_m, other.least_m) : other.least_m;
  largest_m = std::max(largest_m, other.largest_m);
}

RangeProfile::RangeProfile(const Point2& eye, std::span<const Point2> hits) : eye_(eye) {
  std::array<Bin, kBins> own{};
  for (const Point2& hit : hits) {
    const auto range_m = static_cast<float>((hit - eye).norm());
    own[bin_of(hit)].add({range_m, range_m});
  }
  // a direction between two beams, and one that an error of the heading takes for the next
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    bins_[bin] = own[bin];
    bins_[bin].add(own[(bin + 1) % kBins]);
    bins_[bin].add(own[(bin + kBins - 1) % kBins]);
  }
}

std::size_t RangeProfile::bin_of(const Point2& at) const {
  const Point2 ray = at - eye_;
  double degree = near_direction_deg(ray) + 180.0;
  const double beyond_deg = degree - static_cast<double>(floored(degree));
  const bool is_clear = beyond_deg > kNearError_deg && beyond_deg < 1.0 - kNearError_deg;
  if (!is_clear) degree = degrees(std::atan2(ray.y(), ray.x())) + 180.0;
  return static_cast<std::size_t>(std::clamp(degree, 0.0, kBins - 1.0));
}

RangeProfile::Place RangeProfile::place_of(const Point2& at, const Tolerance& tolerance) const {
  const Bin& seen = bins_[bin_of(at)];
  if (seen.largest_m <= 0.0F) return Place::unknown;
  const double range_m = (at - eye_).norm();
  const double tolerance_m = tolerance.fixed_m + tolerance.share * range_m;
  if (range_m < seen.least_m - tolerance_m) return Place::through;
  return range_m <= seen.largest_m + tolerance_m ? Place::there : Place::behind;
}

}  // namespace roomatlas
