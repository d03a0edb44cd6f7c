// SPDX-License-Identifier: GPL-3.0-or-later
#include "silent_walls.hpp"

#include <cmath>

#include "random_stream.hpp"

namespace roomatlas {
namespace {

constexpr double kStretchM = 2.0;     // side of a square: about a window or a cupboard
constexpr std::int64_t kPeriod = 64;  // squares after which the pattern is the same again, so that
                                      // it is drawn once

}  // namespace

SilentWalls::SilentWalls(double share, std::uint64_t seed) : share_(share) {
  if (share_ <= 0.0) return;
  RandomStream random(seed, "silent walls");
  origin_.x() = kStretchM * random.uniform();
  origin_.y() = kStretchM * random.uniform();
  for (std::int64_t i = 0; i < kPeriod * kPeriod; ++i) draws_.push_back(random.uniform());
}

WallSurface SilentWalls::at(const Point2& point) const {
  if (share_ <= 0.0) return WallSurface::plain;
  const auto place = [&](int axis) {
    const auto square =
        static_cast<std::int64_t>(std::floor((point[axis] - origin_[axis]) / kStretchM));
    return static_cast<std::size_t>((square % kPeriod + kPeriod) % kPeriod);
  };
  const double draw = draws_[place(1) * static_cast<std::size_t>(kPeriod) + place(0)];
  if (draw >= share_) return WallSurface::plain;
  return draw < share_ / 2.0 ? WallSurface::black : WallSurface::glass;
}

}  // namespace roomatlas
