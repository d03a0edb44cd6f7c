// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.hpp"

#include "roomatlas/core/issue.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace roomatlas::io {
namespace {

/// Walks over the words of a PGM; `#` comments reach to the end of the line.
class Words {
 public:
  Words(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  /// A whole number in [low, high].
  int number(const char* what, std::int64_t low, std::int64_t high) {
    skip_blanks();
    std::int64_t value = 0;
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])) != 0) {
      value = std::min<std::int64_t>(value * 10 + (bytes_[at_++] - '0'), kMostPixels + 1);
    }
    if (at_ == begin || value < low || value > high) {
      throw InputError(name_ + ": " + what + ": expected a whole number from " +
                       std::to_string(low) + " to " + std::to_string(high) + " at byte " +
                       std::to_string(begin));
    }
    return static_cast<int>(value);
  }

  void skip(std::size_t count) { at_ += count; }
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  void skip_blanks() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else if (std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }

  const std::string& bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

}  // namespace

Picture parse_pgm(const std::string& bytes, const std::string& name) {
  Words words(bytes, name);
  words.skip(2);  // P2 or P5
  const int width = words.number("width", 1, kMostPixels);
  const int height = words.number("height", 1, kMostPixels / width);
  Picture picture;
  picture.white = words.number("maximum value", 1, 65535);
  const bool is_text = bytes[1] == '2';
  const std::size_t bytes_per_pixel = picture.white > 255 ? 2 : 1;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::size_t begin = words.at() + 1;  // one blank ends the header of a P5
  // In text a pixel is a digit and a blank, but for the last one's.
  const std::size_t least_bytes = is_text ? 2 * pixels - 1 : pixels * bytes_per_pixel;
  if (begin + least_bytes > bytes.size()) {
    throw InputError(name + ": cut short: " + std::to_string(width) + " x " +
                     std::to_string(height) + " pixels need " + (is_text ? "at least " : "") +
                     std::to_string(least_bytes) + " bytes, and there are " +
                     std::to_string(bytes.size() - std::min(begin, bytes.size())));
  }
  picture.values = CellGrid<int>(width, height);
  std::size_t at = begin;
  const auto byte = [&] { return static_cast<int>(static_cast<unsigned char>(bytes[at++])); };
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      int value = 0;
      if (is_text) {
        value = words.number("pixel", 0, picture.white);
      } else {
        value = byte();
        if (bytes_per_pixel == 2) value = 256 * value + byte();
      }
      picture.values(x, y) = std::min(value, picture.white);
    }
  }
  return picture;
}

}  // namespace roomatlas::io
