// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_reader.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace roomatlas::io {

/// Reads a serialized message field by field, never beyond its end. ROS 1: little-endian, packed.
/// CDR: byte order and version by its header of four bytes, numbers aligned to their size (in
/// XCDR 2 to four bytes at most).
///
/// Beyond the end, and after a length that cannot be, everything is zero and `failed` is true: who
/// reads a message asks once, when all its fields are read.
class MessageCursor {
 public:
  /// An encoding that is neither has failed from the start.
  MessageCursor(std::span<const std::byte> bytes, BagEncoding encoding);

  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] bool is_ros1() const { return ros1_; }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - at_; }

  /// A number of 1, 2, 4 or 8 bytes.
  template <typename Number>
  Number number() {
    align(sizeof(Number));
    return unpacked<Number>(take(sizeof(Number)), big_endian_);
  }
  /// The elements of a sequence of numbers, at once.
  template <typename Number>
  std::vector<Number> numbers() {
    std::vector<Number> values(count(sizeof(Number)));
    if (values.empty()) return values;
    align(sizeof(Number));
    const std::span<const std::byte> bytes = take(sizeof(Number) * values.size());
    if (bytes.empty()) return {};
    if (!big_endian_ && std::endian::native == std::endian::little) {
      std::memcpy(values.data(), bytes.data(), bytes.size());
      return values;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = unpacked<Number>(bytes.subspan(sizeof(Number) * i, sizeof(Number)), big_endian_);
    }
    return values;
  }
  std::string text();
  /// The number of elements of a sequence.
  /// @param least_bytes that each of them takes, so that a damaged count reserves no memory
  std::size_t count(std::size_t least_bytes);
  /// So many bytes as they stand; none, and failed, where there are fewer.
  std::span<const std::byte> take(std::size_t count);
  void align(std::size_t size);

  /// A number from its bytes; zero from none.
  template <typename Number>
  [[nodiscard]] static Number unpacked(std::span<const std::byte> bytes, bool big_endian) {
    using Bits = std::conditional_t<
        sizeof(Number) == 8, std::uint64_t,
        std::conditional_t<sizeof(Number) == 4, std::uint32_t,
                           std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint8_t>>>;
    Bits bits = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::size_t place = big_endian ? bytes.size() - 1 - i : i;
      bits =
          static_cast<Bits>(bits | static_cast<Bits>(static_cast<Bits>(bytes[i]) << (8 * place)));
    }
    return std::bit_cast<Number>(bits);
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;  ///< from which CDR counts
  std::size_t most_aligned_ = 1;
  bool ros1_ = false;
  bool big_endian_ = false;
  bool failed_ = false;
};

}  // namespace roomatlas::io
