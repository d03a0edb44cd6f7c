// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace roomatlas::architecture {

/// One `#include` of a source file.
struct Include {
  std::string name;     ///< what stands between the quotes or brackets
  bool quoted = false;  ///< "name"; else <name>
  int line = 0;
};

struct SourceFile {
  std::string path;    ///< from the repository's root, such as "src/core/pose2.cpp"
  std::string module;  ///< "core"; "apps" for everything below apps
  std::string text;
};

/// The C++ files below `folder` of the repository ("include", "src", "apps"), by path. Empty
/// where there is no such folder.
[[nodiscard]] std::vector<SourceFile> sources_below(const std::string& folder);

/// The library's files: include and src.
[[nodiscard]] std::vector<SourceFile> library_sources();

[[nodiscard]] std::vector<Include> includes_of(const std::string& text);

[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// Shows a list of findings one a line, so that a failing test says what to mend.
[[nodiscard]] std::string lines_of(const std::vector<std::string>& findings);

}  // namespace roomatlas::architecture
