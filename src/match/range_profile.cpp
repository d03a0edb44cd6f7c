// SPDX-License-Identifier: GPL-3.0-or-later
#include "range_profile.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {

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
  const double degree = degrees(std::atan2(ray.y(), ray.x())) + 180.0;
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
