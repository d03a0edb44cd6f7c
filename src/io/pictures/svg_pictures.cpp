// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/pictures/svg_pictures.hpp"
#include "cairo_handles.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"

#include <cairo-pdf.h>
#include <cairo.h>
#include <librsvg/rsvg.h>
#include <sys/mman.h>

#include <cmath>

namespace roomatlas {
namespace {

constexpr double kCssPixelsPerInch = 96.0;   // by definition of CSS
constexpr double kPointsPerInch = 72.0;      // of PDF
constexpr double kLargestSide_px = 32000.0;  // cairo's limit is 32767

using io::Context;
using io::Surface;
using Handle = std::unique_ptr<RsvgHandle, io::Deleter<g_object_unref>>;

/// Takes the error's text and frees it.
std::string text_of(GError* error) {
  const std::string text = error != nullptr ? error->message : "unknown reason";
  if (error != nullptr) g_error_free(error);
  return text;
}

[[noreturn]] void fail(const Path& file, const std::string& reason) {
  throw InputError(file.string() + ": cannot draw the picture: " + reason);
}

/// GLib and pango end the program where they get no memory and no thread for their fonts: so much
/// is asked for before them, and given back.
void require_memory(const Path& file) {
  constexpr std::size_t kDrawing_bytes = std::size_t{256} << 20;
  void* const space = mmap(nullptr, kDrawing_bytes, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (space == MAP_FAILED) {
    fail(file,
         "it may need 256 MiB of memory, and there is less: allow more (ulimit -v), or leave "
         "PDF and PNG out");
  }
  munmap(space, kDrawing_bytes);
}

Handle parsed(const Path& file, const std::string& svg) {
  require_memory(file);
  GError* error = nullptr;
  Handle handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  if (handle == nullptr) fail(file, text_of(error));
  rsvg_handle_set_dpi(handle.get(), kCssPixelsPerInch);
  return handle;
}

struct PixelSize {
  double width = 0.0;
  double height = 0.0;
};

PixelSize css_size_of(const Path& file, RsvgHandle* handle) {
  PixelSize css;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &css.width, &css.height) == 0) {
    fail(file, "the document has no size");
  }
  return css;
}

PixelSize size_of(const Path& file, RsvgHandle* handle, double dots_per_inch) {
  const PixelSize css = css_size_of(file, handle);
  const double zoom = dots_per_inch / kCssPixelsPerInch;
  const PixelSize size{std::round(css.width * zoom), std::round(css.height * zoom)};
  const bool is_possible = size.width >= 1.0 && size.height >= 1.0 &&
                           size.width <= kLargestSide_px && size.height <= kLargestSide_px;
  if (!is_possible) {
    fail(file, "at " + std::to_string(dots_per_inch) + " dots per inch it would have " +
                   std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels");
  }
  return size;
}

cairo_status_t append_bytes(void* to, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void render(const Path& file, RsvgHandle* handle, cairo_t* context, const PixelSize& size) {
  const RsvgRectangle page{0.0, 0.0, size.width, size.height};
  GError* error = nullptr;
  if (rsvg_handle_render_document(handle, context, &page, &error) == 0) fail(file, text_of(error));
}

void check(const Path& file, cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) fail(file, cairo_status_to_string(status));
}

}  // namespace

void write_png(const Path& file, const std::string& svg, double dots_per_inch) {
  const Handle handle = parsed(file, svg);
  const PixelSize size = size_of(file, handle.get(), dots_per_inch);
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width),
                                                   static_cast<int>(size.height)));
  const Context context(cairo_create(surface.get()));
  cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
  cairo_paint(context.get());
  render(file, handle.get(), context.get(), size);
  std::string bytes;
  check(file, cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes));
  write_file(file, bytes);
}

void write_pdf(const Path& file, const std::string& svg, const std::string& title,
               const std::string& date) {
  const Handle handle = parsed(file, svg);
  const PixelSize css = css_size_of(file, handle.get());
  const double zoom = kPointsPerInch / kCssPixelsPerInch;
  const PixelSize size{css.width * zoom, css.height * zoom};
  std::string bytes;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(append_bytes, &bytes, size.width, size.height));
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  // Without one cairo would write the present time.
  const std::string created = (date.empty() ? "1970-01-01" : date) + "T00:00:00Z";
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, created.c_str());
  const Context context(cairo_create(surface.get()));
  render(file, handle.get(), context.get(), size);
  cairo_show_page(context.get());
  cairo_surface_finish(surface.get());
  check(file, cairo_surface_status(surface.get()));
  write_file(file, bytes);
}

}  // namespace roomatlas
