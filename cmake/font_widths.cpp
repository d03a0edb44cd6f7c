// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the widths of a font's characters as C++: font_widths NORMAL.ttf BOLD.ttf OUT.cpp
// They are what cairo says at a size of 1000 pixels, without linking it.
#include <ft2build.h>
#include FT_FREETYPE_H

#include <cstdio>

namespace {

constexpr FT_ULong kFirst = 0x20;  // what comes before has no width of its own
constexpr FT_ULong kLast = 0x10FFFF;

/// Whether it stands for a character: surrogates do not.
bool is_character(FT_ULong code) { return code < 0xD800 || code > 0xDFFF; }

bool write_runs(FT_Library library, const char* font, const char* name, std::FILE* out) {
  FT_Face face = nullptr;
  if (FT_New_Face(library, font, 0, &face) != 0 || FT_Set_Pixel_Sizes(face, 0, 1000) != 0) {
    std::fprintf(stderr, "%s: not a font that FreeType can scale\n", font);
    return false;
  }
  std::fprintf(out, "constexpr WidthRun %s[] = {", name);
  FT_UInt last_glyph = ~0U;
  long last_width = -1;
  for (FT_ULong code = kFirst; code <= kLast; ++code) {
    const FT_UInt glyph = is_character(code) ? FT_Get_Char_Index(face, code) : 0;
    if (glyph == last_glyph) continue;
    last_glyph = glyph;
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING) != 0) return false;
    const long width = (face->glyph->advance.x + 32) / 64;
    if (width == last_width) continue;
    last_width = width;
    std::fprintf(out, "{0x%lX, %ld},\n", code, width);
  }
  std::fprintf(out, "};\n");
  return FT_Done_Face(face) == 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  FT_Library library = nullptr;
  std::FILE* const out = std::fopen(arguments[3], "w");
  if (out == nullptr || FT_Init_FreeType(&library) != 0) return 1;
  std::fprintf(out,
               "#include \"font_widths.hpp\"\n\nnamespace roomatlas::drawing {\nnamespace {\n");
  if (!write_runs(library, arguments[1], "kNormal", out)) return 1;
  if (!write_runs(library, arguments[2], "kBold", out)) return 1;
  std::fprintf(out,
               "}  // namespace\n\n"
               "std::span<const WidthRun> normal_widths() { return kNormal; }\n"
               "std::span<const WidthRun> bold_widths() { return kBold; }\n\n"
               "}  // namespace roomatlas::drawing\n");
  return std::fclose(out) == 0 ? 0 : 1;
}
