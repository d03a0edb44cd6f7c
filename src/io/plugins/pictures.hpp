// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// What the library asks the plug-in roomatlas-pictures: drawings as PNG and PDF, and the pixels of
/// a PNG. Both are built of the same sources; the plug-in is linked with nothing of the library.
namespace roomatlas::io {

/// The answer: a file's content, or what went wrong.
struct PictureBytes {
  std::string content;
  std::string error;  ///< empty when all went well
};

struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t>
      argb;           ///< from the upper row down; colours are premultiplied with alpha
  std::string error;  ///< empty when all went well
};

constexpr const char* kEncodePng = "roomatlas_encode_png_1";
using EncodePng = void(const std::string& svg, double dots_per_inch, PictureBytes& png);

/// @param created date and time of ISO 8601
constexpr const char* kEncodePdf = "roomatlas_encode_pdf_1";
using EncodePdf = void(const std::string& svg, const std::string& title, const std::string& created,
                       PictureBytes& pdf);

constexpr const char* kDecodePng = "roomatlas_decode_png_1";
using DecodePng = void(const std::string& png, Pixels& pixels);

}  // namespace roomatlas::io
