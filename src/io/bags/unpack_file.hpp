// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_file.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace roomatlas::io {

/// A file of its own in the system's folder for such, removed at the end.
class TemporaryFile {
 public:
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Throws InputError, for instance where the disk is full.
  void write(ByteSpan bytes);

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Unpacks a file packed by zstd. `is_wanted` is asked about the first bytes; where it says no,
/// nothing more is unpacked and the answer is false. `fault` says what was wrong; what came before
/// it is there.
[[nodiscard]] bool unpack_file(BagFile& packed, TemporaryFile& unpacked,
                               const std::function<bool(std::string_view beginning)>& is_wanted,
                               std::string& fault);

}  // namespace roomatlas::io
