// SPDX-License-Identifier: GPL-3.0-or-later
// A drafted plan as it is seen: everything is read back from the SVG.
#include "../../src/draw/text_extent.hpp"
#include "draw/flat_fixture.hpp"

#include "roomatlas/draw/dimensions.hpp"

#include <gmock/gmock.h>
#include <pugixml.hpp>

#include <cmath>
#include <sstream>

namespace roomatlas {
namespace {

using test::flat;
using ::testing::HasSubstr;
using ::testing::Not;

struct Drawn {
  explicit Drawn(const FloorPlan& plan, const DrawOptions& options = {}) {
    EXPECT_TRUE(document.load_string(draw_plan(plan, {}, options).c_str()));
  }
  [[nodiscard]] std::vector<pugi::xml_node> all(const std::string& path) const {
    std::vector<pugi::xml_node> nodes;
    for (const auto& found : document.select_nodes(path.c_str())) nodes.push_back(found.node());
    return nodes;
  }
  pugi::xml_document document;
};

Segment2 line_of(const pugi::xml_node& node) {
  const auto value = [&](const char* key) { return node.attribute(key).as_double(); };
  return {{value("x1"), value("y1")}, {value("x2"), value("y2")}};
}

/// The rings of `M x y L x y ... Z M ...`.
std::vector<Ring> rings_of(const pugi::xml_node& path) {
  std::vector<Ring> rings;
  std::string text = path.attribute("d").value();
  for (char& c : text) {
    if (c == 'L') c = ' ';
  }
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, 'M');) {
    if (part.empty()) continue;
    std::istringstream numbers(part);
    rings.emplace_back();
    for (Point2 point; numbers >> point.x() >> point.y();) rings.back().push_back(point);
  }
  return rings;
}

/// What a text covers, from its own attributes.
Box2 box_of(const pugi::xml_node& text) {
  const double size = text.attribute("font-size").as_double();
  const bool is_bold = std::string(text.attribute("font-weight").value()) == "bold";
  const double width = drawing::text_width_mm(
      text.text().get(), size, is_bold ? drawing::Weight::bold : drawing::Weight::normal);
  const std::string anchor = text.attribute("text-anchor").value();
  const double start = anchor == "middle" ? -0.5 : anchor == "end" ? -1.0 : 0.0;
  const Point2 at(text.attribute("x").as_double(), text.attribute("y").as_double());
  Box2 box{at + Point2(start * width, -size * drawing::kCapHeight),
           at + Point2((start + 1.0) * width, 0.0)};
  for (pugi::xml_node node = text; node; node = node.parent()) {
    double degrees = 0.0;
    Point2 about = Point2::Zero();
    if (std::sscanf(node.attribute("transform").value(), "rotate(%lf %lf %lf", &degrees, &about.x(),
                    &about.y()) != 3) {
      continue;
    }
    const Point2 low = box.min - about;
    const Point2 high = box.max - about;
    box = {about + Point2(low.y(), -high.x()), about + Point2(high.y(), -low.x())};  // by -90
  }
  return box;
}

