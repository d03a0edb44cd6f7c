// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_file.hpp"

#include "locked_file.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace roomatlas {
namespace io {
OutputFile::OutputFile(std::filesystem::path file)
    : file_(std::move(file)), temporary_(file_.string() + ".part") {
  std::error_code error;
  const auto status = std::filesystem::status(file_, error);
  if (std::filesystem::is_directory(status)) fail(EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw InputError(
        file_.string() +
        ": is a device or another special file, which is not replaced: choose another");
  }
  errno = 0;
  const LockedFile opened = open_locked(temporary_);
  if (opened.is_taken) {
    ::close(opened.descriptor);
    throw InputError(file_.string() +
                     ": another run is writing it, and nothing was touched: wait until it has "
                     "ended, or choose another name");
  }
  if (opened.descriptor < 0) fail(opened.error);
  if (::ftruncate(opened.descriptor, 0) != 0) fail(errno);
  stream_.reset(::fdopen(opened.descriptor, "wb"));
  if (!stream_) fail(errno);
}

OutputFile::~OutputFile() {
  if (!stream_) return;
  stream_.reset();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void OutputFile::write(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stream_.get()) != text.size()) fail(errno);
}

void OutputFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  errno = 0;
  if (::fseeko(stream_.get(), static_cast<::off_t>(offset), SEEK_SET) != 0) fail(errno);
  write(bytes);
  if (::fseeko(stream_.get(), 0, SEEK_END) != 0) fail(errno);
}

void OutputFile::commit() {
  errno = 0;
  if (std::fflush(stream_.get()) != 0) fail(errno);
  std::error_code error;
  std::filesystem::rename(temporary_, file_, error);
  if (error) fail(error.value());
  stream_.reset();
}

void OutputFile::fail(int error) const {
  const std::string reason = std::strerror(error != 0 ? error : EIO);
  throw InputError(file_.string() + ": cannot be written: " + reason +
                   "; check the folder, its permissions and the free space");
}

}  // namespace io

void write_file(const Path& file, const std::string& content) {
  io::OutputFile output(file);
  output.write(content);
  output.commit();
}

void create_like(const Path& file, const Path& model) {
  std::error_code error;
  std::filesystem::remove(file, error);
  const int descriptor =
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (descriptor < 0) {
    throw InputError(file.string() + ": cannot be made: " + std::strerror(errno) +
                     "; check the folder, its permissions and the free space");
  }
  ::close(descriptor);
  give_permissions_of(model, file);
}

void give_permissions_of(const Path& model, const Path& file) {
  std::error_code error;  // of a file system without permissions
  const auto permissions = std::filesystem::status(model, error).permissions();
  if (error) return;
  std::filesystem::permissions(file, permissions | std::filesystem::perms::owner_write, error);
}

}  // namespace roomatlas
