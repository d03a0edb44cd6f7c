// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"
#include "unpack_bounds.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

namespace roomatlas {
namespace {

struct FreeDigest {
  void operator()(EVP_MD_CTX* digest) const { EVP_MD_CTX_free(digest); }
};

std::string hexadecimal(const unsigned char* bytes, unsigned count) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4U];
    text += kDigits[bytes[i] & 15U];
  }
  return text;
}

void require(int openssl_result) {
  if (openssl_result != 1) throw std::runtime_error("SHA-256 is not available");
}

/// SHA-256 of what is added.
class Digest {
 public:
  Digest() { require(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr)); }

  void add(std::string_view bytes) {
    require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
  }
  void add_content(const Path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file)) {
      throw InputError(file.string() + ": cannot be read; check the path");
    }
    std::vector<char> block(std::size_t{1} << 16);
    while (stream) {
      stream.read(block.data(), static_cast<std::streamsize>(block.size()));
      add({block.data(), static_cast<std::size_t>(stream.gcount())});
    }
    if (stream.bad()) throw InputError(file.string() + ": cannot be read to its end");
  }
  [[nodiscard]] std::string taken() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
    unsigned length = 0;
    require(EVP_DigestFinal_ex(context_.get(), hash.data(), &length));
    return hexadecimal(hash.data(), length);
  }

 private:
  std::unique_ptr<EVP_MD_CTX, FreeDigest> context_{EVP_MD_CTX_new()};
};

struct CloseGzip {
  void operator()(gzFile file) const { gzclose_r(file); }
};

/// Of what was packed; nothing where the file is plain, damaged, or grows to more than a text does.
std::optional<std::string> sha256_of_packed(const Path& file) {
  const std::unique_ptr<gzFile_s, CloseGzip> packed(gzopen(file.c_str(), "rb"));
  if (!packed || gzdirect(packed.get()) != 0) return std::nullopt;
  Digest digest;
  std::vector<char> block(std::size_t{1} << 16);
  std::uint64_t unpacked_bytes = 0;
  while (true) {
    const int got = gzread(packed.get(), block.data(), static_cast<unsigned>(block.size()));
    if (got < 0) return std::nullopt;
    if (got == 0) break;
    digest.add({block.data(), static_cast<std::size_t>(got)});
    unpacked_bytes += static_cast<std::uint64_t>(got);
    const auto packed_bytes =
        static_cast<std::uint64_t>(std::max<z_off_t>(0, gzoffset(packed.get())));
    if (unpacked_bytes > io::most_unpacked_bytes(packed_bytes, io::kMostGrowth)) {
      return std::nullopt;
    }
  }
  int error = Z_OK;
  (void)gzerror(packed.get(), &error);
  return error == Z_OK ? std::optional(digest.taken()) : std::nullopt;  // else it is cut short
}

}  // namespace

std::vector<Path> files_of_log(const Path& log) {
  if (!std::filesystem::is_directory(log)) return {log};
  std::vector<Path> parts;
  for (const auto& entry : std::filesystem::directory_iterator(log)) {
    const std::string ending = entry.path().extension().string();
    const bool is_part = ending == ".yaml" || ending == ".db3" || ending == ".mcap" ||
                         ending == ".zstd" || ending == ".bag";
    if (is_part && entry.is_regular_file()) parts.push_back(entry.path());
  }
  if (parts.empty()) {
    throw InputError(log.string() + ": is a directory and no recording; name a file inside it");
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

std::string sha256_of_file(const Path& file) {
  const bool is_folder = std::filesystem::is_directory(file);
  if (!is_folder) {
    if (auto of_content = sha256_of_packed(file)) return *of_content;
  }
  Digest digest;
  if (is_folder) {
    for (const Path& part : files_of_log(file)) {
      digest.add(part.filename().string() + '\0');
      digest.add(std::to_string(std::filesystem::file_size(part)) + '\0');
      digest.add_content(part);
    }
  } else {
    digest.add_content(file);
  }
  return digest.taken();
}

}  // namespace roomatlas
