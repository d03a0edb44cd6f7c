// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/feature_ids.hpp"

#include <openssl/evp.h>

#include <stdexcept>
#include <string_view>

namespace roomatlas {
namespace {

constexpr std::string_view kHexadecimal = "0123456789abcdef";
constexpr std::string_view kIfc =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";

}  // namespace

std::string Uuid::text() const {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i == 4 || i == 6 || i == 8 || i == 10) text += '-';
    text += kHexadecimal[bytes[i] >> 4U];
    text += kHexadecimal[bytes[i] & 15U];
  }
  return text;
}

std::string Uuid::ifc() const {
  // The first byte makes two characters, and each three that follow make four.
  std::string text;
  const auto add = [&](std::uint32_t value, unsigned characters) {
    for (unsigned i = characters; i-- > 0;) text += kIfc[(value >> (6U * i)) & 63U];
  };
  add(bytes[0], 2);
  for (std::size_t i = 1; i < bytes.size(); i += 3) {
    add((std::uint32_t{bytes[i]} << 16U) | (std::uint32_t{bytes[i + 1]} << 8U) | bytes[i + 2], 4);
  }
  return text;
}

Uuid FeatureIds::of(const std::string& thing) const {
  const std::string name = building_ + '\n' + thing;
  std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
  if (EVP_Digest(name.data(), name.size(), hash.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 is not available");
  }
  Uuid id;
  for (std::size_t i = 0; i < id.bytes.size(); ++i) id.bytes[i] = hash[i];
  id.bytes[6] = static_cast<std::uint8_t>((id.bytes[6] & 0x0fU) | 0x40U);  // version 4
  id.bytes[8] = static_cast<std::uint8_t>((id.bytes[8] & 0x3fU) | 0x80U);  // RFC 4122's variant
  return id;
}

}  // namespace roomatlas
