// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/spans.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluate/four_rooms.hpp"

namespace roomatlas {
namespace {

using namespace test;

FloorPlan plan_with_labels() {
  FloorPlan plan = four_rooms();
  for (PlanRoom& r : plan.rooms) r.label_point = interior_point(r.parts[0]);
  return plan;
}

SpanErrors measured(const FloorPlan& plan, const SpanEnd& from, const SpanEnd& to,
                    double true_m = 1.0) {
  return span_errors(plan, {{"tape", from, to, true_m}});
}

TEST(SpanErrors, MeasureBetweenDoorsWallsAndPoints) {
  const FloorPlan plan = plan_with_labels();
  const auto length = [&](const SpanEnd& from, const SpanEnd& to) {
    return measured(plan, from, to).spans.at(0).plan_m;
  };
  EXPECT_NEAR(length(DoorEnd{1}, DoorEnd{4}), 8.5, 1e-9);
  EXPECT_NEAR(length(WallEnd{1, Side::west}, WallEnd{1, Side::east}), 4.0, 1e-9);
  EXPECT_NEAR(length(WallEnd{1, Side::south}, WallEnd{1, Side::north}), 3.0, 1e-9);
  EXPECT_NEAR(length(WallEnd{1, Side::west}, WallEnd{3, Side::east}), 12.4, 1e-9);
  EXPECT_NEAR(length(WallEnd{1, Side::west}, DoorEnd{5}), 4.1, 1e-9);
  EXPECT_NEAR(length(PointEnd{{0, 0}}, PointEnd{{3, 4}}), 5.0, 1e-9);
  EXPECT_NEAR(length(DoorEnd{5}, WallEnd{2, Side::north}), 3.0 - 1.45, 1e-9);
}

TEST(SpanErrors, SidesTurnWithTheBuilding) {
  FloorPlan plan = plan_with_labels();
  const Pose2 turn{3, 1, radians(20)};
  FloorPlan turned = moved(turn, plan);
  for (PlanRoom& r : turned.rooms) r.label_point = turn * r.label_point;
  const SpanErrors errors = measured(turned, WallEnd{1, Side::west}, WallEnd{3, Side::east});
  EXPECT_NEAR(errors.spans[0].plan_m, 12.4, 1e-9);
}

TEST(SpanErrors, SayHowWrongThePlanIsAndHowMuchTooLong) {
  const FloorPlan plan = plan_with_labels();
  const SpanErrors errors =
      span_errors(plan, {{"width", WallEnd{1, Side::west}, WallEnd{1, Side::east}, 4.1},
                         {"length", WallEnd{4, Side::west}, WallEnd{4, Side::east}, 12.2}});
  EXPECT_EQ(errors.error_m.count, 2);
  EXPECT_NEAR(errors.error_m.mean, 0.15, 1e-9);
  EXPECT_NEAR(errors.scale, (4.0 * 4.1 + 12.4 * 12.2) / (4.1 * 4.1 + 12.2 * 12.2), 1e-9);
  EXPECT_TRUE(errors.issues.empty());
}

TEST(SpanErrors, NameTheEndThatIsNotInThePlan) {
  const FloorPlan plan = plan_with_labels();
  SpanErrors errors = measured(plan, DoorEnd{77}, DoorEnd{1});
  EXPECT_TRUE(std::isnan(errors.spans[0].plan_m));
  ASSERT_EQ(errors.issues.size(), 1U);
  EXPECT_NE(errors.issues[0].message.find("door 77"), std::string::npos);
  EXPECT_EQ(errors.error_m.count, 0);
  errors = measured(plan, WallEnd{1, Side::west}, WallEnd{2, Side::north});
  EXPECT_EQ(errors.issues.size(), 1U);
}

}  // namespace
}  // namespace roomatlas
