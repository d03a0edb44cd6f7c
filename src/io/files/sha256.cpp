// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"

#include <openssl/evp.h>

#include <array>
#include <fstream>
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

}  // namespace

std::string sha256_of_file(const Path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    throw InputError(file.string() + ": cannot be read; check the path");
  }
  const std::unique_ptr<EVP_MD_CTX, FreeDigest> digest(EVP_MD_CTX_new());
  require(EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr));
  std::vector<char> block(std::size_t{1} << 16);
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    require(
        EVP_DigestUpdate(digest.get(), block.data(), static_cast<std::size_t>(stream.gcount())));
  }
  if (stream.bad()) throw InputError(file.string() + ": cannot be read to its end");
  std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
  unsigned length = 0;
  require(EVP_DigestFinal_ex(digest.get(), hash.data(), &length));
  return hexadecimal(hash.data(), length);
}

}  // namespace roomatlas
