// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/ifc.hpp"

#include <gmock/gmock.h>

#include <set>

#include "draw/flat_fixture.hpp"
#include "plans/wall_segments.hpp"
#include "roomatlas/planar/union.hpp"
#include "step_entities.hpp"
#include "support/shipped_world.hpp"

namespace roomatlas {
namespace {

using test::broken_ifc_rules;
using test::step_entities;
using test::StepEntity;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const IfcOptions kOptions{"6f1e", std::nullopt, "2026-03-04"};

constexpr const char* kWorlds[] = {"two_rooms",         "eight_rooms", "nine_rooms",
                                   "identical_rooms",   "open_hall",   "afit_floor",
                                   "slanted_and_curved"};

std::vector<StepEntity> of_type(const std::string& file, const std::string& type) {
  std::vector<StepEntity> found;
  for (const auto& [reference, entity] : step_entities(file)) {
    if (entity.type == type) found.push_back(entity);
  }
  return found;
}

double area_of(const std::vector<Polygon>& polygons) {
  double sum = 0.0;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

TEST(Ifc, OfEachWorldKeepsTheRulesOfTheSchema) {
  for (const char* name : kWorlds) {
    const FloorPlan plan = test::shipped_world(name);
    const std::string file = ifc_step(plan, kOptions);
    EXPECT_THAT(broken_ifc_rules(file), IsEmpty()) << name;
    EXPECT_EQ(of_type(file, "IFCSPACE").size(), plan.rooms.size()) << name;
  }
}

TEST(Ifc, OfADraftedFlatHasItsThingsInAnyFrame) {
  for (const double turn_deg : {0.0, 12.0, 77.0, 181.0}) {
    const std::string file =
        ifc_step(test::moved(test::flat(), {3.0, -20.0, radians(turn_deg)}), kOptions);
    EXPECT_THAT(broken_ifc_rules(file), IsEmpty()) << turn_deg;
    EXPECT_EQ(of_type(file, "IFCWALL").size(), 8U) << turn_deg;
    EXPECT_EQ(of_type(file, "IFCDOOR").size(), 2U);
    EXPECT_EQ(of_type(file, "IFCWINDOW").size(), 1U);
    EXPECT_EQ(of_type(file, "IFCOPENINGELEMENT").size(), 4U);   // the passage has one too
    EXPECT_EQ(of_type(file, "IFCRELFILLSELEMENT").size(), 3U);  // and nothing in it
    EXPECT_EQ(of_type(file, "IFCFURNITURE").size(), 2U);
  }
}

TEST(IfcRules, NoticeWhatIsBroken) {
  const std::string good = ifc_step(test::flat(), kOptions);
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string file = good;
    const std::size_t at = file.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    file.replace(at, from.size(), to);
    return broken_ifc_rules(file).size();
  };
  EXPECT_EQ(broken("IFCWALL", "IFCWALL"), 0U);
  EXPECT_GT(broken("IFCWALL", "IFCSPACE"), 0U);
  EXPECT_GT(broken(".SOLIDWALL.", ".SOLIDWALL.,$"), 0U);
  EXPECT_GT(broken(".SOLIDWALL.", ".SOLID."), 0U);
  EXPECT_GT(broken("(#", "(#9999"), 0U);
  EXPECT_GT(broken("IFCRELFILLSELEMENT", "IFCRELVOIDSELEMENT"), 0U);
  EXPECT_GT(broken("FILE_SCHEMA(('IFC4'", "FILE_SCHEMA(('IFC5'"), 0U);
}

// Nothing of a wall is lost, and nothing stands twice.
TEST(WallSegments, CoverTheWallsWithTheirHolesClosed) {
  for (const char* name : kWorlds) {
    const FloorPlan plan = test::shipped_world(name);
    std::vector<Polygon> bodies = plan.walls;
    for (const PlanDoor& door : plan.doors) bodies.push_back({door.opening, {}});
    std::vector<Polygon> pieces;
    for (const io::WallSegment& segment : io::wall_segments(plan)) {
      pieces.push_back(segment.outline);
    }
    const double whole_m2 = area_of(union_of(bodies));
    EXPECT_NEAR(area_of(pieces), whole_m2, 2e-3 * whole_m2) << name;
    EXPECT_NEAR(overlap_area(pieces, bodies), whole_m2, 2e-3 * whole_m2) << name;
    EXPECT_NEAR(area_of(union_of(pieces)), area_of(pieces), 1e-3 * whole_m2) << name;
  }
}

TEST(WallSegments, OfAPlanWithStraightWallsAreRectanglesWithTheirThickness) {
  std::multiset<int> thickness_mm;
  for (const io::WallSegment& segment : io::wall_segments(test::flat())) {
    ASSERT_TRUE(segment.is_rectangle);
    ASSERT_TRUE(segment.axis);
    const double length_m = (segment.axis->b - segment.axis->a).norm();
    EXPECT_NEAR(length_m * segment.thickness_m, area(segment.outline), 1e-3);
    thickness_mm.insert(static_cast<int>(std::lround(1000.0 * segment.thickness_m)));
  }
  EXPECT_EQ(thickness_mm.count(300), 4U + 2U);  // outside; twice cut by the wall between
  EXPECT_EQ(thickness_mm.count(240), 1U);
  EXPECT_EQ(thickness_mm.count(100), 1U);
}

TEST(WallSegments, WithACornerFarOffTakeNoLonger) {
  constexpr double kFar_m = 9e6;
  FloorPlan plan;
  plan.walls = {{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 0.2}, {0.0, 0.2}}, {}},
                {{{10.0, 0.0}, {11.0, 0.0}, {10.5, kFar_m}}, {}}};
  std::vector<Polygon> outlines;
  for (const io::WallSegment& wall : io::wall_segments(plan)) outlines.push_back(wall.outline);
  EXPECT_NEAR(area_of(outlines), 0.8 + kFar_m / 2.0, 1.0);
}

