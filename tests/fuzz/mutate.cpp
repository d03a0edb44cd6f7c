// SPDX-License-Identifier: GPL-3.0-or-later
#include "mutate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace roomatlas::fuzz {
namespace {

constexpr std::array kNumbers = {
    "0",    "-1",    "1e308", "-1e308",     "1e-320", "nan",
    "inf",  "1e9",   "7",     "2147483648", "0x10",   "99999999999999999999",
    "-0.0", "1e400", ".",     "65536",      "1,5",    ""};
constexpr std::array<std::uint64_t, 12> kWords = {0,
                                                  1,
                                                  0x7f,
                                                  0xff,
                                                  0x7fff,
                                                  0xffff,
                                                  0x7fffffff,
                                                  0x80000000,
                                                  0xffffffff,
                                                  0x40000000,
                                                  ~std::uint64_t{0},
                                                  std::uint64_t{1} << 63};

std::size_t below(Random& random, std::size_t count) {
  return count == 0 ? 0 : static_cast<std::size_t>(random() % count);
}

struct Stretch {
  std::size_t begin = 0;
  std::size_t length = 0;
};

/// Short ones mostly.
Stretch stretch_of(const std::string& bytes, Random& random) {
  Stretch stretch;
  stretch.begin = below(random, bytes.size() + 1);
  const std::size_t most = below(random, 8) == 0 ? bytes.size() : 40;
  stretch.length = std::min(below(random, most + 1), bytes.size() - stretch.begin);
  return stretch;
}

/// From a byte up to the next that is the same, as from comma to comma: lists of these stay lists.
Stretch until_its_like(const std::string& bytes, std::size_t begin) {
  if (begin >= bytes.size()) return {begin, 0};
  const std::size_t next = bytes.find(bytes[begin], begin + 1);
  return {begin, (next == std::string::npos ? bytes.size() : next) - begin};
}

bool is_of_number(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
}

void replace_number(std::string& bytes, Random& random) {
  const std::size_t from = below(random, bytes.size() + 1);
  const auto begin =
      std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(), is_of_number);
  const auto end = std::find_if_not(begin, bytes.end(), is_of_number);
  if (begin == end) return;
  bytes.replace(begin, end, kNumbers[below(random, kNumbers.size())]);
}

void replace_word(std::string& bytes, Random& random) {
  const std::size_t size = std::size_t{1} << below(random, 4);
  if (bytes.size() < size) return;
  const std::size_t at = below(random, bytes.size() - size + 1);
  std::uint64_t word = kWords[below(random, kWords.size())];
  if (below(random, 3) == 0) word -= below(random, 16);
  const bool is_big_endian = below(random, 2) == 0;
  for (std::size_t i = 0; i < size; ++i) {
    bytes[at + (is_big_endian ? size - 1 - i : i)] = static_cast<char>(word >> (8 * i));
  }
}

void mutate(std::string& bytes, const std::string& other, Random& random) {
  const Stretch at = stretch_of(bytes, random);
  switch (below(random, 9)) {
    case 0:
    case 1:
      if (at.begin < bytes.size()) bytes[at.begin] ^= static_cast<char>(1U << below(random, 8));
      return;
    case 2:
      if (at.begin < bytes.size()) bytes[at.begin] = static_cast<char>(random());
      return;
    case 3:
      bytes.erase(at.begin, at.length);
      return;
    case 4:
      bytes.insert(at.begin, bytes.substr(at.begin, at.length));
      return;
    case 5: {
      const Stretch from = stretch_of(other, random);
      bytes.replace(at.begin, at.length, other, from.begin, from.length);
      return;
    }
    case 6:
      return replace_number(bytes, random);
    case 7:
      return replace_word(bytes, random);
    default:
      if (below(random, 4) == 0) bytes.resize(at.begin);
      return;
  }
}

}  // namespace

std::string mutated(std::string bytes, const std::string& other, Random& random,
                    std::size_t most_bytes) {
  for (std::size_t times = 1 + below(random, 5); times > 0; --times) mutate(bytes, other, random);
  if (bytes.size() > most_bytes) bytes.resize(most_bytes);
  return bytes;
}

std::string grown(const std::string& bytes, Random& random, std::size_t most_bytes) {
  Stretch at = stretch_of(bytes, random);
  const std::size_t way = below(random, 4);
  if (way == 0) at = {0, bytes.size()};
  if (way >= 2) at = until_its_like(bytes, at.begin);
  if (bytes.size() >= most_bytes || at.length == 0) return bytes;
  const std::string again = bytes.substr(at.begin, at.length);
  std::string between;
  between.reserve(most_bytes);
  while (bytes.size() + between.size() + again.size() <= most_bytes) between += again;
  return bytes.substr(0, at.begin) + between + bytes.substr(at.begin);
}

}  // namespace roomatlas::fuzz
