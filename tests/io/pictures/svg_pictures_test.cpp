// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/pictures/svg_pictures.hpp"
#include "roomatlas/core/issue.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace roomatlas {
namespace {

const std::string kSvg =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="50.8mm" height="25.4mm" viewBox="0 0 2 1">)"
    R"(<rect width="1" height="1" fill="#ff0000"/></svg>)";

std::string read(const Path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
  }
  return value;
}

Path temporary(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("roomatlas_" + name);
}

TEST(Png, HasTheSizeThatTheResolutionGives) {
  const Path file = temporary("size.png");
  write_png(file, kSvg, 100.0);
  const std::string bytes = read(file);
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(big_endian(bytes, 16), 200U);
  EXPECT_EQ(big_endian(bytes, 20), 100U);
  std::filesystem::remove(file);
}

TEST(Png, IsNotBlankAndTheSameEveryTime) {
  const Path file = temporary("drawn.png");
  write_png(file, kSvg, 50.0);
  const std::string drawn = read(file);
  write_png(file, kSvg, 50.0);
  EXPECT_EQ(read(file), drawn);
  const std::string blank_svg = kSvg.substr(0, kSvg.find("<rect")) + "</svg>";
  write_png(file, blank_svg, 50.0);
  EXPECT_NE(read(file), drawn);
  std::filesystem::remove(file);
}

TEST(Png, IsDrawnOfAnElementOfMoreThanTenMegabytes) {
  const std::string svg = kSvg.substr(0, kSvg.rfind("</svg>")) + R"(<rect fill="none" id=")" +
                          std::string(11'000'000, 'x') + R"("/></svg>)";
  const Path file = temporary("large.png");
  EXPECT_NO_THROW(write_png(file, svg, 25.4));
  EXPECT_EQ(read(file).substr(1, 3), "PNG");
}

TEST(Pdf, HasTheSizeOnPaperThatTheDocumentStatesAndTheSameBytesEveryTime) {
  const Path file = temporary("drawn.pdf");
  write_pdf(file, kSvg, "Two squares", "2003-02-19");
  const std::string drawn = read(file);
  EXPECT_EQ(drawn.substr(0, 5), "%PDF-");
  const std::string page = "/MediaBox [ 0 0 ";
  const std::size_t at = drawn.find(page);
  ASSERT_NE(at, std::string::npos);
  std::istringstream points(drawn.substr(at + page.size(), 40));
  double width = 0.0;
  double height = 0.0;
  points >> width >> height;
  EXPECT_NEAR(width, 144.0, 0.01);
  EXPECT_NEAR(height, 72.0, 0.01);
  EXPECT_NE(drawn.find("20030219000000Z"), std::string::npos);
  write_pdf(file, kSvg, "Two squares", "2003-02-19");
  EXPECT_EQ(read(file), drawn);
  std::filesystem::remove(file);
}

TEST(Pdf, WithoutADateSaysNothingOfThePresent) {
  const Path file = temporary("undated.pdf");
  write_pdf(file, kSvg, "Two squares", "");
  EXPECT_NE(read(file).find("19700101000000Z"), std::string::npos);
  std::filesystem::remove(file);
}

TEST(Png, WhatCannotBeDrawnOrWrittenIsAnInputError) {
  EXPECT_THROW(write_png(temporary("bad.png"), "no svg at all", 100.0), InputError);
  EXPECT_THROW(write_png(temporary("huge.png"), kSvg, 1e9), InputError);
  EXPECT_THROW(write_png(temporary("zero.png"), kSvg, 0.0), InputError);
  EXPECT_THROW(write_png("/no/such/folder/picture.png", kSvg, 50.0), InputError);
  EXPECT_FALSE(std::filesystem::exists(temporary("bad.png")));
}

}  // namespace
}  // namespace roomatlas
