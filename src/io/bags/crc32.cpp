// SPDX-License-Identifier: GPL-3.0-or-later
#include "crc32.hpp"

#include <libdeflate.h>

namespace roomatlas::io {

std::uint32_t crc32_of(ByteSpan bytes, std::uint32_t before) {
  return libdeflate_crc32(before, bytes.data(), bytes.size());
}

}  // namespace roomatlas::io
