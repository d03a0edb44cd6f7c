// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <zlib.h>

#include <sstream>

#include "roomatlas/io/files/path.hpp"
#include "support/temporary_folder.hpp"
#include "text/line_reader.hpp"

namespace roomatlas::test {
namespace {

std::vector<std::string> read_lines(const Path& file) {
  io::LineReader reader(file);
  std::vector<std::string> lines;
  while (const auto line = reader.next()) lines.emplace_back(*line);
  return lines;
}

/// As the standard library divides it.
std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Lines of all lengths, of so many bytes together.
std::string text_of(std::size_t bytes, std::size_t longest) {
  std::string text;
  for (std::size_t i = 0; text.size() < bytes; ++i) {
    text += std::string(i * 37 % longest, static_cast<char>('a' + i % 26)) + '\n';
  }
  text.resize(bytes);
  return text;
}

/// What is read ahead hangs on how long the file is.
TEST(LineReader, DividesFilesOfAnyLengthAsTheStandardLibraryDoes) {
  const TemporaryFolder folder;
  constexpr std::size_t kReadAtOnce = std::size_t{1} << 16;
  for (const std::size_t around :
       {std::size_t{4096}, kReadAtOnce, 2 * kReadAtOnce, 3 * kReadAtOnce}) {
    for (const std::size_t bytes : {around - 1, around, around + 1}) {
      for (const std::size_t longest : {std::size_t{90}, 2 * around}) {
        const std::string text = text_of(bytes, longest);
        EXPECT_EQ(read_lines(folder.write("plain.txt", text)), lines_of(text)) << bytes;
        const Path packed = folder / "packed.gz";
        const gzFile out = gzopen(packed.c_str(), "wb");
        gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
        gzclose(out);
        EXPECT_EQ(read_lines(packed), lines_of(text)) << bytes;
      }
    }
  }
}

}  // namespace
}  // namespace roomatlas::test
