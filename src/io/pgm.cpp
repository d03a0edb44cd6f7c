// SPDX-License-Identifier: GPL-3.0-or-later
#include "pgm.hpp"

#include <zlib.h>

#include <cctype>
#include <memory>
#include <string>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::io {
namespace {

constexpr int kLargestSide = 1 << 15;  ///< pixels; larger is taken for a damaged header

struct CloseGz {
  void operator()(gzFile file) const { gzclose_r(file); }
};
using GzHandle = std::unique_ptr<std::remove_pointer_t<gzFile>, CloseGz>;

class PgmReader {
 public:
  explicit PgmReader(const std::filesystem::path& file)
      : name_(file.string()), file_(gzopen(name_.c_str(), "rb")) {
    if (!file_ || !std::filesystem::is_regular_file(file)) fail("cannot be opened");
  }

  GreyPicture read() {
    if (next() != 'P' || next() != '5') fail("not a binary PGM: expected it to begin with \"P5\"");
    GreyPicture picture;
    picture.width = header_number("width", kLargestSide);
    picture.height = header_number("height", kLargestSide);
    const bool two_bytes = header_number("largest value", 65535) > 255;
    const auto count =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.pixels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const int high = two_bytes ? pixel_byte() : 0;
      picture.pixels.push_back(static_cast<std::uint16_t>(high * 256 + pixel_byte()));
    }
    return picture;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_ + ": " + what); }

  int next() { return gzgetc(file_.get()); }

  int pixel_byte() {
    const int byte = next();
    if (byte < 0) fail("the picture ends before its last pixel; copy the file again");
    return byte;
  }

  /// A number of the header, after blanks and comments; takes the one blank that follows it.
  int header_number(const char* field, int largest) {
    int c = next();
    while (c == '#' || std::isspace(c) != 0) {
      if (c == '#') {
        while (c >= 0 && c != '\n') c = next();
      }
      c = next();
    }
    int number = 0;
    for (; c >= '0' && c <= '9' && number <= largest; c = next()) number = 10 * number + (c - '0');
    if (number < 1 || number > largest || std::isspace(c) == 0) {
      fail(std::string(field) + ": expected a number from 1 to " + std::to_string(largest) +
           " in the header of the PGM");
    }
    return number;
  }

  std::string name_;
  GzHandle file_;
};

}  // namespace

GreyPicture read_pgm(const std::filesystem::path& file) { return PgmReader(file).read(); }

}  // namespace roomatlas::io
