// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// How far a sweep saw in each direction.
class RangeProfile {
 public:
  static constexpr std::size_t kBins = 360;

  /// A place in what the sweep saw.
  enum class Place { unknown, through, there, behind };

  /// How much nearer or farther still is there.
  struct Tolerance {
    double fixed_m = 0.0;
    double share = 0.0;  ///< of the range: headings are wrong
  };

  /// @param eye where the sweep was taken, and `hits` what it hit, metres in one frame
  RangeProfile(const Point2& eye, std::span<const Point2> hits);

  [[nodiscard]] Place place_of(const Point2& at, const Tolerance& tolerance) const;
  /// The direction in which a place lies, [0, kBins).
  [[nodiscard]] std::size_t bin_of(const Point2& at) const;

 private:
  struct Bin {
    float least_m = 0.0F;
    float largest_m = 0.0F;  ///< 0: nothing was seen there
    void add(const Bin& other);
  };
  Point2 eye_;
  std::array<Bin, kBins> bins_{};  ///< each with what its neighbours saw
};

}  // namespace roomatlas
