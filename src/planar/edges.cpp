// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/planar/edges.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace roomatlas::planar {
namespace {

constexpr std::size_t kMinSlots = 16;  // of a hash table, so that an empty one can be asked

}  // namespace

Point2 on_fine_grid(const Point2& point_mm, double fine) {
  return {std::nearbyint(point_mm.x() * fine) / fine + 0.0,  // + 0.0: no negative zero
          std::nearbyint(point_mm.y() * fine) / fine + 0.0};
}

PointNumbers::PointNumbers(std::vector<Point2>& points_mm, std::size_t expected)
    : points_(points_mm), slots_(std::bit_ceil(2 * expected + kMinSlots), -1) {
  for (std::size_t i = 0; i < points_.size(); ++i)
    slots_[slot_of(points_[i])] = static_cast<int>(i);
}

/// Where the point's number is or belongs: open addressing with linear probing.
std::size_t PointNumbers::slot_of(const Point2& point_mm) const {
  std::uint64_t hash = std::bit_cast<std::uint64_t>(point_mm.x()) * 0x9e3779b97f4a7c15U;
  hash = (hash ^ (hash >> 29U)) + std::bit_cast<std::uint64_t>(point_mm.y());
  hash *= 0xbf58476d1ce4e5b9U;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = (hash ^ (hash >> 32U)) & mask;
  while (slots_[slot] >= 0 && points_[static_cast<std::size_t>(slots_[slot])] != point_mm) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void PointNumbers::grow() {
  slots_.assign(slots_.size() * 2, -1);
  for (std::size_t i = 0; i < points_.size(); ++i)
    slots_[slot_of(points_[i])] = static_cast<int>(i);
}

int PointNumbers::number_of(const Point2& point_mm) {
  const std::size_t slot = slot_of(point_mm);
  if (slots_[slot] >= 0) return slots_[slot];
  const int number = static_cast<int>(points_.size());
  slots_[slot] = number;
  points_.push_back(point_mm);
  if (2 * points_.size() > slots_.size()) grow();
  return number;
}

}  // namespace roomatlas::planar
