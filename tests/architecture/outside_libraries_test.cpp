// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "architecture/source_tree.hpp"

namespace roomatlas::architecture {
namespace {

/// What may stand in some folders only. `in_code` is searched in each line outside comments.
struct Rule {
  std::string what;
  std::regex in_code;
  std::vector<std::string> allowed_below;  ///< path prefixes
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = {
      {"CGAL", std::regex(R"(#\s*include\s*[<"]CGAL/)"), {"src/planar/"}},
      {"Ceres", std::regex(R"(#\s*include\s*[<"]ceres/)"), {"src/solve/", "src/correct/"}},
      {"Boost", std::regex(R"(#\s*include\s*[<"]boost/)"), {"src/"}},
      {"what a plug-in is for",
       std::regex(R"(#\s*include\s*[<"](cairo|librsvg/|gdal|ogr|cpl_))"),
       {"plugins/"}},
      {"our own but values",
       std::regex(R"(#\s*include\s*"roomatlas/(?!core/geometry\.hpp))"),
       {"src/", "include/", "apps/"}},
      {"<fstream>",
       std::regex(R"(#\s*include\s*<fstream>)"),
       {"src/io/", "include/roomatlas/io/", "apps/", "plugins/gdal/"}},
      {"the file system",
       std::regex(
           R"(\bfopen\s*\(|\b(fs|filesystem)::(create_|remove|rename|copy|resize_|permissions|)"
           R"(last_write_time|temp_directory_path|exists|is_|directory_iterator|recursive_))"),
       {"src/io/", "include/roomatlas/io/", "apps/"}},
      {"printing", std::regex(R"(#\s*include\s*<(iostream|print|spdlog/.*)>)"), {"apps/"}},
      {"exiting", std::regex(R"(\b(std::exit|std::abort|std::quick_exit)\s*\()"), {"apps/"}},
  };
  return all;
}

std::vector<std::string> outside_included(const SourceFile& source) {
  std::vector<std::string> findings;
  std::istringstream in(source.text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::string code = line.substr(0, line.find("//"));
    for (const Rule& rule : rules()) {
      const bool allowed =
          std::any_of(rule.allowed_below.begin(), rule.allowed_below.end(),
                      [&](const std::string& prefix) { return source.path.starts_with(prefix); });
      if (!allowed && std::regex_search(code, rule.in_code)) {
        findings.push_back(source.path + ":" + std::to_string(number) + ": " + rule.what +
                           " does not belong here");
      }
    }
  }
  return findings;
}

TEST(OutsideLibraries, StayWhereTheyBelong) {
  std::vector<SourceFile> sources = library_sources();
  for (const char* folder : {"apps", "plugins"}) {
    for (SourceFile& source : sources_below(folder)) sources.push_back(std::move(source));
  }
  for (const SourceFile& source : sources) {
    const std::vector<std::string> findings = outside_included(source);
    EXPECT_TRUE(findings.empty()) << lines_of(findings);
  }
}

TEST(OutsideLibraries, CheckSeesWhatDoesNotBelong) {
  const auto count = [](const std::string& path, const std::string& text) {
    return outside_included({path, "", text}).size();
  };
  const std::string cgal = "#include <CGAL/Polygon_2.h>\n";
  EXPECT_EQ(count("src/planar/exact.cpp", cgal), 0U);
  EXPECT_EQ(count("src/draw/draw.cpp", cgal), 1U);
  EXPECT_EQ(count("include/roomatlas/planar/union.hpp", cgal), 1U);
  const std::string ceres = "#include <ceres/ceres.h>\n";
  EXPECT_EQ(count("src/correct/solve.cpp", ceres), 0U);
  EXPECT_EQ(count("include/roomatlas/correct/correct.hpp", ceres), 1U);
  EXPECT_EQ(count("apps/main.cpp", ceres), 1U);
  EXPECT_EQ(count("src/io/pictures/svg_pictures.cpp", "#include <librsvg/rsvg.h>\n"), 1U);
  EXPECT_EQ(count("plugins/pictures/encode.cpp", "#include <librsvg/rsvg.h>\n"), 0U);
  EXPECT_EQ(count("plugins/gdal/plugin.cpp", "#include \"roomatlas/io/files/files.hpp\"\n"), 1U);
  EXPECT_EQ(count("src/draw/text_extent.cpp", "#include <cairo.h>\n"), 1U);
  EXPECT_EQ(count("src/pipeline/build.cpp", "#include <fstream>\n"), 1U);
  EXPECT_EQ(count("src/io/tum.cpp", "#include <fstream>\n"), 0U);
  EXPECT_EQ(count("src/pipeline/build.cpp", "std::filesystem::rename(a, b);\n"), 1U);
  EXPECT_EQ(count("src/pipeline/build.cpp", "std::filesystem::path out;\n"), 0U);
  EXPECT_EQ(count("src/grid/himm.cpp", "#include <iostream>\n"), 1U);
  EXPECT_EQ(count("src/grid/himm.cpp", "// std::exit(1) would be rude\n"), 0U);
}

}  // namespace
}  // namespace roomatlas::architecture
