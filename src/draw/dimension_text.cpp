// SPDX-License-Identifier: GPL-3.0-or-later
#include "dimension_text.hpp"

#include "svg.hpp"
#include "text_extent.hpp"

#include "roomatlas/draw/dimensions.hpp"

#include <optional>

namespace roomatlas::drawing {
namespace {

constexpr double kAir_mm = 0.6;  // between texts, and between a text and the next tick

std::vector<DimensionText> texts_of(const std::vector<double>& stations_m, double mm_per_m) {
  std::vector<DimensionText> texts;
  const std::vector<std::int64_t> parts = centimetres(stations_m);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    DimensionText text;
    text.text = metres_text(parts[i]);
    text.middle_mm = mm_per_m * (stations_m[i] + stations_m[i + 1]) / 2.0;
    text.width_mm = text_width_mm(text.text, kDimensionText_mm, Weight::normal);
    const double part_mm = mm_per_m * (stations_m[i + 1] - stations_m[i]);
    text.is_aside = text.width_mm + 2.0 * kAir_mm > part_mm;
    texts.push_back(text);
  }
  return texts;
}

/// The shorter of the first two parts whose texts meet, both aside.
std::optional<std::size_t> crowded(const std::vector<DimensionText>& texts,
                                   const std::vector<double>& stations_m) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!texts[i].is_aside) continue;
    const bool is_near = last && texts[i].middle_mm - texts[*last].middle_mm <
                                     (texts[i].width_mm + texts[*last].width_mm) / 2.0 + kAir_mm;
    if (is_near) {
      const auto length = [&](std::size_t k) { return stations_m[k + 1] - stations_m[k]; };
      return length(i) < length(*last) ? i : *last;
    }
    last = i;
  }
  return std::nullopt;
}

/// Joins a part with the shorter of its neighbours.
void join(std::vector<double>& stations_m, std::size_t part) {
  const std::size_t parts = stations_m.size() - 1;
  const auto length = [&](std::size_t k) { return stations_m[k + 1] - stations_m[k]; };
  const bool with_next = part == 0 || (part + 1 < parts && length(part + 1) <= length(part - 1));
  stations_m.erase(stations_m.begin() + static_cast<std::ptrdiff_t>(with_next ? part + 1 : part));
}

}  // namespace

std::string metres_text(std::int64_t centimetres) {
  return fixed(static_cast<double>(centimetres) / 100.0, 2);
}

FittedChain fitted_chain(std::vector<double> stations_m, double mm_per_m) {
  FittedChain fitted{std::move(stations_m), {}};
  while (true) {
    fitted.texts = texts_of(fitted.stations_m, mm_per_m);
    const auto part = crowded(fitted.texts, fitted.stations_m);
    if (!part) return fitted;
    join(fitted.stations_m, *part);
  }
}

}  // namespace roomatlas::drawing
