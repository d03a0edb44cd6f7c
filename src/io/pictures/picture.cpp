// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.hpp"

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/input_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>

namespace roomatlas::io {
namespace {

// A pixel takes up to 20 bytes while a map is made of it, so that packed ones are believed less
// than packed text: so many, and beyond them those that a picture of a building packs to.
constexpr std::uint64_t kPackedPixels = std::uint64_t{1} << 25;
constexpr std::uint64_t kPackedPixelsAByte = 8;

constexpr const char* kPngSignature = "\x89PNG\r\n\x1a\n";

struct GzClose {
  void operator()(gzFile file) const { gzclose_r(file); }
};

}  // namespace

std::string read_unpacked(const std::filesystem::path& file, std::size_t most_bytes) {
  const std::string name = file.string();
  if (!std::filesystem::exists(file)) {
    throw InputError(name + ": there is no such file; check the path");
  }
  if (std::filesystem::is_directory(file)) {
    throw InputError(name + ": is a directory; name a file inside it");
  }
  require_regular_file(file);
  const std::unique_ptr<gzFile_s, GzClose> stream(gzopen(name.c_str(), "rb"));
  if (stream == nullptr) throw InputError(name + ": cannot be opened");
  std::string bytes;
  std::array<char, std::size_t{1} << 16> block{};
  int count = 0;
  while (bytes.size() < most_bytes &&
         (count = gzread(stream.get(), block.data(), block.size())) > 0) {
    bytes.append(block.data(), static_cast<std::size_t>(count));
    const auto packed = static_cast<std::uint64_t>(std::max<z_off_t>(0, gzoffset(stream.get())));
    const bool is_plain = gzdirect(stream.get()) == 1;
    if (!is_plain && bytes.size() > kPackedPixels + kPackedPixelsAByte * packed) {
      throw InputError(name + ": its gzip data grows to more than a picture of a building does: " +
                       std::to_string(bytes.size()) + " bytes of " + std::to_string(packed) +
                       ". If it is one, unpack it with `gunzip`");
    }
  }
  int error = Z_OK;
  gzerror(stream.get(), &error);
  if (count < 0 || error == Z_BUF_ERROR) {
    throw InputError(name + ": its gzip data is damaged or cut short; copy the file again");
  }
  return bytes;
}

bool is_picture_file(const std::filesystem::path& file) {
  return is_picture(read_unpacked(file, 1));  // a block, which holds any signature
}

bool is_picture(const std::string& bytes) {
  return bytes.starts_with("P2") || bytes.starts_with("P5") || bytes.starts_with(kPngSignature);
}

Picture parse_picture(const std::string& bytes, const std::string& name) {
  if (bytes.starts_with(kPngSignature)) return parse_png(bytes, name);
  if (is_picture(bytes)) return parse_pgm(bytes, name);
  throw InputError(name + ": not a picture that can be read: expected PNG, or PGM (P2 or P5)");
}

}  // namespace roomatlas::io