bool meet(const Box2& a, const Box2& b) {
  return (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
}

/// Places in the box, its rim included.
std::vector<Point2> places_in(const Box2& box) {
  std::vector<Point2> places;
  for (int i = 0; i <= 12; ++i) {
    for (int k = 0; k <= 6; ++k) {
      places.push_back(box.min + box.size().cwiseProduct(Point2(i / 12.0, k / 6.0)));
    }
  }
  return places;
}

bool even_odd(const std::vector<Ring>& rings, const Point2& point) {
  bool inside = false;
  for (const Ring& ring : rings) inside ^= contains(ring, point);
  return inside;
}

std::int64_t printed_cm(const pugi::xml_node& text) {
  return std::llround(100.0 * std::strtod(text.text().get(), nullptr));
}

const std::string kPlanText = "//g[@id='labels' or @id='dimensions' or @id='door-widths']//text";

TEST(DraftedPlan, NoTextLiesOnAWallADoorFurnitureOrAnotherText) {
  for (const double turn_deg : {0.0, 31.0}) {
    const Drawn drawn(test::moved(flat(), {2.0, -1.0, radians(turn_deg)}));
    const auto texts = drawn.all(kPlanText);
    ASSERT_GT(texts.size(), 12U);
    std::vector<std::vector<Ring>> bodies;
    for (const char* path : {"//g[@id='walls']/path", "//path[@class='gap']",
                             "//path[@class='against-wall' or @class='free-standing']"}) {
      for (const pugi::xml_node& node : drawn.all(path)) bodies.push_back(rings_of(node));
    }
    ASSERT_EQ(bodies.size(), 1U + 4U + 2U);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const Box2 box = box_of(texts[i]);
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(meet(box, box_of(texts[k])))
            << texts[i].text().get() << " and " << texts[k].text().get();
      }
      for (const auto& rings : bodies) {
        for (const Point2& place : places_in(box)) {
          ASSERT_FALSE(even_odd(rings, place)) << texts[i].text().get();
        }
      }
    }
  }
}

TEST(DraftedPlan, PrintedPartsOfAChainAddUpToThePrintedTotal) {
  const Drawn drawn(flat());
  const auto chains = drawn.all("//g[@class='chain']");
  ASSERT_EQ(chains.size(), 2U);
  const std::array<std::vector<std::int64_t>, 2> expected = {
      {{30, 357, 10, 254, 30}, {30, 300, 24, 246, 30}}};
  for (std::size_t i = 0; i < chains.size(); ++i) {
    std::vector<std::int64_t> parts;
    for (const auto& found : chains[i].select_nodes("text[@class='part']")) {
      parts.push_back(printed_cm(found.node()));
    }
    EXPECT_EQ(parts, expected[i]);
    std::int64_t sum = 0;
    for (const std::int64_t part : parts) sum += part;
    EXPECT_EQ(sum, printed_cm(chains[i].select_node("text[@class='total']").node()));
  }
}

TEST(DraftedPlan, IsDrawnUprightHoweverTheBuildingLies) {
  const auto texts_of = [](const Drawn& drawn) {
    std::vector<std::string> texts;
    for (const auto& node : drawn.all(kPlanText)) texts.emplace_back(node.text().get());
    return texts;
  };
  const auto upright = texts_of(Drawn(flat()));
  for (const double turn_deg : {-38.0, 0.7, 21.0, 44.0}) {
    const Drawn turned(test::moved(flat(), {5.0, 2.0, radians(turn_deg)}));
    EXPECT_EQ(texts_of(turned), upright);
    for (const pugi::xml_node& room : turned.all("//g[@id='rooms']/path")) {
      const Ring ring = rings_of(room).front();
      for (std::size_t i = 0; i < 4; ++i) {
        const Point2 edge = ring[(i + 1) % 4] - ring[i];
        EXPECT_LT(edge.cwiseAbs().minCoeff(), 0.01);
      }
    }
  }
}

TEST(DraftedPlan, TheArcOfADoorGoesFromItsLeafToTheOtherJamb) {
  const Drawn drawn(flat());
  const auto arcs = drawn.all("//path[@class='arc']");
  ASSERT_EQ(arcs.size(), 1U);
  EXPECT_STREQ(arcs[0].parent().attribute("id").value(), "door-1-3");
  const Segment2 leaf = line_of(arcs[0].parent().select_node("line[@class='leaf']").node());
  const Ring gap = rings_of(arcs[0].parent().select_node("path[@class='gap']").node()).front();
  Point2 start, end, radii;
  double turn = 0.0;
  int large = 0, sweep = 0;
  ASSERT_EQ(
      std::sscanf(arcs[0].attribute("d").value(), "M%lf %lfA%lf %lf %lf %d %d %lf %lf", &start.x(),
                  &start.y(), &radii.x(), &radii.y(), &turn, &large, &sweep, &end.x(), &end.y()),
      9);
  EXPECT_LT((start - leaf.b).norm(), 2e-3);
  Box2 box;
  for (const Point2& corner : gap) box.extend(corner);
  const Point2 hinge(box.min.x(), (box.min.y() + box.max.y()) / 2.0);
  const Point2 jamb(box.max.x(), hinge.y());
  EXPECT_LT((leaf.a - hinge).norm(), 5e-3);
  EXPECT_LT((end - jamb).norm(), 5e-3);
  EXPECT_NEAR(radii.x(), (jamb - hinge).norm(), 0.2);
  EXPECT_EQ(large, 0);
  // The way from the leaf to the jamb that turns about the hinge: clockwise on paper is sweep 1.
  EXPECT_EQ(sweep, cross(start - hinge, jamb - hinge) > 0.0 ? 1 : 0);
}

