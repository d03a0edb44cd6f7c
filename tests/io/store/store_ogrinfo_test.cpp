// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/store/assembly_samples.hpp"

#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>

namespace roomatlas {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What a command prints, its errors included.
std::string output_of(const std::string& command) {
  std::string output;
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return output;
  char buffer[4096];
  while (const std::size_t size = std::fread(buffer, 1, sizeof buffer, pipe)) {
    output.append(buffer, size);
  }
  ::pclose(pipe);
  return output;
}

/// The store as GDAL, and so QGIS, sees it.
class StoreSeenByGdal : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("ogrinfo --version > /dev/null 2>&1") != 0) {
      const char* ci = std::getenv("CI");
      if (ci != nullptr && std::string(ci) == "true") FAIL() << "ogrinfo (gdal-bin) is missing";
      GTEST_SKIP() << "ogrinfo (gdal-bin) is missing";
    }
    GeoPackageStore store(file_, GeoPackageStore::Mode::create);
    for (AsrId id = 1; id <= 3; ++id) store.put(sample_asr(id));
    store.put(TruePose{1.0, {1, 2, 3}});
    store.put(sample_assembly(sample_correction(3), sample_plan(), {{1, 1}}), "");
    store.finish();
  }
  [[nodiscard]] std::string ogrinfo(const std::string& options, const char* layer = "") const {
    return output_of("ogrinfo " + options + " '" + file_.string() + "' " + layer);
  }

  TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_ / "building.gpkg";
};

TEST_F(StoreSeenByGdal, ListsAllLayersWithoutAWarning) {
  const std::string output = ogrinfo("-so -al");
  for (const char* layer : {"rooms", "doors", "walls", "free_space", "furniture", "path", "asr",
                            "exits", "path_samples", "sensors", "readings", "truth", "assembly",
                            "corrections", "factors", "plan_issues", "metadata"}) {
    EXPECT_THAT(output, HasSubstr("Layer name: " + std::string(layer) + "\n"));
  }
  EXPECT_THAT(output, Not(HasSubstr("Warning")));
  EXPECT_THAT(output, Not(HasSubstr("ERROR")));
  EXPECT_THAT(output, Not(HasSubstr("FAILURE")));
}

TEST_F(StoreSeenByGdal, ReadsEveryFeatureWithoutAWarning) {
  const std::string output = ogrinfo("-al");
  EXPECT_THAT(output, Not(HasSubstr("Warning")));
  EXPECT_THAT(output, Not(HasSubstr("ERROR")));
}

TEST_F(StoreSeenByGdal, RoomsHaveTheirHolesAttributesAndTheBuildingsFrame) {
  const std::string output = ogrinfo("", "rooms");
  EXPECT_THAT(output, HasSubstr("Geometry: Multi Polygon"));
  EXPECT_THAT(output, HasSubstr("MULTIPOLYGON (((0 0,9 0,9 9,0 9,0 0),(3 3,3 6,6 6,6 3,3 3))"));
  EXPECT_THAT(output, HasSubstr("ENGCRS[\"Building metres\""));
  EXPECT_THAT(output, HasSubstr("name (String) = Lab 315"));
  EXPECT_THAT(output, HasSubstr("asrs (String) = 1,4,2"));
}

TEST_F(StoreSeenByGdal, ThePathIsTheCorrectedOne) {
  const Correction correction = sample_correction(3);
  const Point2 first =
      correction.asrs[1].building_from_asr * sample_asr(2).path.front().asr_from_robot.position();
  char expected[80];
  std::snprintf(expected, sizeof expected, "LINESTRING (%.15g %.15g,", first.x(), first.y());
  EXPECT_THAT(ogrinfo("-where asr=2", "path"), HasSubstr(expected));
}

}  // namespace
}  // namespace roomatlas
