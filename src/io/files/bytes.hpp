// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace roomatlas {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// Bytes that are not what their format says. The store adds the file's name.
struct DamagedData : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes numbers in little-endian order, whatever the machine's own order is.
class ByteWriter {
 public:
  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void u32(std::uint32_t value) { little_endian(value, 4); }
  void f64(double value) { little_endian(std::bit_cast<std::uint64_t>(value), 8); }
  void append(ByteView bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  /// Seven bits a byte, lowest first; the top bit says that more follow.
  void varint(std::uint64_t value) {
    for (; value > 0x7f; value >>= 7) u8(static_cast<std::uint8_t>(value | 0x80));
    u8(static_cast<std::uint8_t>(value));
  }
  /// A signed varint that is short on both sides of zero: 0, -1, 1, -2 ... become 0, 1, 2, 3 ...
  void zigzag(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    varint((bits << 1) ^ (value < 0 ? ~std::uint64_t{0} : 0));
  }

  [[nodiscard]] Bytes take() { return std::move(bytes_); }

 private:
  void little_endian(std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) u8(static_cast<std::uint8_t>(value >> (8 * i)));
  }

  Bytes bytes_;
};

/// Reads what ByteWriter wrote. Throws DamagedData at the end of the bytes.
class ByteReader {
 public:
  explicit ByteReader(ByteView bytes) : rest_(bytes) {}

  [[nodiscard]] std::size_t remaining() const { return rest_.size(); }
  void skip(std::size_t count) { rest_ = rest_.subspan(checked(count)); }

  std::uint8_t u8() {
    const std::uint8_t value = rest_[checked(1) - 1];
    rest_ = rest_.subspan(1);
    return value;
  }
  std::uint32_t u32() { return static_cast<std::uint32_t>(little_endian(4)); }
  double f64() { return std::bit_cast<double>(little_endian(8)); }

  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const std::uint8_t byte = u8();
      value |= std::uint64_t{byte & 0x7fu} << shift;
      if (byte < 0x80) return value;
    }
    throw DamagedData("a number is longer than 64 bits");
  }
  std::int64_t zigzag() {
    const std::uint64_t bits = varint();
    return static_cast<std::int64_t>((bits >> 1) ^ (bits & 1 ? ~std::uint64_t{0} : 0));
  }

  /// A count of things of at least `bytes_each` bytes, refused when they cannot be there: damaged
  /// data must not allocate gigabytes.
  std::size_t counted(std::uint64_t count, std::size_t bytes_each) const {
    if (count > rest_.size() / bytes_each) throw DamagedData("the data ends early");
    return static_cast<std::size_t>(count);
  }

 private:
  std::size_t checked(std::size_t count) const {
    if (count > rest_.size()) throw DamagedData("the data ends early");
    return count;
  }
  std::uint64_t little_endian(int count) {
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i) value |= std::uint64_t{u8()} << (8 * i);
    return value;
  }

  ByteView rest_;
};

}  // namespace roomatlas
