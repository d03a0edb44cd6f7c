// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace roomatlas::drawing {

constexpr double kDimensionText_mm = 2.0;  // letters of dimensions

/// "4.26" for 426.
[[nodiscard]] std::string metres_text(std::int64_t centimetres);

/// A length and where it stands along its chain, in millimetres on paper.
struct DimensionText {
  std::string text;
  double middle_mm = 0.0;
  double width_mm = 0.0;
  bool is_aside = false;  ///< on the other side of the line, since its part is too short for it
};

struct FittedChain {
  std::vector<double> stations_m;    ///< those that are drawn
  std::vector<DimensionText> texts;  ///< one for each part
};

/// The chain as it can be written at a scale: texts that are wider than their part stand aside;
/// where two of these would meet, a part is joined with the shorter of its neighbours. The parts
/// that are left add up to the same total.
[[nodiscard]] FittedChain fitted_chain(std::vector<double> stations_m, double mm_per_m);

}  // namespace roomatlas::drawing
