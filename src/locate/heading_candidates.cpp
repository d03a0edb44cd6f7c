// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {
namespace {

constexpr int kBins = 360;
constexpr int kSmoothBins = 2;      // to each side: walls of sonars are a degree or two off
constexpr double kPeakShare = 0.2;  // of the best turn's; of a small wing at an angle few walls are
constexpr double kFlat = 1.25;      // a best turn that is no better than the mean tells nothing
constexpr int kFlatStepDeg = 3;     // then all turns are tried
constexpr int kMostPeaks = 16;
constexpr int kPeakHalfWidth = 4;  // degrees to each side that a peak must overtop

std::size_t bin(int degree) { return static_cast<std::size_t>((degree % kBins + kBins) % kBins); }

}  // namespace

std::vector<double> direction_histogram(const std::vector<ScanPoint>& walls) {
  std::vector<double> sharp(kBins, 0.0);
  for (const ScanPoint& wall : walls) {
    if (wall.normal.squaredNorm() == 0.0) continue;
    const double degree = degrees(std::atan2(wall.normal.y(), wall.normal.x()));
    sharp[bin(static_cast<int>(std::floor(degree)) + kBins)] += 1.0;
  }
  std::vector<double> smooth(kBins, 0.0);
  for (int at = 0; at < kBins; ++at) {
    for (int by = -kSmoothBins; by <= kSmoothBins; ++by) {
      smooth[bin(at)] += sharp[bin(at + by)] / (1.0 + std::abs(by));
    }
  }
  return smooth;
}

std::vector<double> heading_candidates(const std::vector<double>& first,
                                       const std::vector<double>& second) {
  std::vector<double> alike(kBins, 0.0);
  for (int turn = 0; turn < kBins; ++turn) {
    for (int at = 0; at < kBins; ++at) alike[bin(turn)] += first[bin(at + turn)] * second[bin(at)];
  }
  const double best = *std::max_element(alike.begin(), alike.end());
  const double mean = std::accumulate(alike.begin(), alike.end(), 0.0) / kBins;
  std::vector<int> turns;
  if (best <= kFlat * mean) {
    for (int turn = 0; turn < kBins; turn += kFlatStepDeg) turns.push_back(turn);
  } else {
    for (int turn = 0; turn < kBins; ++turn) {
      bool is_peak = alike[bin(turn)] >= kPeakShare * best;
      for (int by = 1; by <= kPeakHalfWidth; ++by) {
        is_peak = is_peak && alike[bin(turn)] > alike[bin(turn - by)] &&
                  alike[bin(turn)] >= alike[bin(turn + by)];
      }
      if (is_peak) turns.push_back(turn);
    }
    std::stable_sort(turns.begin(), turns.end(),
                     [&](int a, int b) { return alike[bin(a)] > alike[bin(b)]; });
    if (turns.size() > kMostPeaks) turns.resize(kMostPeaks);
  }
  std::vector<double> radians_of;
  radians_of.reserve(turns.size());
  for (const int turn : turns) radians_of.push_back(wrap_angle(radians(turn)));
  return radians_of;
}

}  // namespace roomatlas
