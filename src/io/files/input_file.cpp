// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/files/input_file.hpp"

#include "roomatlas/core/issue.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>

namespace roomatlas {

PipeWatch::PipeWatch(const Path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (std::filesystem::is_fifo(status)) {
    constexpr int kPatience_ms = 5000;
    descriptor_ = ::open(file.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    ::pollfd one{descriptor_, POLLIN, 0};
    if (descriptor_ < 0 || ::poll(&one, 1, kPatience_ms) > 0) return;
    ::close(descriptor_);
    throw InputError(file.string() +
                     ": is a pipe from which nothing came for 5 s: name a file, or a pipe into "
                     "which something writes");
  }
  if (std::filesystem::exists(status) && std::filesystem::is_other(status)) {
    throw InputError(file.string() + ": is a device or another special file: name a file");
  }
}

PipeWatch::~PipeWatch() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void require_regular_file(const Path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status) || std::filesystem::is_directory(status) ||
      std::filesystem::is_regular_file(status)) {
    return;
  }
  throw InputError(file.string() +
                   ": is not a regular file, and is read more than once: save it to a file first");
}

std::string read_text_file(const Path& file) {
  auto watch = std::make_unique<PipeWatch>(file);
  std::ifstream stream(file, std::ios::binary);
  watch.reset();
  std::error_code error;
  if (!stream || std::filesystem::is_directory(file, error)) {
    throw InputError(file.string() + ": cannot be opened: is it there, and a file?");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace roomatlas
