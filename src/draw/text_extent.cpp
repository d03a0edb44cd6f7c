// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_extent.hpp"

#include <algorithm>
#include <string_view>

#include "font_widths.hpp"
#include "roomatlas/core/utf8.hpp"

namespace roomatlas::drawing {
namespace {

constexpr double kThousand = 1000.0;
constexpr char32_t kReplacement = 0xFFFD;  // is drawn for each byte that is no UTF-8

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

double width_of(char32_t character, std::span<const WidthRun> runs) {
  const auto next =
      std::upper_bound(runs.begin(), runs.end(), character,
                       [](char32_t code, const WidthRun& run) { return code < run.first; });
  return next == runs.begin() ? 0.0 : std::prev(next)->width;
}

}  // namespace

double text_width_mm(const std::string& text, double size_mm, Weight weight) {
  const std::span<const WidthRun> runs = weight == Weight::bold ? bold_widths() : normal_widths();
  double thousandths = 0.0;
  for (std::string_view left = text; !left.empty();) {
    const Utf8Character character = first_character(left);
    thousandths += width_of(character.is_whole ? character.code : kReplacement, runs);
    left.remove_prefix(character.bytes);
  }
  return thousandths * size_mm / kThousand;
}

std::string shortened(const std::string& text, double width_mm, double size_mm, Weight weight) {
  if (text_width_mm(text, size_mm, weight) <= width_mm) return text;
  std::string start = text;
  while (!start.empty()) {
    while (!start.empty() && is_continuation_byte(start.back())) start.pop_back();
    if (!start.empty()) start.pop_back();
    std::string candidate = start + "\u2026";
    if (text_width_mm(candidate, size_mm, weight) <= width_mm) return candidate;
  }
  return {};
}

}  // namespace roomatlas::drawing
