// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/message_cursor.hpp"

#include <algorithm>

namespace roomatlas::io {
namespace {

// CDR's header: two bytes say how the rest is laid out, two are options. These layouts are the
// plain ones; even is big-endian, odd is little-endian.
constexpr std::size_t kHeaderBytes = 4;
constexpr unsigned kPlainBig = 0;
constexpr unsigned kPlainLittle = 1;
constexpr unsigned kPlain2Big = 6;
constexpr unsigned kPlain2Little = 7;

}  // namespace

MessageCursor::MessageCursor(std::span<const std::byte> bytes, BagEncoding encoding)
    : bytes_(bytes), ros1_(encoding == BagEncoding::ros1) {
  if (ros1_) return;
  failed_ = true;
  if (encoding != BagEncoding::cdr || bytes.size() < kHeaderBytes) return;
  const unsigned layout = std::to_integer<unsigned>(bytes[1]);
  const bool plain = layout == kPlainBig || layout == kPlainLittle;
  const bool plain2 = layout == kPlain2Big || layout == kPlain2Little;
  if (bytes[0] != std::byte{0} || !(plain || plain2)) return;
  failed_ = false;
  big_endian_ = layout % 2 == 0;
  most_aligned_ = plain ? 8 : 4;
  at_ = start_ = kHeaderBytes;
}

void MessageCursor::align(std::size_t size) {
  const std::size_t to = std::min(size, most_aligned_);
  const std::size_t past = (at_ - start_) % to;
  if (past != 0) (void)take(to - past);
}

std::span<const std::byte> MessageCursor::take(std::size_t count) {
  if (failed_ || count > remaining()) {
    failed_ = true;
    return {};
  }
  at_ += count;
  return bytes_.subspan(at_ - count, count);
}

std::size_t MessageCursor::count(std::size_t least_bytes) {
  const std::size_t count = number<std::uint32_t>();
  if (count <= remaining() / std::max<std::size_t>(1, least_bytes)) return count;
  failed_ = true;
  return 0;
}

std::string MessageCursor::text() {
  const std::span<const std::byte> bytes = take(count(1));
  std::string text(bytes.size(), '\0');
  std::transform(bytes.begin(), bytes.end(), text.begin(),
                 [](std::byte byte) { return static_cast<char>(byte); });
  if (!ros1_ && !text.empty() && text.back() == '\0') text.pop_back();  // CDR writes it out
  return text;
}

}  // namespace roomatlas::io