TEST(Ifc, ADoorSwingsAsItsLeafWasSeen) {
  // The leaf of door 1 is hinged at jamb a, left of the way from a to b.
  EXPECT_THAT(ifc_step(test::flat(), kOptions), HasSubstr(".DOOR.,.SINGLE_SWING_LEFT."));
  FloorPlan plan = test::flat();
  std::swap(plan.doors[0].jambs.a, plan.doors[0].jambs.b);  // the same door, said otherwise
  EXPECT_THAT(ifc_step(plan, kOptions), HasSubstr(".DOOR.,.SINGLE_SWING_LEFT."));
  plan.doors[0].leaf = Segment2{{1.9, 3.42}, {1.75, 4.3}};  // hinged at the other jamb
  EXPECT_THAT(ifc_step(plan, kOptions), HasSubstr(".DOOR.,.SINGLE_SWING_RIGHT."));
}

TEST(Ifc, ARoomHasItsNumberItsNameAndItsArea) {
  FloorPlan plan = test::flat();
  plan.rooms[1].name =
      "K\xC3\xBC"
      "che 'A'\\B";
  const std::string file = ifc_step(plan, kOptions);
  EXPECT_THAT(file, HasSubstr(R"('K\X2\00FC\X0\che ''A''\\B')"));
  EXPECT_THAT(broken_ifc_rules(file), IsEmpty());
  std::set<std::string> areas;
  for (const StepEntity& quantity : of_type(file, "IFCQUANTITYAREA")) {
    areas.insert(quantity.arguments[3]);
  }
  EXPECT_EQ(areas.size(), 3U);
  EXPECT_NEAR(std::stod(*areas.begin()), 10.719, 1e-9);
}

TEST(Ifc, HasTheSiteAndNorthWhereTheyAreKnown) {
  IfcOptions placed = kOptions;
  placed.on_earth = GeoReference{-48.5, 7.25, 90.0};
  const std::string file = ifc_step(test::flat(), placed);
  EXPECT_THAT(broken_ifc_rules(file), IsEmpty());
  EXPECT_THAT(file, HasSubstr("(-48,-30,0,0),(7,15,0,0)"));
  EXPECT_THAT(file, HasSubstr("IFCDIRECTION((-1.,0.))"));  // the y axis is east, so north is -x
}

TEST(Ifc, ARoomKeepsItsIdentifierWhenItIsRenamedAndOthersCome) {
  const auto ids = [](const FloorPlan& plan) {
    std::map<std::string, std::string> found;
    for (const StepEntity& space : of_type(ifc_step(plan, kOptions), "IFCSPACE")) {
      found[space.arguments[2]] = space.arguments[0];
    }
    return found;
  };
  FloorPlan plan = test::flat();
  const auto before = ids(plan);
  for (PlanRoom& room : plan.rooms) room.name += "!";
  plan.rooms.insert(plan.rooms.begin(),
                    test::room(9, "Annex", RoomKind::room, {{20.0, 0.0}, {24.0, 3.0}}));
  const auto after = ids(plan);
  EXPECT_EQ(after.size(), 4U);
  for (const auto& [number, id] : before) EXPECT_EQ(after.at(number), id);
}

}  // namespace
}  // namespace roomatlas
