// SPDX-License-Identifier: GPL-3.0-or-later
#include "zip_writer.hpp"

#include <zlib.h>

#include <limits>
#include <stdexcept>

namespace roomatlas::io {
namespace {

constexpr std::uint32_t kFileSignature = 0x04034b50;       // "PK", and 3, 4
constexpr std::uint32_t kDirectorySignature = 0x02014b50;  // "PK", and 1, 2
constexpr std::uint32_t kEndSignature = 0x06054b50;        // "PK", and 5, 6
constexpr std::uint32_t kVersion = 20;                     // 2.0
constexpr std::uint32_t kNamesAreUtf8 = 1U << 11U;         // bit of the flags
constexpr std::uint32_t kDate = (1U << 5U) | 1U;           // 1 January of year 0, which is 1980

void put(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xffU);
}

std::uint32_t size_of(const std::string& bytes) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("an archive of this size needs ZIP64");
  }
  return static_cast<std::uint32_t>(bytes.size());
}

/// What a file's own heading and its entry in the directory have in common.
std::string description(const std::string& name, const std::string& content) {
  std::string bytes;
  const auto* data = reinterpret_cast<const Bytef*>(content.data());
  const uLong checksum = crc32_z(crc32_z(0, nullptr, 0), data, content.size());
  put(bytes, kVersion, 2);
  put(bytes, kNamesAreUtf8, 2);
  put(bytes, 0, 2);  // stored
  put(bytes, 0, 2);  // midnight
  put(bytes, kDate, 2);
  put(bytes, static_cast<std::uint32_t>(checksum), 4);
  put(bytes, size_of(content), 4);
  put(bytes, size_of(content), 4);
  put(bytes, size_of(name), 2);
  put(bytes, 0, 2);  // no extra field
  return bytes;
}

}  // namespace

void ZipWriter::add(const std::string& name, const std::string& content) {
  const std::string described = description(name, content);
  put(directory_, kDirectorySignature, 4);
  put(directory_, kVersion, 2);
  directory_ += described;
  for (int field = 0; field < 3; ++field) put(directory_, 0, 2);  // comment, disk, attributes
  put(directory_, 0, 4);                                          // no outer attributes
  put(directory_, size_of(files_), 4);
  directory_ += name;

  put(files_, kFileSignature, 4);
  files_ += described + name + content;
  if (++count_ > std::numeric_limits<std::uint16_t>::max()) {
    throw std::length_error("an archive of so many files needs ZIP64");
  }
}

std::string ZipWriter::finish() {
  std::string bytes = files_ + directory_;
  put(bytes, kEndSignature, 4);
  put(bytes, 0, 4);  // this disk is the first
  put(bytes, count_, 2);
  put(bytes, count_, 2);
  put(bytes, size_of(directory_), 4);
  put(bytes, size_of(files_), 4);
  put(bytes, 0, 2);  // no comment
  return bytes;
}

}  // namespace roomatlas::io
