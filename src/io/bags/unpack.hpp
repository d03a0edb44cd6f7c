// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "buffer.hpp"
#include "byte_cursor.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct ZSTD_DCtx_s;
struct LZ4F_dctx_s;

namespace roomatlas::io {

enum class Packing { none, bz2, lz4, zstd };

/// "", "none", "bz2", "lz4" and "zstd", as the containers call them; nothing for another.
[[nodiscard]] std::optional<Packing> packing_of(std::string_view name);
[[nodiscard]] const char* name_of(Packing packing);
/// The first bytes of data packed by zstd: no CDR message begins so.
[[nodiscard]] bool is_zstd(ByteSpan bytes);

/// Unpacks one piece after another; keeps the libraries' memory for the next one.
class Unpacker {
 public:
  Unpacker();
  ~Unpacker();
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  /// Replaces `out` by what `packed` holds, `most_bytes` of it at most; memory grows with what
  /// comes, not with what is claimed. Returns what is wrong, for people; empty where all is well.
  /// `out` has what came before the fault.
  [[nodiscard]] std::string unpack(Packing packing, ByteSpan packed, std::uint64_t most_bytes,
                                   Buffer& out);

 private:
  std::string unpack_zstd(ByteSpan packed, std::size_t most_bytes, Buffer& out);
  std::string unpack_lz4(ByteSpan packed, std::size_t most_bytes, Buffer& out);

  struct FreeZstd {
    void operator()(ZSTD_DCtx_s* context) const;
  };
  struct FreeLz4 {
    void operator()(LZ4F_dctx_s* context) const;
  };
  std::unique_ptr<ZSTD_DCtx_s, FreeZstd> zstd_;
  std::unique_ptr<LZ4F_dctx_s, FreeLz4> lz4_;
};

}  // namespace roomatlas::io
