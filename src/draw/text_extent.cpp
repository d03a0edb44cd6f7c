// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_extent.hpp"

#include <cairo.h>

#include <memory>

namespace roomatlas::drawing {
namespace {

constexpr double kMeasuredSize = 1000.0;  // large, so that no rounding to pixels is left

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

double text_width_mm(const std::string& text, double size_mm, Weight weight) {
  using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
  using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy);
  const Context context(cairo_create(surface.get()), cairo_destroy);
  cairo_select_font_face(
      context.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
      weight == Weight::bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context.get(), kMeasuredSize);
  cairo_text_extents_t extents{};
  cairo_text_extents(context.get(), text.c_str(), &extents);
  return extents.x_advance * size_mm / kMeasuredSize;
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
