// SPDX-License-Identifier: GPL-3.0-or-later
#include "pack.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <stdexcept>

namespace roomatlas::io {
namespace {

constexpr int kZstdLevel = 3;  // the library's own choice
constexpr int kBzip2Block = 9;

std::string shortened(std::string packed, std::size_t size) {
  packed.resize(size);
  return packed;
}

std::string pack_bzip2(std::string_view bytes) {
  std::string packed(bytes.size() + bytes.size() / 100 + 600, '\0');  // as its manual says
  auto size = static_cast<unsigned>(packed.size());
  // The library's interface has no const; it does not write there.
  if (BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(bytes.data()),
                               static_cast<unsigned>(bytes.size()), kBzip2Block, 0, 0) != BZ_OK) {
    throw std::runtime_error("bzip2 does not pack");
  }
  return shortened(std::move(packed), size);
}

std::string pack_lz4(std::string_view bytes) {
  LZ4F_preferences_t preferences = {};
  // ROS's own reader knows this kind of frame alone: no size in front, blocks for themselves, a sum
  // behind.
  preferences.frameInfo.blockMode = LZ4F_blockIndependent;
  preferences.frameInfo.blockSizeID = LZ4F_max1MB;
  preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
  std::string packed(LZ4F_compressFrameBound(bytes.size(), &preferences), '\0');
  const std::size_t size =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), &preferences);
  if (LZ4F_isError(size)) throw std::runtime_error("lz4 does not pack");
  return shortened(std::move(packed), size);
}

std::string pack_zstd(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kZstdLevel);
  if (ZSTD_isError(size)) throw std::runtime_error("zstd does not pack");
  return shortened(std::move(packed), size);
}

}  // namespace

std::string pack(Packing packing, std::string_view bytes) {
  switch (packing) {
    case Packing::bz2:
      return pack_bzip2(bytes);
    case Packing::lz4:
      return pack_lz4(bytes);
    case Packing::zstd:
      return pack_zstd(bytes);
    case Packing::none:
      break;
  }
  return std::string(bytes);
}

}  // namespace roomatlas::io