TEST(DraftedPlan, OpeningsWithoutALeafAreDrawnByTheirKind) {
  const Drawn drawn(flat());
  const auto count = [&](const std::string& door, const std::string& what) {
    return drawn.all("//g[@id='" + door + "']/" + what).size();
  };
  for (const char* door : {"door-out-out", "door-out-out-2", "door-out-out-3"}) {
    EXPECT_EQ(count(door, "path[@class='arc']") + count(door, "line[@class='leaf']"), 0U);
  }
  EXPECT_EQ(count("door-out-out-2", "line[@class='threshold']"), 2U);
  EXPECT_EQ(count("door-out-out-3", "line[@class='lintel' and @stroke-dasharray]"), 2U);
  EXPECT_EQ(count("door-out-out", "line[@class='pane']"), 2U);
}

TEST(DraftedPlan, WallsThatNobodyMeasuredAreDashedAndNotFilled) {
  const Drawn drawn(flat());
  const Ring room = rings_of(drawn.all("//path[@id='room-1']").front()).front();
  const double mm_per_m = (room[1].x() - room[0].x()) / 3.573;
  const auto paper = [&](double x, double y) {  // building metres
    return Point2(room[0].x() + mm_per_m * (x - 0.3), room[0].y() - mm_per_m * (y - 0.3));
  };
  const auto inferred = drawn.all("//line[@class='inferred']");
  ASSERT_EQ(inferred.size(), 3U);  // both faces of the outside wall, one of the partition
  for (const pugi::xml_node& line : inferred) {
    EXPECT_TRUE(line.parent().attribute("stroke-dasharray"));
  }
  const auto is_blank = [&](const Point2& place) {
    for (const pugi::xml_node& path : drawn.all("//g[@class='assumed']/path")) {
      if (even_odd(rings_of(path), place)) return true;
    }
    return false;
  };
  EXPECT_TRUE(is_blank(paper(0.02, 2)));
  EXPECT_TRUE(is_blank(paper(0.28, 2)));
  EXPECT_TRUE(is_blank(paper(3.965, 2)));   // the half towards room 2 ...
  EXPECT_FALSE(is_blank(paper(3.88, 2)));   // ... but room 1 saw its own
  EXPECT_FALSE(is_blank(paper(6.7, 2.5)));  // measured
  EXPECT_EQ(drawn.all("//g[@id='unexplored']//path[@class='unexplored']").size(), 1U);
  EXPECT_TRUE(is_blank(paper(3, 6.02)));  // behind the unexplored edge of room 3
  EXPECT_TRUE(is_blank(paper(3, 6.28)));
  EXPECT_FALSE(is_blank(paper(0.2, 6.2)));
}

