// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.hpp"
#include "pictures/pictures_plugin.hpp"

#include "roomatlas/core/issue.hpp"

namespace roomatlas::io {
namespace {

/// Width and height stand at fixed places (PNG specification, 11.2.1): cairo would take memory for
/// whatever they say.
void require_size(const std::string& bytes, const std::string& name) {
  constexpr std::size_t kWidth = 16;
  constexpr std::size_t kHeight = 20;
  constexpr std::int64_t kMost = kMostPixels / 8;
  if (bytes.size() < kHeight + 4) return;  // the plug-in says so
  const auto number = [&](std::size_t at) {
    std::int64_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = 256 * value + static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  const std::int64_t width = number(kWidth);
  const std::int64_t height = number(kHeight);
  if (width == 0 || height <= kMost / width) return;
  throw InputError(name + ": has " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels, expected at most " + std::to_string(kMost) +
                   ": save it with larger pixels, or as PGM");
}

}  // namespace

Picture parse_png(const std::string& bytes, const std::string& name) {
  require_size(bytes, name);
  Pixels pixels;
  function_in<DecodePng>(pictures_plugin(name + ": reading a PNG"), kDecodePng)(bytes, pixels);
  if (!pixels.error.empty()) {
    throw InputError(name + ": not a PNG that can be read (" + pixels.error +
                     "): save it again as 8 bit grey");
  }
  Picture picture;
  picture.values = CellGrid<int>(pixels.width, pixels.height);
  auto pixel = pixels.argb.begin();
  for (int y = pixels.height - 1; y >= 0; --y) {
    for (int x = 0; x < pixels.width; ++x, ++pixel) {
      const int alpha = static_cast<int>(*pixel >> 24);
      const int sum = static_cast<int>((*pixel >> 16 & 255) + (*pixel >> 8 & 255) + (*pixel & 255));
      // colours are premultiplied with alpha
      picture.values(x, y) = alpha < 128 ? Picture::kTransparent : sum * 85 / alpha;
    }
  }
  return picture;
}

}  // namespace roomatlas::io
