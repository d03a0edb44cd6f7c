// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "buffer.hpp"
#include "byte_cursor.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace roomatlas::io {

/// A file that is read at any place, of any size. Failures of the disk throw InputError.
class BagFile {
 public:
  /// Throws InputError where the file is missing, a folder, no regular file, or unreadable.
  /// `shown_name` is its name in messages.
  BagFile(const std::filesystem::path& file, std::string shown_name);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }  ///< in bytes, when it was opened

  /// Fills `into` from `offset` on. Returns how many bytes there were: fewer at the file's end
  /// only.
  std::size_t read(std::uint64_t offset, std::span<std::byte> into) const;
  /// The bytes at `offset`, fewer at the file's end only; valid until the next call of `view`.
  /// Reads ahead where the places come one after another, and little where they are far apart.
  ByteSpan view(std::uint64_t offset, std::size_t bytes);

 private:
  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  Buffer window_;
  std::uint64_t window_offset_ = 0;
};

}  // namespace roomatlas::io
