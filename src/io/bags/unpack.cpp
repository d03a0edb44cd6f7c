// SPDX-License-Identifier: GPL-3.0-or-later
#include "unpack.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <limits>
#include <new>

namespace roomatlas::io {
namespace {

constexpr std::size_t kFirstRoom_bytes = std::size_t{1} << 24;  // claims beyond it are not trusted
constexpr const char* kCutShort = "its packed data ends early";
constexpr const char* kTooLong = "it unpacks to more bytes than it claims";

/// Makes room behind what `out` holds, up to `most_bytes` in all. False where that is reached.
bool make_room(Buffer& out, std::size_t most_bytes) {
  if (out.size() < out.capacity() && out.size() < most_bytes) return true;
  if (out.size() >= most_bytes) return false;
  out.reserve(std::min(most_bytes, std::max(kFirstRoom_bytes, 2 * out.capacity())));
  return true;
}

std::size_t room(const Buffer& out, std::size_t most_bytes) {
  return std::min(out.capacity(), most_bytes) - out.size();
}

struct Bzip2 {
  Bzip2() {
    if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  ~Bzip2() { BZ2_bzDecompressEnd(&stream); }
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;
  bz_stream stream = {};
};

std::string unpack_bzip2(ByteSpan packed, std::size_t most_bytes, Buffer& out) {
  Bzip2 bzip2;
  bz_stream& stream = bzip2.stream;
  // The library's interface has no const; it does not write there.
  stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(packed.data()));
  stream.avail_in = static_cast<unsigned>(
      std::min<std::size_t>(packed.size(), std::numeric_limits<unsigned>::max()));
  char beyond = 0;  // one byte more than claimed shows that the claim is wrong
  while (true) {
    const bool has_room = make_room(out, most_bytes);
    const std::size_t space =
        has_room ? std::min<std::size_t>(room(out, most_bytes), std::size_t{1} << 30) : 1;
    stream.next_out = has_room ? reinterpret_cast<char*>(out.data() + out.size()) : &beyond;
    stream.avail_out = static_cast<unsigned>(space);
    const int state = BZ2_bzDecompress(&stream);
    const std::size_t got = space - stream.avail_out;
    if (has_room) {
      out.resize(out.size() + got);
    } else if (got > 0) {
      return kTooLong;
    }
    if (state == BZ_STREAM_END) return "";
    if (state != BZ_OK) return "its bzip2 data is damaged";
    if (got == 0 && stream.avail_in == 0) return kCutShort;
  }
}

}  // namespace

std::optional<Packing> packing_of(std::string_view name) {
  if (name.empty() || name == "none") return Packing::none;
  if (name == "bz2") return Packing::bz2;
  if (name == "lz4") return Packing::lz4;
  if (name == "zstd") return Packing::zstd;
  return std::nullopt;
}

const char* name_of(Packing packing) {
  switch (packing) {
    case Packing::bz2:
      return "bz2";
    case Packing::lz4:
      return "lz4";
    case Packing::zstd:
      return "zstd";
    case Packing::none:
      break;
  }
  return "not packed";
}

bool is_zstd(ByteSpan bytes) { return as_text(bytes).starts_with("\x28\xB5\x2F\xFD"); }

void Unpacker::FreeZstd::operator()(ZSTD_DCtx_s* context) const { ZSTD_freeDCtx(context); }
void Unpacker::FreeLz4::operator()(LZ4F_dctx_s* context) const {
  LZ4F_freeDecompressionContext(context);
}

Unpacker::Unpacker() = default;
Unpacker::~Unpacker() = default;

std::string Unpacker::unpack(Packing packing, ByteSpan packed, std::uint64_t most_bytes,
                             Buffer& out) {
  out.clear();
  const auto most = static_cast<std::size_t>(
      std::min<std::uint64_t>(most_bytes, std::numeric_limits<std::size_t>::max() / 4));
  out.reserve(std::min(most, kFirstRoom_bytes));
  switch (packing) {
    case Packing::bz2:
      return unpack_bzip2(packed, most, out);
    case Packing::lz4:
      return unpack_lz4(packed, most, out);
    case Packing::zstd:
      return unpack_zstd(packed, most, out);
    case Packing::none:
      break;
  }
  if (packed.size() > most) return kTooLong;
  out.resize(packed.size());
  std::copy(packed.begin(), packed.end(), out.data());
  return "";
}

/// One frame or several behind each other. A frame that fits is unpacked at once, without a copy.
std::string Unpacker::unpack_zstd(ByteSpan packed, std::size_t most_bytes, Buffer& out) {
  if (!zstd_) zstd_.reset(ZSTD_createDCtx());
  if (!zstd_) throw std::bad_alloc();
  ZSTD_DCtx_reset(zstd_.get(), ZSTD_reset_session_only);
  ZSTD_inBuffer in = {packed.data(), packed.size(), 0};
  std::byte beyond{};
  std::size_t state = 0;
  while (true) {
    const bool has_room = make_room(out, most_bytes);
    ZSTD_outBuffer target = {&beyond, 1, 0};
    if (has_room) target = {out.data() + out.size(), room(out, most_bytes), 0};
    const std::size_t taken_before = in.pos;
    state = ZSTD_decompressStream(zstd_.get(), &target, &in);
    if (!has_room && target.pos > 0) return kTooLong;
    if (has_room) out.resize(out.size() + target.pos);
    if (ZSTD_isError(state)) return "its zstd data is damaged";
    if (in.pos == in.size && (state == 0 || target.pos < target.size)) break;
    if (target.pos == 0 && in.pos == taken_before) break;
  }
  return state == 0 ? "" : kCutShort;
}

std::string Unpacker::unpack_lz4(ByteSpan packed, std::size_t most_bytes, Buffer& out) {
  if (!lz4_) {
    LZ4F_dctx* context = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION))) {
      throw std::bad_alloc();
    }
    lz4_.reset(context);
  }
  LZ4F_resetDecompressionContext(lz4_.get());
  std::byte beyond{};
  std::size_t state = 1;
  std::size_t position = 0;
  while (true) {
    const bool has_room = make_room(out, most_bytes);
    std::size_t produced = has_room ? room(out, most_bytes) : 1;
    const std::size_t space = produced;
    std::size_t consumed = packed.size() - position;
    // Memory that moves while growing must not be looked back at, so no stableDst.
    state = LZ4F_decompress(lz4_.get(), has_room ? out.data() + out.size() : &beyond, &produced,
                            packed.data() + position, &consumed, nullptr);
    if (LZ4F_isError(state)) return "its lz4 data is damaged";
    position += consumed;
    if (!has_room && produced > 0) return kTooLong;
    if (has_room) out.resize(out.size() + produced);
    if (position == packed.size() && (state == 0 || produced < space)) break;
    if (produced == 0 && consumed == 0) break;
  }
  return state == 0 ? "" : kCutShort;
}

}  // namespace roomatlas::io
