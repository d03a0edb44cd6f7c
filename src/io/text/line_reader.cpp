// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_reader.hpp"
#include "files/unpack_bounds.hpp"

#include "text/binary_files.hpp"

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/input_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace roomatlas::io {

struct LineReader::GzFile {
  gzFile handle = nullptr;
};

void LineReader::GzFileDelete::operator()(GzFile* file) const {
  gzclose_r(file->handle);
  delete file;
}

namespace {

constexpr std::size_t kTextPerControl = 20;           // bytes; more control characters are no text
constexpr std::size_t kBlock = std::size_t{1} << 16;  // bytes read at once

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && std::strchr("\t\n\v\f\r", byte) == nullptr) || byte == 0x7f;
}

/// What is read ahead: no more than a short file has, since logs are opened several times each.
std::size_t read_ahead(std::uintmax_t file_bytes, bool is_plain) {
  constexpr std::uintmax_t kPage = 4096;
  if (!is_plain || file_bytes >= 2 * kBlock) return 2 * kBlock;
  return static_cast<std::size_t>(std::max(file_bytes, kPage));
}

/// 0 where that is not known, as of a pipe.
std::uintmax_t bytes_of(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  return error ? 0 : bytes;
}

gzFile open_or_throw(const std::filesystem::path& file, std::uintmax_t file_bytes) {
  const std::string name = file.string();
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    throw InputError(name + ": there is no such file; check the path");
  }
  if (std::filesystem::is_directory(status)) {
    throw InputError(name + ": is a directory; name a file inside it");
  }
  const PipeWatch watch(file);
  errno = 0;
  gzFile handle = gzopen(name.c_str(), "rb");
  if (handle == nullptr) {
    throw InputError(name + ": cannot be opened: " + std::strerror(errno != 0 ? errno : ENOMEM));
  }
  gzbuffer(handle, static_cast<unsigned>(read_ahead(file_bytes, file_bytes > 0)));
  return handle;
}

}  // namespace

LineReader::LineReader(const std::filesystem::path& file)
    : name_(file.string()),
      file_bytes_(bytes_of(file)),
      file_(new GzFile{open_or_throw(file, file_bytes_)}),
      buffer_(read_ahead(file_bytes_, file_bytes_ > 0 && gzdirect(file_->handle) == 1)) {
  fill();
  check_first_block();
  find_line_end();
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (std::string_view(buffer_.data(), filled_).starts_with(kByteOrderMark)) {
    begin_ = kByteOrderMark.size();
  }
}

void LineReader::check_first_block() const {
  if (filled_ == 0) {
    if (end_ == End::complete) throw InputError(name_ + ": is empty; nothing was recorded in it");
    throw InputError(name_ +
                     ": its gzip data is damaged or cut short at the very beginning; "
                     "copy the file again");
  }
  const auto end = buffer_.begin() + static_cast<std::ptrdiff_t>(filled_);
  const bool has_nul = std::find(buffer_.begin(), end, '\0') != end;
  const auto controls = static_cast<std::size_t>(std::count_if(buffer_.begin(), end, is_control));
  const std::string kind = binary_kind({buffer_.data(), filled_}, gzdirect(file_->handle) == 0);
  if (!kind.empty()) throw InputError(name_ + ": " + kind);
  if (has_nul || controls * kTextPerControl > filled_) {
    throw InputError(name_ + ": is a binary file; expected text, plain or gzip");
  }
}

/// Old tools on old systems ended lines with "\r" alone. One at the very end may belong to "\r\n".
void LineReader::find_line_end() {
  const std::string_view block(buffer_.data(), filled_);
  const std::size_t carriage_return = block.find('\r');
  if (block.find('\n') == std::string_view::npos && carriage_return < filled_ - 1) {
    line_end_ = '\r';
  }
}

/// Moves what is left to the front and reads one more block behind it.
void LineReader::fill() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, filled_ - begin_);
    filled_ -= begin_;
    begin_ = 0;
  }
  const std::size_t room = std::min(kBlock, buffer_.size() - filled_);
  const int got = gzread(file_->handle, buffer_.data() + filled_, static_cast<unsigned>(room));
  if (got > 0) {
    filled_ += static_cast<std::size_t>(got);
    unpacked_bytes_ += static_cast<std::uint64_t>(got);
    check_growth();
    return;
  }
  int error = Z_OK;
  const std::string_view message = gzerror(file_->handle, &error);
  end_ = error == Z_BUF_ERROR ? End::cut_short : got < 0 ? End::damaged : End::complete;
  if (end_ == End::damaged && message.ends_with("check")) end_ = End::wrong_checksum;
}

void LineReader::check_growth() const {
  const auto packed = static_cast<std::uint64_t>(std::max<z_off_t>(0, gzoffset(file_->handle)));
  if (unpacked_bytes_ <= most_unpacked_bytes(packed, kMostGrowth)) return;
  throw InputError(name_ + ": its gzip data grows to more than " + std::to_string(kMostGrowth) +
                   " times its size: expected a text that somebody wrote. If it is one, unpack it "
                   "with `gunzip`");
}

std::optional<std::string_view> LineReader::next() {
  std::size_t searched = 0;
  while (true) {
    const char* const start = buffer_.data() + begin_;
    const std::size_t available = filled_ - begin_;
    const void* const found = std::memchr(start + searched, line_end_, available - searched);
    if (found != nullptr) {
      return take(static_cast<std::size_t>(static_cast<const char*>(found) - start), true);
    }
    if (available == kLongestLine) return skip_long_line();
    if (available == buffer_.size()) buffer_.resize(std::min(2 * available, kLongestLine));
    if (end_ != End::not_reached) {
      if (available == 0) return std::nullopt;
      return take(available, false);
    }
    searched = available;
    fill();
  }
}

std::string_view LineReader::take(std::size_t length, bool terminated) {
  std::string_view line(buffer_.data() + begin_, length);
  begin_ += length + (terminated ? 1 : 0);
  if (line.ends_with('\r')) line.remove_suffix(1);
  ++line_number_;
  line_is_terminated_ = terminated;
  line_is_too_long_ = false;
  return line;
}

std::string_view LineReader::skip_long_line() {
  ++line_number_;
  line_is_terminated_ = line_is_too_long_ = true;
  begin_ = filled_;
  while (end_ == End::not_reached) {
    fill();
    const void* const found = std::memchr(buffer_.data(), line_end_, filled_);
    if (found != nullptr) {
      begin_ = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data()) + 1;
      break;
    }
    begin_ = filled_;
  }
  return {};
}

double LineReader::progress() const {
  if (end_ != End::not_reached) return 1.0;
  if (file_bytes_ == 0) return 0.0;
  const auto consumed = static_cast<double>(std::max<z_off_t>(0, gzoffset(file_->handle)));
  return std::min(1.0, consumed / static_cast<double>(file_bytes_));
}

}  // namespace roomatlas::io
