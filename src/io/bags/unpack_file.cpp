// SPDX-License-Identifier: GPL-3.0-or-later
#include "unpack_file.hpp"
#include "files/unpack_bounds.hpp"

#include "roomatlas/core/issue.hpp"

#include <unistd.h>
#include <zstd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace roomatlas::io {
namespace {

constexpr std::size_t kBlock_bytes = std::size_t{1} << 20;
// Enough for every kind of recording; a first block holds it.
constexpr std::size_t kBeginning_bytes = 16;

}  // namespace

TemporaryFile::TemporaryFile() {
  std::string name = (std::filesystem::temp_directory_path() / "roomatlas-XXXXXX").string();
  descriptor_ = ::mkstemp(name.data());
  if (descriptor_ < 0) {
    throw InputError(name + ": cannot be written: " + std::strerror(errno) +
                     "; packed recordings are unpacked there: set TMPDIR to another folder");
  }
  path_ = name;
}

TemporaryFile::~TemporaryFile() {
  ::close(descriptor_);
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void TemporaryFile::write(ByteSpan bytes) {
  while (!bytes.empty()) {
    const ::ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      throw InputError(path_.string() + ": cannot be written: " + std::strerror(errno) +
                       "; packed recordings are unpacked there: set TMPDIR to a folder with room, "
                       "or unpack the recording with `unzstd`");
    }
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

bool unpack_file(BagFile& packed, TemporaryFile& unpacked,
                 const std::function<bool(std::string_view)>& is_wanted, std::string& fault) {
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(),
                                                                     ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  Buffer in;
  Buffer out;
  out.resize(kBlock_bytes);
  bool is_asked = false;
  std::size_t state = 1;
  std::uint64_t unpacked_bytes = 0;
  for (std::uint64_t offset = 0; offset < packed.size();) {
    in.resize(kBlock_bytes);
    in.resize(packed.read(offset, in.span()));
    if (in.size() == 0) break;
    offset += in.size();
    ZSTD_inBuffer source = {in.data(), in.size(), 0};
    bool has_more = true;  // what came may be waiting behind a full block
    while (source.pos < source.size || has_more) {
      ZSTD_outBuffer target = {out.data(), out.size(), 0};
      state = ZSTD_decompressStream(context.get(), &target, &source);
      if (ZSTD_isError(state)) {
        fault = "its zstd data is damaged: what is behind that was left out";
        return is_asked;
      }
      has_more = target.pos == target.size;
      const ByteSpan got = ByteSpan(out.span()).first(target.pos);
      if (!is_asked && got.size() >= kBeginning_bytes) {
        if (!is_wanted(as_text(got.first(kBeginning_bytes)))) return false;
        is_asked = true;
      }
      if (is_asked) unpacked.write(got);
      unpacked_bytes += got.size();
      if (unpacked_bytes > most_unpacked_bytes(offset, kMostGrowthStreamed)) {
        throw InputError(packed.name() + ": its zstd data grows to more than " +
                         std::to_string(kMostGrowthStreamed) +
                         " times its size: expected a recording. If it is one, unpack it with "
                         "`unzstd`");
      }
    }
  }
  if (state != 0) fault = "its zstd data ends early: it was cut short";
  return is_asked;
}

}  // namespace roomatlas::io
