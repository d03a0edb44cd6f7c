// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../src/io/store/wkb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include "store_samples.hpp"

namespace roomatlas {
namespace {

const Polygon kSquareWithTwoHoles{
    {{0, 0}, {9, 0}, {9, 9}, {0, 9}},
    {{{1, 1}, {1, 2}, {2, 2}}, {{1.0 / 3.0, 5}, {1, 1e-300}, {-0.0, 6}, {0.1, 7}}}};

std::string hex(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

TEST(Wkb, ALineIsWrittenAsTheStandardSays) {
  EXPECT_EQ(hex(wkb_of_line({{1, 2}})),
            "01"                // little-endian
            "02000000"          // LineString
            "01000000"          // one point
            "000000000000f03f"  // 1.0
            "0000000000000040");
}

TEST(Wkb, ARingIsClosedInTheBytesAndOpenInMemory) {
  const Bytes wkb = wkb_of_polygon({{{0, 0}, {1, 0}, {0, 1}}, {}});
  EXPECT_EQ(wkb.size(), 1u + 4u + 4u + 4u + 4u * 16u);
  EXPECT_EQ(wkb[9], 4);  // points of the ring
  EXPECT_EQ(polygon_of_wkb(wkb).outer.size(), 3u);
}

TEST(Wkb, PolygonsKeepTheirHolesBitForBit) {
  expect_same(polygon_of_wkb(wkb_of_polygon(kSquareWithTwoHoles)), kSquareWithTwoHoles);
  const auto parts = polygons_of_wkb(wkb_of_polygons({kSquareWithTwoHoles, {{{1, 1}}, {}}}));
  ASSERT_EQ(parts.size(), 2u);
  expect_same(parts[0], kSquareWithTwoHoles);
  EXPECT_TRUE(std::signbit(parts[0].holes[1][2].x()));
  expect_same(parts[1], {{{1, 1}}, {}});
}

TEST(Wkb, LinesComeBackInOrder) {
  const std::vector<Polyline> lines = {{{1, 2}, {3, 4}}, {}, {{0.1, 0.2}}};
  EXPECT_EQ(lines_of_wkb(wkb_of_lines(lines)), lines);
  EXPECT_EQ(line_of_wkb(wkb_of_line(lines[0])), lines[0]);
}

TEST(Wkb, NothingComesBackAsNothing) {
  expect_same(polygon_of_wkb(wkb_of_polygon({})), {});
  EXPECT_TRUE(polygons_of_wkb(wkb_of_polygons({})).empty());
  EXPECT_TRUE(lines_of_wkb(wkb_of_lines({})).empty());
  EXPECT_TRUE(line_of_wkb(wkb_of_line({})).empty());
}

TEST(Wkb, NumbersThatAreNotFiniteSurvive) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Polyline line = line_of_wkb(wkb_of_line({{std::nan(""), -infinity}}));
  EXPECT_TRUE(std::isnan(line[0].x()));
  EXPECT_EQ(line[0].y(), -infinity);
}

TEST(Wkb, BytesThatEndAnywhereEarlyAreRefused) {
  const Bytes whole = wkb_of_polygons({kSquareWithTwoHoles});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(static_cast<void>(polygons_of_wkb(ByteView(whole).first(size))), DamagedData);
  }
}

TEST(Wkb, AnotherTypeOrByteOrderOrAnAbsurdCountIsRefused) {
  Bytes wkb = wkb_of_line({{1, 2}});
  EXPECT_THROW(static_cast<void>(polygon_of_wkb(wkb)), DamagedData);
  wkb[8] = 0xff;  // announces 4 billion points
  EXPECT_THROW(static_cast<void>(line_of_wkb(wkb)), DamagedData);
  wkb[0] = 0;
  EXPECT_THROW(static_cast<void>(line_of_wkb(wkb)), DamagedData);
}

TEST(GeoPackageBlob, HasTheHeaderOfTheStandardAndTheWkb) {
  const Bytes wkb = wkb_of_line({{1, 2}, {3, 5}});
  const Bytes blob = geopackage_blob(wkb, bounds({{1, 2}, {3, 5}}), 100001);
  EXPECT_EQ(hex({blob.begin(), blob.begin() + 40}),
            "4750"      // GP
            "00"        // version 1
            "03"        // envelope xy, little-endian
            "a1860100"  // srs 100001
            "000000000000f03f"
            "0000000000000840"  // min x, max x
            "0000000000000040"
            "0000000000001440");  // min y, max y
  const ByteView inner = wkb_of_geopackage_blob(blob);
  EXPECT_EQ(Bytes(inner.begin(), inner.end()), wkb);
}

TEST(GeoPackageBlob, AnEmptyGeometryIsFlaggedAndHasNoEnvelope) {
  const Bytes blob = geopackage_blob(wkb_of_polygon({}), {}, 1);
  EXPECT_EQ(blob[3], 0x11);
  EXPECT_TRUE(polygon_of_wkb(wkb_of_geopackage_blob(blob)).outer.empty());
}

TEST(GeoPackageBlob, EnvelopesOfOtherProgramsAreSkipped) {
  const Bytes wkb = wkb_of_line({{1, 2}, {3, 5}});
  for (const auto& [flags, bytes] : {std::pair{0x01, 0}, {0x05, 48}, {0x07, 48}, {0x09, 64}}) {
    Bytes blob = {'G', 'P', 0, static_cast<std::uint8_t>(flags), 1, 0, 0, 0};
    blob.insert(blob.end(), static_cast<std::size_t>(bytes), 0);
    blob.insert(blob.end(), wkb.begin(), wkb.end());
    EXPECT_EQ(line_of_wkb(wkb_of_geopackage_blob(blob)).size(), 2u);
  }
  EXPECT_THROW(static_cast<void>(wkb_of_geopackage_blob(Bytes{'G', 'P', 0, 0x0b, 1, 0, 0, 0})),
               DamagedData);
  EXPECT_THROW(static_cast<void>(wkb_of_geopackage_blob(wkb)), DamagedData);
}

}  // namespace
}  // namespace roomatlas