TEST(DraftedPlan, WallsAreSolidOrLightByTheirThickness) {
  const Drawn drawn(flat());
  std::vector<std::vector<Ring>> light;
  for (const auto& path : drawn.all("//g[@class='partitions']/path"))
    light.push_back(rings_of(path));
  const std::vector<Ring> wall = rings_of(drawn.all("//g[@id='walls']/path").front());
  const Ring room = rings_of(drawn.all("//path[@id='room-1']").front()).front();
  const double partition_left = room[1].x();
  const double mm_per_m = (room[1].x() - room[0].x()) / 3.573;
  const Box2 box = bounds(wall.front());
  for (double x = box.min.x() + 0.1; x < box.max.x(); x += 0.31) {
    for (double y = box.min.y() + 0.1; y < box.max.y(); y += 0.31) {
      const Point2 place(x, y);
      if (!even_odd(wall, place)) continue;
      const bool is_light = std::any_of(light.begin(), light.end(),
                                        [&](const auto& rings) { return even_odd(rings, place); });
      const bool is_partition = x > partition_left && x < partition_left + 0.1 * mm_per_m &&
                                y > room[2].y() && y < room[0].y();
      EXPECT_EQ(is_light, is_partition) << place.transpose();
    }
  }
}

TEST(DraftedPlan, HatchesOfFurnitureGoTheOtherWayWhereItStandsFree) {
  const Drawn drawn(flat());
  const auto slope = [&](const char* kind) {
    const auto piece = drawn.all(std::string("//path[@class='") + kind + "']").front();
    const auto rings = rings_of(piece.next_sibling("path"));
    for (const Ring& stroke : rings) {
      for (const double share : {0.01, 0.5, 0.99}) {
        EXPECT_TRUE(even_odd(rings_of(piece), stroke[0] + share * (stroke[1] - stroke[0])));
      }
    }
    const Point2 stroke = rings.front()[1] - rings.front()[0];
    return stroke.y() / stroke.x();
  };
  EXPECT_NEAR(slope("against-wall"), -1.0, 1e-2);  // y is down
  EXPECT_NEAR(slope("free-standing"), 1.0, 1e-2);
}

TEST(DraftedPlan, TheLegendShowsWhatIsOnThePlanAndNoMore) {
  const std::string full = draw_plan(flat(), {}, {});
  for (const char* name :
       {"wall, measured", "thin wall", "wall, inferred", "unexplored", "window", "passage",
        "door, leaf seen", "door, no leaf seen", "furniture at walls", "furniture, free"}) {
    EXPECT_THAT(full, HasSubstr(std::string(">") + name + "</text>"));
  }
  FloorPlan bare = flat();
  bare.edges.clear();
  bare.furniture.clear();
  bare.doors.clear();
  const std::string plain = draw_plan(bare, {}, {});
  for (const char* name :
       {"inferred", "measured", "unexplored", "window", "passage", "leaf", "furniture,"}) {
    EXPECT_THAT(plain, Not(HasSubstr(name + std::string("</text>")))) << name;
  }
  EXPECT_THAT(plain, HasSubstr(">wall</text>"));
}

TEST(DraftedPlan, ATagHasNumberNameAreaAndInsideMeasures) {
  const Drawn drawn(flat());
  std::vector<std::string> texts;
  for (const auto& node : drawn.all("//g[@data-room='2']/text"))
    texts.emplace_back(node.text().get());
  EXPECT_THAT(texts, testing::ElementsAre("2", "Kitchen", "7.6\u00a0m\u00b2",
                                          "2.54\u2009\u00d7\u20093.00"));
  EXPECT_EQ(drawn.all("//g[@data-room='2']/rect[@class='number-ring']").size(), 1U);
}

TEST(DraftedPlan, TheTitleBlockTellsHowFarThePlanCanBeReliedOn) {
  PlanAnnotations notes;
  notes.accuracy = PlanAccuracy{0.021, 0.05, 0.62, 77.6, 0.934};
  const std::string closed = draw_plan(flat(), notes, {});
  for (const char* text : {"\u00b1\u00a00.02\u00a0m", "\u00b1\u00a00.05\u00a0m",
                           "\u00b1\u00a00.62\u00a0m", "78\u00a0m", "93\u00a0%"}) {
    EXPECT_THAT(closed, HasSubstr(text));
  }
  notes.accuracy->probability = 0.9996;
  EXPECT_THAT(draw_plan(flat(), notes, {}), HasSubstr("99\u00a0%"));
}

}  // namespace
}  // namespace roomatlas
