// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.hpp"

#include "roomatlas/core/issue.hpp"

#include <zlib.h>

#include <array>
#include <cstring>
#include <memory>

namespace roomatlas::io {
namespace {

constexpr const char* kPngSignature = "\x89PNG\r\n\x1a\n";

struct GzClose {
  void operator()(gzFile file) const { gzclose_r(file); }
};

}  // namespace

std::string read_unpacked(const std::filesystem::path& file) {
  const std::string name = file.string();
  if (!std::filesystem::exists(file)) {
    throw InputError(name + ": there is no such file; check the path");
  }
  if (std::filesystem::is_directory(file)) {
    throw InputError(name + ": is a directory; name a file inside it");
  }
  const std::unique_ptr<gzFile_s, GzClose> stream(gzopen(name.c_str(), "rb"));
  if (stream == nullptr) throw InputError(name + ": cannot be opened");
  std::string bytes;
  std::array<char, std::size_t{1} << 16> block{};
  int count = 0;
  while ((count = gzread(stream.get(), block.data(), block.size())) > 0) {
    bytes.append(block.data(), static_cast<std::size_t>(count));
  }
  int error = Z_OK;
  gzerror(stream.get(), &error);
  if (count < 0 || error == Z_BUF_ERROR) {
    throw InputError(name + ": its gzip data is damaged or cut short; copy the file again");
  }
  return bytes;
}

std::string read_beginning(const std::filesystem::path& file, std::size_t most_bytes) {
  const std::unique_ptr<gzFile_s, GzClose> stream(gzopen(file.string().c_str(), "rb"));
  std::string bytes(most_bytes, '\0');
  const int count = stream == nullptr
                        ? 0
                        : gzread(stream.get(), bytes.data(), static_cast<unsigned>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max(0, count)));
  return bytes;
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
