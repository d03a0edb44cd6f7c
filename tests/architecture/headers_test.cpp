// SPDX-License-Identifier: GPL-3.0-or-later
// That each public header compiles alone is checked by building cmake/header_check.cmake.
#include <gtest/gtest.h>

#include "architecture/source_tree.hpp"

namespace roomatlas::architecture {
namespace {

constexpr const char* kLicenceLine = "// SPDX-License-Identifier: GPL-3.0-or-later\n";

bool is_header(const SourceFile& source) { return source.path.ends_with(".hpp"); }

TEST(Headers, StartWithTheLicenceAndAreIncludedOnce) {
  int headers = 0;
  for (const SourceFile& source : library_sources()) {
    if (!is_header(source)) continue;
    ++headers;
    EXPECT_TRUE(source.text.starts_with(kLicenceLine)) << source.path << ": no SPDX line";
    EXPECT_NE(source.text.find("\n#pragma once\n"), std::string::npos)
        << source.path << ": no #pragma once";
  }
  EXPECT_GT(headers, 0);
}

TEST(Headers, OfTheLibraryPutNoNamespaceIntoOthers) {
  for (const SourceFile& source : library_sources()) {
    if (!is_header(source)) continue;
    EXPECT_EQ(source.text.find("using namespace"), std::string::npos) << source.path;
  }
}

TEST(Sources, StartWithTheLicence) {
  for (const SourceFile& source : library_sources()) {
    EXPECT_TRUE(source.text.starts_with(kLicenceLine)) << source.path << ": no SPDX line";
  }
}

}  // namespace
}  // namespace roomatlas::architecture
