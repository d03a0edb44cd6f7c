// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace roomatlas::io {

/// Puts files into a ZIP archive, uncompressed and dated 1980-01-01, so that the same content
/// gives the same bytes (PKWARE's APPNOTE, sections 4.3.7, 4.3.12, 4.3.16). No ZIP64: an archive
/// beyond 4 GiB or 65535 files throws std::length_error.
class ZipWriter {
 public:
  void add(const std::string& name, const std::string& content);
  /// The whole archive. Nothing may be added afterwards.
  [[nodiscard]] std::string finish();

 private:
  std::string files_;
  std::string directory_;
  std::uint32_t count_ = 0;
};

}  // namespace roomatlas::io
