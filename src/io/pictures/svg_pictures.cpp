// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/pictures/svg_pictures.hpp"

#include "pictures/pictures_plugin.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"

#include <sys/mman.h>

namespace roomatlas {
namespace {

[[noreturn]] void fail(const Path& file, const std::string& reason) {
  throw InputError(file.string() + ": cannot draw the picture: " + reason);
}

/// GLib and pango end the program where they get no memory and no thread for their fonts, when they
/// are loaded already: so much is asked for before them, and given back.
bool has_memory() {
  constexpr std::size_t kDrawing_bytes = std::size_t{256} << 20;
  void* const space = mmap(nullptr, kDrawing_bytes, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (space == MAP_FAILED) return false;
  munmap(space, kDrawing_bytes);
  return true;
}

void require_memory(const Path& file) {
  if (has_memory()) return;
  fail(file,
       "it may need 256 MiB of memory, and there is less: allow more (ulimit -v), or leave "
       "PDF and PNG out");
}

void write(const Path& file, const io::PictureBytes& picture) {
  if (!picture.error.empty()) fail(file, picture.error);
  write_file(file, picture.content);
}

}  // namespace

bool has_pictures() {  // where memory is short, who draws says so
  return !has_memory() || io::is_there(io::pictures_plugin("PNG and PDF"));
}

void write_png(const Path& file, const std::string& svg, double dots_per_inch) {
  require_memory(file);
  io::PictureBytes picture;
  io::function_in<io::EncodePng>(io::pictures_plugin("PNG"), io::kEncodePng)(svg, dots_per_inch,
                                                                             picture);
  write(file, picture);
}

void write_pdf(const Path& file, const std::string& svg, const std::string& title,
               const std::string& date) {
  // Without one cairo would write the present time.
  const std::string created = (date.empty() ? "1970-01-01" : date) + "T00:00:00Z";
  require_memory(file);
  io::PictureBytes picture;
  io::function_in<io::EncodePdf>(io::pictures_plugin("PDF"), io::kEncodePdf)(svg, title, created,
                                                                             picture);
  write(file, picture);
}

}  // namespace roomatlas
