// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_reader.hpp"
#include "bags/byte_text.hpp"

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace roomatlas::io {

/// Writes a message field by field: what MessageCursor reads. ROS 1: packed; CDR: little-endian,
/// version 1, numbers aligned to their size from behind its header of four bytes.
class Serializer {
 public:
  /// @param encoding ros1 or cdr
  explicit Serializer(BagEncoding encoding);

  [[nodiscard]] bool is_ros1() const { return ros1_; }
  [[nodiscard]] std::span<const std::byte> bytes() const {
    return std::as_bytes(std::span(bytes_.text()));
  }

  /// A number of 1, 4 or 8 bytes.
  template <typename Number>
  void number(Number number) {
    align(sizeof(Number));
    if constexpr (sizeof(Number) == 8) {
      bytes_.u64(std::bit_cast<std::uint64_t>(number));
    } else if constexpr (sizeof(Number) == 4) {
      bytes_.u32(std::bit_cast<std::uint32_t>(number));
    } else {
      static_assert(sizeof(Number) == 1);
      bytes_.u8(std::bit_cast<std::uint8_t>(number));
    }
  }
  /// Of CDR with a zero at its end, which counts.
  void text(std::string_view text);
  /// The number of elements of a sequence, which follow.
  void count(std::size_t elements) { number(static_cast<std::uint32_t>(elements)); }

 private:
  void align(std::size_t size);

  ByteText bytes_;
  bool ros1_;
};

}  // namespace roomatlas::io
