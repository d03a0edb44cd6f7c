// SPDX-License-Identifier: GPL-3.0-or-later
#include <cairo-pdf.h>
#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cmath>

#include "cairo_handles.hpp"
#include "plugins/pictures.hpp"

namespace roomatlas::pictures {
namespace {

constexpr double kCssPixelsPerInch = 96.0;   // by definition of CSS
constexpr double kPointsPerInch = 72.0;      // of PDF
constexpr double kLargestSide_px = 32000.0;  // cairo's limit is 32767

using Handle = std::unique_ptr<RsvgHandle, Deleter<g_object_unref>>;

/// Takes the error and frees it.
[[noreturn]] void fail(GError* error) {
  const std::string text = error != nullptr ? error->message : "unknown reason";
  if (error != nullptr) g_error_free(error);
  throw std::runtime_error(text);
}

/// Without the limits that are meant for strangers' documents: these are our own, and the paths of
/// many missions have more than 10 MB in one element.
Handle parsed(const std::string& svg) {
  GError* error = nullptr;
  const std::unique_ptr<GInputStream, Deleter<g_object_unref>> bytes(
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
  Handle handle(rsvg_handle_new_from_stream_sync(bytes.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED,
                                                 nullptr, &error));
  if (handle == nullptr) fail(error);
  rsvg_handle_set_dpi(handle.get(), kCssPixelsPerInch);
  return handle;
}

struct Size {
  double width = 0.0;
  double height = 0.0;
};

Size css_size_of(RsvgHandle* handle) {
  Size css;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &css.width, &css.height) == 0) {
    throw std::runtime_error("the document has no size");
  }
  return css;
}

Size size_of(RsvgHandle* handle, double dots_per_inch) {
  const Size css = css_size_of(handle);
  const double zoom = dots_per_inch / kCssPixelsPerInch;
  const Size size{std::round(css.width * zoom), std::round(css.height * zoom)};
  const bool is_possible = size.width >= 1.0 && size.height >= 1.0 &&
                           size.width <= kLargestSide_px && size.height <= kLargestSide_px;
  if (!is_possible) {
    throw std::runtime_error("at " + std::to_string(dots_per_inch) +
                             " dots per inch it would have " + std::to_string(size.width) + " x " +
                             std::to_string(size.height) + " pixels");
  }
  return size;
}

cairo_status_t append_bytes(void* to, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void render(RsvgHandle* handle, cairo_t* context, const Size& size) {
  const RsvgRectangle page{0.0, 0.0, size.width, size.height};
  GError* error = nullptr;
  if (rsvg_handle_render_document(handle, context, &page, &error) == 0) fail(error);
}

void encode_png(const std::string& svg, double dots_per_inch, std::string& bytes) {
  const Handle handle = parsed(svg);
  const Size size = size_of(handle.get(), dots_per_inch);
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width),
                                                   static_cast<int>(size.height)));
  const Context context(cairo_create(surface.get()));
  cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
  cairo_paint(context.get());
  render(handle.get(), context.get(), size);
  require(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes));
}

void encode_pdf(const std::string& svg, const std::string& title, const std::string& created,
                std::string& bytes) {
  const Handle handle = parsed(svg);
  const Size css = css_size_of(handle.get());
  const double zoom = kPointsPerInch / kCssPixelsPerInch;
  const Size size{css.width * zoom, css.height * zoom};
  const Surface surface(
      cairo_pdf_surface_create_for_stream(append_bytes, &bytes, size.width, size.height));
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, created.c_str());
  const Context context(cairo_create(surface.get()));
  render(handle.get(), context.get(), size);
  cairo_show_page(context.get());
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
}

}  // namespace
}  // namespace roomatlas::pictures

// No exception leaves these.

extern "C" void roomatlas_encode_png_1(const std::string& svg, double dots_per_inch,
                                       roomatlas::io::PictureBytes& png) try {
  roomatlas::pictures::encode_png(svg, dots_per_inch, png.content);
} catch (const std::exception& error) {
  png.error = error.what();
}

extern "C" void roomatlas_encode_pdf_1(const std::string& svg, const std::string& title,
                                       const std::string& created,
                                       roomatlas::io::PictureBytes& pdf) try {
  roomatlas::pictures::encode_pdf(svg, title, created, pdf.content);
} catch (const std::exception& error) {
  pdf.error = error.what();
}
