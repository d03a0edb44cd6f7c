// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_extent.hpp"

#include <algorithm>

#include "font_widths.hpp"

namespace roomatlas::drawing {
namespace {

constexpr double kThousand = 1000.0;
constexpr char32_t kReplacement = 0xFFFD;

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The character that begins at the byte; goes on to the place after it. For what is no UTF-8 the
/// replacement character, which is drawn for it.
char32_t next_character(const std::string& text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  const unsigned more = first >= 0xF0U ? 3 : first >= 0xE0U ? 2 : first >= 0xC0U ? 1 : 0;
  if ((more == 0 && first >= 0x80U) || first >= 0xF8U) return kReplacement;
  char32_t code = more == 0 ? first : first & (0x3FU >> more);
  for (unsigned i = 0; i < more; ++i) {
    if (at == text.size() || !is_continuation_byte(text[at])) return kReplacement;
    code = code << 6U | (static_cast<unsigned char>(text[at++]) & 0x3FU);
  }
  return code;
}

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
  for (std::size_t at = 0; at < text.size();) {
    thousandths += width_of(next_character(text, at), runs);
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
