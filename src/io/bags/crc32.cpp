// SPDX-License-Identifier: GPL-3.0-or-later
#include "crc32.hpp"

#include <zlib.h>

#include <array>
#include <cstring>

#if defined(__x86_64__) && defined(__GNUC__)
#define ROOMATLAS_HAS_CLMUL 1
#include <immintrin.h>
#endif

namespace roomatlas::io {
namespace {

std::uint32_t by_zlib(ByteSpan bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

#ifdef ROOMATLAS_HAS_CLMUL

constexpr std::size_t kStride_bytes = 64;

/// x to that power modulo the polynomial, its bits in CRC-32's order, as a carry-less product of
/// numbers in that order needs it.
constexpr std::uint64_t power_of_x(int power) {
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;
  std::uint32_t value = 0x80000000U;  // x to the power of 0
  for (int i = 0; i < power; ++i) value = (value >> 1) ^ ((value & 1U) != 0 ? kPolynomial : 0U);
  return std::uint64_t{value} << 1;
}

__m128i load(const std::byte* at) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at)); }

/// What moves 128 bits on by so many.
__attribute__((target("pclmul,sse4.1"))) __m128i mover(int bits) {
  return _mm_set_epi64x(static_cast<long long>(power_of_x(bits - 32)),
                        static_cast<long long>(power_of_x(bits + 32)));
}

__attribute__((target("pclmul,sse4.1"))) __m128i folded(__m128i value, __m128i by, __m128i next) {
  const __m128i low = _mm_clmulepi64_si128(value, by, 0x00);
  const __m128i high = _mm_clmulepi64_si128(value, by, 0x11);
  return _mm_xor_si128(_mm_xor_si128(low, high), next);
}

/// Folds whole strides to 16 bytes with the same remainder (Gopal et al., Intel, 2009), of which
/// zlib then makes the sum.
/// @param bytes one stride or more
__attribute__((target("pclmul,sse4.1"))) std::uint32_t by_folding(ByteSpan bytes,
                                                                  std::uint32_t before) {
  static const __m128i by_stride = mover(8 * kStride_bytes);
  static const __m128i by_one = mover(128);
  const std::byte* at = bytes.data();
  __m128i values[] = {load(at), load(at + 16), load(at + 32), load(at + 48)};
  values[0] = _mm_xor_si128(values[0], _mm_cvtsi32_si128(static_cast<int>(~before)));
  std::size_t left = bytes.size() - kStride_bytes;
  for (; left >= kStride_bytes; left -= kStride_bytes) {
    at += kStride_bytes;
    for (std::size_t i = 0; i < 4; ++i) {
      values[i] = folded(values[i], by_stride, load(at + 16 * i));
    }
  }
  __m128i value = values[0];
  for (std::size_t i = 1; i < 4; ++i) value = folded(value, by_one, values[i]);
  std::array<std::byte, 16> remainder{};
  std::memcpy(remainder.data(), &value, sizeof(value));
  const std::uint32_t folded_crc = by_zlib(remainder, ~0U);
  return by_zlib(bytes.last(left), folded_crc);
}

#endif

}  // namespace

std::uint32_t crc32_of(ByteSpan bytes, std::uint32_t before) {
#ifdef ROOMATLAS_HAS_CLMUL
  static const bool is_there =
      __builtin_cpu_supports("pclmul") != 0 && __builtin_cpu_supports("sse4.1") != 0;
  constexpr std::size_t kWorthIt_bytes = 256;
  if (is_there && bytes.size() >= kWorthIt_bytes) return by_folding(bytes, before);
#endif
  return by_zlib(bytes, before);
}

}  // namespace roomatlas::io
