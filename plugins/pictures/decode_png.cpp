// SPDX-License-Identifier: GPL-3.0-or-later
#include <cairo.h>

#include <cstring>
#include <string_view>

#include "cairo_handles.hpp"
#include "plugins/pictures.hpp"

namespace roomatlas::pictures {
namespace {

cairo_status_t take_bytes(void* from, unsigned char* to, unsigned int length) {
  auto& rest = *static_cast<std::string_view*>(from);
  if (rest.size() < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(to, rest.data(), length);
  rest.remove_prefix(length);
  return CAIRO_STATUS_SUCCESS;
}

void decode(const std::string& png, io::Pixels& pixels) {
  std::string_view rest = png;
  const Surface read(cairo_image_surface_create_from_png_stream(take_bytes, &rest));
  require(cairo_surface_status(read.get()));
  pixels.width = cairo_image_surface_get_width(read.get());
  pixels.height = cairo_image_surface_get_height(read.get());

  // Painted once over, so that whatever the file's format was there is one to take apart.
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels.width, pixels.height));
  const Context context(cairo_create(surface.get()));
  cairo_set_operator(context.get(), CAIRO_OPERATOR_SOURCE);
  cairo_set_source_surface(context.get(), read.get(), 0.0, 0.0);
  cairo_paint(context.get());
  require(cairo_status(context.get()));
  cairo_surface_flush(surface.get());

  const auto width = static_cast<std::size_t>(pixels.width);
  const unsigned char* row = cairo_image_surface_get_data(surface.get());
  pixels.argb.resize(width * static_cast<std::size_t>(pixels.height));
  for (std::size_t first = 0; first < pixels.argb.size(); first += width) {
    std::memcpy(&pixels.argb[first], row, 4 * width);
    row += cairo_image_surface_get_stride(surface.get());
  }
}

}  // namespace
}  // namespace roomatlas::pictures

/// No exception leaves it.
extern "C" void roomatlas_decode_png_1(const std::string& png, roomatlas::io::Pixels& pixels) try {
  roomatlas::pictures::decode(png, pixels);
} catch (const std::exception& error) {
  pixels.error = error.what();
}
