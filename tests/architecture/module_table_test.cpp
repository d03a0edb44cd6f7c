// SPDX-License-Identifier: GPL-3.0-or-later
#include "architecture/module_table.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <regex>
#include <sstream>

#include "architecture/source_tree.hpp"

namespace roomatlas::architecture {
namespace {

/// The module of "roomatlas/<module>/file.hpp"; empty for any other include.
std::string included_module(const std::string& name) {
  static const std::regex ours("^roomatlas/([^/]+)/.+");
  std::smatch found;
  return std::regex_match(name, found, ours) ? found[1].str() : "";
}

/// What a file of the library includes against the table. A quoted include that is not
/// roomatlas/<module>/... is a private header and must stand in the file's own folder: there is
/// no way round the table through "../other/private.hpp".
std::vector<std::string> broken_rules(const SourceFile& source) {
  std::vector<std::string> findings;
  const auto row = kMayInclude.find(source.module);
  if (row == kMayInclude.end()) return {source.path + ": no module '" + source.module + "'"};
  for (const Include& include : includes_of(source.text)) {
    const std::string at = source.path + ":" + std::to_string(include.line) + ": ";
    const std::string module = included_module(include.name);
    if (module.empty()) {
      if (include.quoted && include.name.find('/') != std::string::npos) {
        findings.push_back(at + "neither public nor in the same folder: " + include.name);
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

TEST(ModuleTable, IsKeptByWhatEachModuleLinks) {
  const std::string cmake = read_text(std::string(ROOMATLAS_SOURCE_DIR) + "/src/CMakeLists.txt");
  const std::regex call(R"(roomatlas_module\((\w+)([^)]*)\))");
  int modules = 0;
  for (std::sregex_iterator it(cmake.begin(), cmake.end(), call), end; it != end; ++it, ++modules) {
    const std::string module = (*it)[1];
    ASSERT_TRUE(kMayInclude.contains(module)) << module;
    std::istringstream words((*it)[2].str());
    for (std::string word; words >> word && word != "LIBRARIES";) {
      if (word == "USES") continue;
      EXPECT_TRUE(kMayInclude.at(module).contains(word)) << module << " links " << word;
    }
  }
  EXPECT_GT(modules, 0);
}

TEST(ModuleTable, CheckSeesAForbiddenModuleAndAWayRound) {
  const auto count = [](const std::string& module, const std::string& text) {
    return broken_rules({"src/" + module + "/a.cpp", module, text}).size();
  };
  EXPECT_EQ(count("core", "#include \"roomatlas/core/issue.hpp\"\n#include <vector>\n"), 0U);
  EXPECT_EQ(count("core", "#include \"roomatlas/grid/himm.hpp\"\n"), 1U);
  EXPECT_EQ(count("core", "  #  include <roomatlas/grid/himm.hpp>\n"), 1U);
  EXPECT_EQ(count("merge", "#include \"roomatlas/evaluate/evaluate.hpp\"\n"), 1U);
  EXPECT_EQ(count("evaluate", "#include \"roomatlas/merge/merge.hpp\"\n"), 0U);
  EXPECT_EQ(count("grid", "#include \"../asr/private.hpp\"\n"), 1U);
  EXPECT_EQ(count("grid", "#include \"private.hpp\"\n"), 0U);
  EXPECT_EQ(count("grid", "// #include \"roomatlas/asr/asr.hpp\"\n"), 0U);
  EXPECT_EQ(count("unheard_of", ""), 1U);
}

}  // namespace
}  // namespace roomatlas::architecture
