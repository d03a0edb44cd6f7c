// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace roomatlas::io {

/// A file that appears under its name only when it is whole: what is written goes to a temporary
/// name beside it. A device or another special file is not replaced. Every failure throws
/// InputError naming the file and the reason.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path file);
  /// Removes the temporary file unless `commit` has renamed it.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);
  /// Replaces bytes that have been written, from `offset` on. What is written next goes to the end.
  void overwrite(std::uint64_t offset, std::string_view bytes);
  /// Renames the temporary file to the final name, replacing what was there.
  void commit();

 private:
  [[noreturn]] void fail(int error) const;

  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  std::filesystem::path file_;
  std::filesystem::path temporary_;
  std::unique_ptr<std::FILE, Close> stream_;
};

}  // namespace roomatlas::io
