// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace roomatlas::io {

/// Reads a text file line by line, plain or gzip (told by content). Memory is constant. Lines end
/// with "\n", "\r\n", or, in a file whose first block has no "\n", with "\r".
class LineReader {
 public:
  enum class End {
    not_reached,
    complete,
    cut_short,       ///< gzip data that stops in the middle
    damaged,         ///< gzip data that does not decode
    wrong_checksum,  ///< gzip data that decodes, but not to what was packed
  };

  static constexpr const char* kWrongChecksumMessage =
      "its gzip data is damaged, nobody knows where: its checksum does not fit, so that any line "
      "may be wrong. Copy the file again";
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20;  ///< in bytes

  /// Throws InputError naming the file when it is missing, a directory, unreadable, empty, or not
  /// text (its first block has NUL or many control characters).
  explicit LineReader(const std::filesystem::path& file);

  /// The next line without its end, valid until the next call; nothing at the end. Throws
  /// InputError for gzip data that unpacks to more than anybody wrote.
  [[nodiscard]] std::optional<std::string_view> next();
  /// 1-based number of the line that `next` returned last.
  [[nodiscard]] std::int64_t line_number() const { return line_number_; }
  /// False for a last line that has no line end.
  [[nodiscard]] bool line_is_terminated() const { return line_is_terminated_; }
  /// True when the line was longer than `kLongestLine`: `next` then returned it empty.
  [[nodiscard]] bool line_is_too_long() const { return line_is_too_long_; }
  [[nodiscard]] End end() const { return end_; }
  /// Share of the file's bytes consumed, [0, 1]; 0 where the size is unknown.
  [[nodiscard]] double progress() const;

 private:
  struct GzFile;  ///< zlib's handle, closed by its destructor
  struct GzFileDelete {
    void operator()(GzFile* file) const;
  };

  void fill();
  void find_line_end();
  void check_growth() const;
  void check_first_block() const;
  std::string_view take(std::size_t length, bool terminated);
  std::string_view skip_long_line();

  std::string name_;
  std::uintmax_t file_bytes_ = 0;
  std::unique_ptr<GzFile, GzFileDelete> file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  ///< of what has not been handed out
  std::size_t filled_ = 0;
  char line_end_ = '\n';
  std::uint64_t unpacked_bytes_ = 0;
  std::int64_t line_number_ = 0;
  bool line_is_terminated_ = true;
  bool line_is_too_long_ = false;
  End end_ = End::not_reached;
};

}  // namespace roomatlas::io
