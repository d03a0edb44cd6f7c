// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/place_index.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kSquareM = 4.0;         // about a room: smaller files walls under many squares
constexpr double kMaxSquares = 10000.0;  // boxes of more are found from everywhere
constexpr double kFarthestM = 1e9;       // squares are numbered with 32 bits

struct Squares {
  std::int32_t min_x = 0;
  std::int32_t min_y = 0;
  std::int32_t max_x = 0;
  std::int32_t max_y = 0;
};

/// Nothing for a box that is not finite or too large.
std::optional<Squares> squares_of(const Box2& box) {
  const bool is_near =
      box.min.cwiseAbs().maxCoeff() < kFarthestM && box.max.cwiseAbs().maxCoeff() < kFarthestM;
  if (!box.min.allFinite() || !box.max.allFinite() || !is_near) return std::nullopt;
  const Point2 low = (box.min / kSquareM).array().floor();
  const Point2 high = (box.max / kSquareM).array().floor();
  if ((high - low + Point2::Ones()).prod() > kMaxSquares) return std::nullopt;
  return Squares{static_cast<std::int32_t>(low.x()), static_cast<std::int32_t>(low.y()),
                 static_cast<std::int32_t>(high.x()), static_cast<std::int32_t>(high.y())};
}

template <typename Visit>
void for_each_square(const Squares& squares, Visit visit) {
  for (std::int32_t x = squares.min_x; x <= squares.max_x; ++x) {
    for (std::int32_t y = squares.min_y; y <= squares.max_y; ++y) {
      visit((static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32U) |
            static_cast<std::uint32_t>(y));
    }
  }
}

}  // namespace

void PlaceIndex::add(std::size_t item, const Box2& box) {
  if (box.empty()) return;
  all_.push_back(item);
  const auto squares = squares_of(box);
  if (!squares) {
    everywhere_.push_back(item);
    return;
  }
  for_each_square(*squares, [&](std::uint64_t key) { items_[key].push_back(item); });
}

std::vector<std::size_t> PlaceIndex::near(const Box2& box) const {
  if (box.empty()) return {};
  const auto squares = squares_of(box);
  std::vector<std::size_t> found = squares ? everywhere_ : all_;
  if (squares) {
    for_each_square(*squares, [&](std::uint64_t key) {
      const auto at = items_.find(key);
      if (at != items_.end()) found.insert(found.end(), at->second.begin(), at->second.end());
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Box2 box_around(const Point2& point, double reach_m) {
  return {point - Point2::Constant(reach_m), point + Point2::Constant(reach_m)};
}

}  // namespace roomatlas
