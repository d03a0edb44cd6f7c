// SPDX-License-Identifier: GPL-3.0-or-later
#include "architecture/module_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <regex>

#include "architecture/source_tree.hpp"

namespace roomatlas::architecture {
namespace {

/// The module of "roomatlas/<module>/file.hpp"; empty for any other include.
std::string included_module(const std::string& name) {
  static const std::regex ours("^roomatlas/([^/]+)/.+");
  std::smatch found;
  return std::regex_match(name, found, ours) ? found[1].str() : "";
}

/// A private header is named by its place below its module's folder, or beside the file: there is
/// no way round the table through "../other/private.hpp".
bool is_of_the_module(const SourceFile& source, const std::string& private_header) {
  const std::filesystem::path root = ROOMATLAS_SOURCE_DIR;
  const std::filesystem::path folder = (root / source.path).parent_path();
  const bool goes_up = private_header.find("..") != std::string::npos;
  return !goes_up && (private_header.find('/') == std::string::npos ||
                      std::filesystem::exists(root / "src" / source.module / private_header));
}

/// What a file of the library includes against the table.
std::vector<std::string> broken_rules(const SourceFile& source) {
  if (source.path == "include/" + kUmbrella) return {};
  std::vector<std::string> findings;
  const auto row = kMayInclude.find(source.module);
  if (row == kMayInclude.end()) return {source.path + ": no module '" + source.module + "'"};
  for (const Include& include : includes_of(source.text)) {
    const std::string at = source.path + ":" + std::to_string(include.line) + ": ";
    const std::string module = included_module(include.name);
    if (include.name == kUmbrella) {
      findings.push_back(at + "the library does not include its umbrella");
    } else if (module.empty()) {
      if (include.quoted && !is_of_the_module(source, include.name)) {
        findings.push_back(at + "neither public nor of the same module: " + include.name);
      }
    } else if (module != source.module && !row->second.contains(module)) {
      findings.push_back(at + source.module + " may not include " + module);
    }
  }
  return findings;
}

TEST(ModuleTable, IsKeptByEveryFileOfTheLibrary) {
  const std::vector<SourceFile> sources = library_sources();
  ASSERT_FALSE(sources.empty());
  for (const SourceFile& source : sources) {
    const std::vector<std::string> findings = broken_rules(source);
    EXPECT_TRUE(findings.empty()) << lines_of(findings);
  }
}

TEST(ModuleTable, HasNoCycle) {
  std::set<std::string> finished;
  std::set<std::string> open;
  const std::function<bool(const std::string&)> has_no_cycle = [&](const std::string& module) {
    if (finished.contains(module)) return true;
    if (!open.insert(module).second) return false;
    for (const std::string& used : kMayInclude.at(module)) {
      if (!has_no_cycle(used)) return false;
    }
    finished.insert(module);
    return true;
  };
  for (const auto& [module, used] : kMayInclude) EXPECT_TRUE(has_no_cycle(module)) << module;
}

TEST(ModuleTable, AllowsNothingThatNobodyUses) {
  std::map<std::string, std::set<std::string>> used;
  for (const SourceFile& source : library_sources()) {
    for (const Include& include : includes_of(source.text)) {
      used[source.module].insert(included_module(include.name));
    }
  }
  for (const auto& [module, allowed] : kMayInclude) {
    for (const std::string& one : allowed) {
      EXPECT_TRUE(used[module].contains(one))
          << module << " may include " << one << ", but does not";
    }
  }
}

TEST(ModuleTable, ListsEveryModuleThatThereIs) {
  std::set<std::string> modules;
  for (const SourceFile& source : library_sources()) {
    if (!source.module.empty()) modules.insert(source.module);
  }
  std::set<std::string> listed;
  for (const auto& entry : kMayInclude) listed.insert(entry.first);
  EXPECT_EQ(listed, modules);
}

TEST(Files, AreShortEnoughToBeReadAtOnce) {
  constexpr std::ptrdiff_t kMostLines = 350;
  for (const char* folder : {"include", "src", "plugins", "apps", "tests", "bench", "examples"}) {
    for (const SourceFile& source : sources_below(folder)) {
      EXPECT_LE(std::count(source.text.begin(), source.text.end(), '\n'), kMostLines)
          << source.path;
    }
  }
}

TEST(ModuleTable, CheckSeesAForbiddenModuleAndAWayRound) {
  const auto count = [](const std::string& module, const std::string& text) {
    return broken_rules({"src/" + module + "/a.cpp", module, text}).size();
  };
  EXPECT_EQ(count("core", "#include \"roomatlas/core/issue.hpp\"\n#include <vector>\n"), 0U);
  EXPECT_EQ(count("core", "#include \"roomatlas/grid/himm.hpp\"\n"), 1U);
  EXPECT_EQ(count("core", "  #  include <roomatlas/grid/himm.hpp>\n"), 1U);
  EXPECT_EQ(count("merge", "#include \"roomatlas/evaluate/evaluate.hpp\"\n"), 1U);
  EXPECT_EQ(count("evaluate", "#include \"roomatlas/planar/union.hpp\"\n"), 0U);
  EXPECT_EQ(count("io", "#include \"text/numbers.hpp\"\n"), 0U);
  EXPECT_EQ(count("io", "#include \"linearise.hpp\"\n#include \"solve/linearise.hpp\"\n"), 1U);
  EXPECT_EQ(count("grid", "#include \"../asr/private.hpp\"\n"), 1U);
  EXPECT_EQ(count("grid", "#include \"private.hpp\"\n"), 0U);
  EXPECT_EQ(count("grid", "// #include \"roomatlas/asr/asr.hpp\"\n"), 0U);
  EXPECT_EQ(count("io", "#include <roomatlas/roomatlas.hpp>\n"), 1U);
  EXPECT_EQ(count("unheard_of", ""), 1U);
}

TEST(ModuleTable, LetsTheUmbrellaAloneStandOutsideOfTheModules) {
  const std::string text = "#include \"roomatlas/pipeline/assemble.hpp\"\n";
  EXPECT_TRUE(broken_rules({"include/" + kUmbrella, "", text}).empty());
  EXPECT_FALSE(broken_rules({"include/roomatlas/another.hpp", "", text}).empty());
}

}  // namespace
}  // namespace roomatlas::architecture
