// SPDX-License-Identifier: GPL-3.0-or-later
#include "cairo_handles.hpp"
#include "picture.hpp"

#include "roomatlas/core/issue.hpp"

#include <cairo.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

namespace roomatlas::io {
namespace {

cairo_status_t take_bytes(void* from, unsigned char* to, unsigned int length) {
  auto& rest = *static_cast<std::string_view*>(from);
  if (rest.size() < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(to, rest.data(), length);
  rest.remove_prefix(length);
  return CAIRO_STATUS_SUCCESS;
}

/// Width and height stand at fixed places (PNG specification, 11.2.1): cairo would take memory for
/// whatever they say.
void require_size(const std::string& bytes, const std::string& name) {
  constexpr std::size_t kWidth = 16;
  constexpr std::size_t kHeight = 20;
  constexpr std::int64_t kMost = kMostPixels / 4;
  if (bytes.size() < kHeight + 4) return;  // cairo says so
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

void require(cairo_status_t status, const std::string& name) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw InputError(name + ": not a PNG that can be read (" + cairo_status_to_string(status) +
                   "): save it again as 8 bit grey");
}

}  // namespace

Picture parse_png(const std::string& bytes, const std::string& name) {
  require_size(bytes, name);
  std::string_view rest = bytes;
  const Surface read(cairo_image_surface_create_from_png_stream(take_bytes, &rest));
  require(cairo_surface_status(read.get()), name);
  const int width = cairo_image_surface_get_width(read.get());
  const int height = cairo_image_surface_get_height(read.get());

  // Painted once over, so that whatever the file's format was there is one to take apart.
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  const Context context(cairo_create(surface.get()));
  cairo_set_operator(context.get(), CAIRO_OPERATOR_SOURCE);
  cairo_set_source_surface(context.get(), read.get(), 0.0, 0.0);
  cairo_paint(context.get());
  require(cairo_status(context.get()), name);
  cairo_surface_flush(surface.get());

  Picture picture;
  picture.values = CellGrid<int>(width, height);
  const unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < height; ++row) {
    for (int x = 0; x < width; ++x) {
      std::uint32_t pixel = 0;  // alpha, red, green, blue from the highest byte down
      std::memcpy(&pixel, data + static_cast<std::ptrdiff_t>(row) * stride + 4 * x, 4);
      const int alpha = static_cast<int>(pixel >> 24);
      const int sum = static_cast<int>((pixel >> 16 & 255) + (pixel >> 8 & 255) + (pixel & 255));
      // colours are premultiplied with alpha
      picture.values(x, height - 1 - row) = alpha < 128 ? Picture::kTransparent : sum * 85 / alpha;
    }
  }
  return picture;
}

}  // namespace roomatlas::io
