// SPDX-License-Identifier: GPL-3.0-or-later
#include "architecture/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace roomatlas::architecture {
namespace {

namespace fs = std::filesystem;

/// include/roomatlas/<module>/..., src/<module>/..., apps/...
std::string module_of(const fs::path& relative) {
  std::vector<std::string> names;
  for (const fs::path& part : relative) names.push_back(part.string());
  if (names.front() == "apps") return "apps";
  const std::size_t at = names.front() == "include" ? 2 : 1;
  return at + 1 < names.size() ? names[at] : "";
}

bool is_cpp(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".hpp" || extension == ".cpp" || extension == ".h" || extension == ".ipp";
}

}  // namespace

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<SourceFile> sources_below(const std::string& folder) {
  const fs::path root = ROOMATLAS_SOURCE_DIR;
  std::vector<SourceFile> sources;
  if (!fs::exists(root / folder)) return sources;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    if (!entry.is_regular_file() || !is_cpp(entry.path())) continue;
    const fs::path relative = fs::relative(entry.path(), root);
    sources.push_back({relative.generic_string(), module_of(relative), read_text(entry.path())});
  }
  std::sort(sources.begin(), sources.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return sources;
}

std::vector<SourceFile> library_sources() {
  std::vector<SourceFile> sources = sources_below("include");
  for (SourceFile& source : sources_below("src")) sources.push_back(std::move(source));
  return sources;
}

std::vector<Include> includes_of(const std::string& text) {
  static const std::regex directive(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    std::smatch found;
    if (std::regex_search(line, found, directive)) {
      includes.push_back({found[2], found[1] == "\"", number});
    }
  }
  return includes;
}

std::string lines_of(const std::vector<std::string>& findings) {
  std::string text;
  for (const std::string& finding : findings) text += "\n  " + finding;
  return text;
}

}  // namespace roomatlas::architecture
