// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace roomatlas::io {

using ByteSpan = std::span<const std::byte>;

inline std::string_view as_text(ByteSpan bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Reads little-endian values one after another. Whatever a length claims, nothing behind the end
/// is touched: DamagedData is thrown instead.
class ByteCursor {
 public:
  explicit ByteCursor(ByteSpan bytes) : rest_(bytes), size_(bytes.size()) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] ByteSpan rest() const { return rest_; }
  [[nodiscard]] std::size_t remaining() const { return rest_.size(); }
  [[nodiscard]] std::size_t position() const { return size_ - rest_.size(); }

  ByteSpan bytes(std::uint64_t count) {
    if (count > rest_.size()) throw DamagedData("the data ends early");
    const ByteSpan taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  std::uint8_t u8() { return static_cast<std::uint8_t>(unsigned_number<1>()); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(unsigned_number<2>()); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(unsigned_number<4>()); }
  std::uint64_t u64() { return unsigned_number<8>(); }
  /// Bytes behind their number, which has 32 bits.
  ByteSpan block() { return bytes(u32()); }
  std::string_view text() { return as_text(block()); }

 private:
  template <int kBytes>
  std::uint64_t unsigned_number() {
    const ByteSpan taken = bytes(kBytes);
    std::uint64_t value = 0;
    for (int i = 0; i < kBytes; ++i) {
      value |= std::to_integer<std::uint64_t>(taken[static_cast<std::size_t>(i)]) << (8 * i);
    }
    return value;
  }

  ByteSpan rest_;
  std::size_t size_;
};

}  // namespace roomatlas::io
