// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/serializer.hpp"

#include <stdexcept>

namespace roomatlas::io {
namespace {

constexpr std::size_t kCdrHeader_bytes = 4;

}  // namespace

Serializer::Serializer(BagEncoding encoding) : ros1_(encoding == BagEncoding::ros1) {
  if (encoding == BagEncoding::other) throw std::invalid_argument("no encoding that is written");
  if (ros1_) return;
  bytes_.append(std::string_view("\0\1\0\0", kCdrHeader_bytes));  // plain CDR, little-endian
}

void Serializer::text(std::string_view text) {
  count(text.size() + (ros1_ ? 0 : 1));
  bytes_.append(text);
  if (!ros1_) bytes_.u8(0);
}

void Serializer::align(std::size_t size) {
  if (ros1_) return;
  while ((bytes_.size() - kCdrHeader_bytes) % size != 0) bytes_.u8(0);
}

}  // namespace roomatlas::io
