// SPDX-License-Identifier: GPL-3.0-or-later
// Widths of text against those that cairo says of the font that it finds.
#include "text_extent.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <random>

#include "roomatlas/draw/markup_text.hpp"

namespace roomatlas::drawing {
namespace {

std::string utf8(char32_t code) {
  std::string bytes;
  const auto add = [&](char32_t byte) { bytes += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6);
    add(0x80 | (code & 0x3F));
  } else {
    if (code < 0x10000) {
      add(0xE0 | code >> 12);
    } else {
      add(0xF0 | code >> 18);
      add(0x80 | (code >> 12 & 0x3F));
    }
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  }
  return bytes;
}

class Cairo {
 public:
  explicit Cairo(cairo_font_weight_t weight)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy),
        context_(cairo_create(surface_.get()), cairo_destroy) {
    cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, weight);
    cairo_set_font_size(context_.get(), 1000.0);
  }
  [[nodiscard]] double width(const std::string& text) const {
    cairo_text_extents_t extents{};
    cairo_text_extents(context_.get(), text.c_str(), &extents);
    EXPECT_EQ(cairo_status(context_.get()), CAIRO_STATUS_SUCCESS) << text;
    return extents.x_advance;
  }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;
};

TEST(TextWidth, OfEveryCharacterIsCairos) {
  const Cairo normal(CAIRO_FONT_WEIGHT_NORMAL);
  const Cairo bold(CAIRO_FONT_WEIGHT_BOLD);
  for (char32_t code = 0x20; code < 0x20000; ++code) {
    const bool is_none = (code >= 0xD800 && code < 0xE000) || (code >= 0xFDD0 && code < 0xFDF0) ||
                         (code & 0xFFFE) == 0xFFFE;
    if (is_none) continue;
    const std::string text = utf8(code);
    ASSERT_NEAR(text_width_mm(text, 1000.0, Weight::normal), normal.width(text), 1e-6)
        << std::uint32_t{code};
    ASSERT_NEAR(text_width_mm(text, 1000.0, Weight::bold), bold.width(text), 1e-6)
        << std::uint32_t{code};
  }
}

TEST(TextWidth, OfWordsIsCairos) {
  const Cairo cairo(CAIRO_FONT_WEIGHT_NORMAL);
  std::mt19937 random(1);
  std::uniform_int_distribution<char32_t> letter(0x20, 0x52F);  // Latin, Greek, Cyrillic
  for (int i = 0; i < 200; ++i) {
    std::string text;
    for (int k = 0; k < 12; ++k) text += utf8(letter(random));
    EXPECT_NEAR(text_width_mm(text, 3.5, Weight::normal), 0.0035 * cairo.width(text), 1e-9) << text;
  }
}

TEST(TextWidth, OfWhatIsNoUtf8IsThatOfWhatIsDrawnForIt) {
  EXPECT_EQ(text_width_mm("", 3.0, Weight::normal), 0.0);
  for (const Weight weight : {Weight::normal, Weight::bold}) {
    const double replaced = text_width_mm("\uFFFD", 3.0, weight);
    EXPECT_GT(replaced, 0.0);
    EXPECT_EQ(text_width_mm("\xFF", 3.0, weight), replaced);
    for (const std::string text :
         {"\xC3", "\x80", "\xE2\x82", "\xF0\x9F\x8F", "\xC3 a", "a\xED\xA0\x80"}) {
      EXPECT_EQ(text_width_mm(text, 3.0, weight), text_width_mm(xml_characters(text), 3.0, weight));
    }
  }
}

TEST(TextWidth, AShortenedTextFits) {
  const std::string text = "Besprechungsraum \u00dc 12";
  for (const double width_mm : {1.0, 8.0, 15.0, 25.0, 60.0}) {
    const std::string found = shortened(text, width_mm, 3.5, Weight::normal);
    EXPECT_LE(text_width_mm(found, 3.5, Weight::normal), width_mm);
  }
  EXPECT_EQ(shortened(text, 60.0, 3.5, Weight::normal), text);
}

}  // namespace
}  // namespace roomatlas::drawing
