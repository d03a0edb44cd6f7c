// SPDX-License-Identifier: GPL-3.0-or-later
// Missions through drawn buildings, joined from nothing.
#include "roomatlas/join/join_missions.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <barrier>
#include <thread>

#include "support/drawn_missions.hpp"

namespace roomatlas {
namespace {

using namespace test;

/// Drawn missions are short: a piece is a room or two.
JoinOptions for_small_missions() {
  JoinOptions options;
  options.place.piece_way_m = 2.0;
  options.place.min_score = 30.0;
  options.place.sure_score = 60.0;
  return options;
}

double largest_error_m(const JoinedMissions& joined, const MissionMap& mission,
                       const Pose2& base_from_mission) {
  double largest = 0.0;
  for (const auto& [id, pose] : mission.mission_from_asr) {
    const Pose2 off = inverse(base_from_mission * pose) * joined.placement.at(id);
    largest = std::max(largest, off.position().norm());
  }
  return largest;
}

TEST(JoinMissions, PutsEachWhereItWasHoweverItsFrameIsTurned) {
  const Pose2 second_from_world{20.0, -7.0, radians(123.0)};
  const Pose2 third_from_world{-4.0, 9.0, radians(-64.0)};
  const std::vector<MissionMap> missions = {driven(building(), {0, 1, 2}, 1, {}),
                                            driven(building(), {1, 2, 3, 4}, 11, second_from_world),
                                            driven(building(), {4, 3, 4}, 21, third_from_world)};
  const JoinedMissions joined = join_missions(missions, for_small_missions());
  for (const JoinedMission& mission : joined.missions) EXPECT_EQ(mission.component, 0);
  EXPECT_LT(largest_error_m(joined, missions[1], inverse(second_from_world)), 0.05);
  // The third shares no room with the first: it is held by the second.
  EXPECT_LT(largest_error_m(joined, missions[2], inverse(third_from_world)), 0.08);
  for (const Closure& closure : joined.closures) {
    if (closure.verdict != ClosureVerdict::accepted) continue;
    const Pose2 off =
        inverse(closure.match.first_from_second) *
        (inverse(joined.placement.at(closure.from)) * joined.placement.at(closure.to));
    EXPECT_LT(off.position().norm(), 0.1) << closure.from << " " << closure.to;
  }
}

TEST(JoinMissions, FindsBothEndsOfAMissionThatBentWhereNobodyElseWas) {
  const Row row = row_of({4.0, 5.3, 7.1, 3.6, 6.2, 4.4, 5.8, 6.6, 5.0},
                         {0.8, 1.4, 1.1, 0.0, 1.9, 0.6, 1.2, 1.6, 0.9});
  const Pose2 second_from_world{20.0, -7.0, radians(123.0)};
  const MissionMap truth = driven(row, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 11, second_from_world);
  MissionMap bent = truth;
  for (auto& [id, pose] : bent.mission_from_asr) {
    if (id > 14) pose = Pose2{0.6, 0.4, 0.0} * pose;
  }
  const std::vector<MissionMap> missions = {driven(row, {0, 1, 2, 6, 7, 8}, 1, {}), bent};
  const JoinedMissions joined = join_missions(missions, for_small_missions());
  ASSERT_EQ(joined.missions[1].component, 0);
  for (const AsrId id : {11, 12, 13, 17, 18, 19}) {
    const Pose2 true_pose = inverse(second_from_world) * truth.mission_from_asr.at(id);
    EXPECT_LT((joined.placement.at(id).position() - true_pose.position()).norm(), 0.25) << id;
  }
  EXPECT_TRUE(joined.missions[1].best.pieces.back().fits);
}

TEST(JoinMissions, LeavesAMissionThroughRoomsAlikeAlone) {
  const std::vector<MissionMap> missions = {driven(rooms_alike(), {0, 1, 2, 3, 4}, 1, {}),
                                            driven(rooms_alike(), {1, 2}, 11, {3.0, 1.0, 0.4})};
  const JoinedMissions joined = join_missions(missions, for_small_missions());
  EXPECT_NE(joined.missions[0].component, joined.missions[1].component);
  EXPECT_EQ(joined.missions[1].verdict, PlaceVerdict::ambiguous);
}

TEST(JoinMissions, LeavesAMissionOfAnotherBuildingAlone) {
  const Row other = row_of({8.4, 2.7}, {2.6, 0.0});
  const std::vector<MissionMap> missions = {driven(building(), {0, 1, 2, 3, 4}, 1, {}),
                                            driven(other, {0, 1}, 11, {3.0, 1.0, 0.4})};
  const JoinedMissions joined = join_missions(missions, for_small_missions());
  EXPECT_NE(joined.missions[0].component, joined.missions[1].component);
  EXPECT_TRUE(joined.missions[1].is_base);  // of a component of its own
  for (const auto& [id, pose] : missions[1].mission_from_asr) {
    EXPECT_EQ(joined.placement.at(id), pose);
  }
}

/// What a laser measured around the middles of a mission's rooms, turned by so much.
void add_rays(const Row& row, double turn_rad, const Pose2& mission_from_world,
              MissionMap& mission) {
  for (const auto& [id, pose] : mission.mission_from_asr) {
    const Pose2 world_from_asr = inverse(mission_from_world) * pose;
    for (int n = 0; n < 60; ++n) {
      const double heading_rad = radians(6.0 * n);
      const Point2 along = direction(world_from_asr.theta_rad + heading_rad);
      const double range_m = range_to(row.walls, world_from_asr.position(), along).value();
      mission.rays[id].push_back({{0.0, 0.0, heading_rad + turn_rad}, range_m, 0.0, true});
    }
  }
}

TEST(JoinMissions, HearsReadingsWhereWallsLeaveItOpen) {
  const Row before = building();
  Row since = row_of({4.0, 5.3, 7.1, 3.6, 6.2}, {1.9, 0.0, 2.4, 1.2, 0.7});
  for (const Point2& middle : since.middles) {  // and tables
    for (const DrawnWall& wall : room_walls(middle.x() + 0.9, middle.y() - 0.8, 0.7, 0.7, 0.0)) {
      since.walls.push_back(wall);
    }
  }
  const Pose2 second_from_world{20.0, -7.0, radians(123.0)};
  const MissionMap without_rays = driven(since, {0, 1, 2, 3, 4}, 11, second_from_world);
  MissionMap measured = without_rays;
  add_rays(since, 0.0, second_from_world, measured);
  MissionMap elsewhere = without_rays;
  add_rays(since, radians(50.0), second_from_world, elsewhere);
  JoinOptions options = for_small_missions();
  options.place.sure_score = 400.0;
  options.place.refurnished.max_next = 0.6;
  const auto is_joined = [&](const MissionMap& second) {
    const std::vector<MissionMap> missions = {driven(before, {0, 1, 2, 3, 4}, 1, {}), second};
    return join_missions(missions, options).missions[1].component == 0;
  };
  // 84 % of the walls agree: by themselves they are enough, or they are not.
  for (const double min_agreement : {0.75, 0.9}) {
    options.place.min_agreement = min_agreement;
    EXPECT_EQ(is_joined(without_rays), min_agreement < 0.84);
    EXPECT_TRUE(is_joined(measured)) << min_agreement;
    EXPECT_FALSE(is_joined(elsewhere)) << min_agreement;
  }
}

/// The same mission, led astray in a doorway: what comes after lies elsewhere.
Placement astray(const MissionMap& mission, AsrId from, const Pose2& by) {
  Placement placement = mission.mission_from_asr;
  const Pose2 door = placement.at(from);
  for (auto& [id, pose] : placement) {
    if (id > from) pose = door * by * inverse(door) * pose;
  }
  return placement;
}

TEST(JoinMissions, TakesThatOfTwoAnswersWhichTheOthersBearOut) {
  const Pose2 second_from_world{20.0, -7.0, radians(123.0)};
  const std::vector<MissionMap> truth = {driven(building(), {0, 1, 2, 3, 4}, 1, {}),
                                         driven(building(), {1, 2, 3, 4}, 11, second_from_world)};
  const Placement wrong = astray(truth[1], 12, {1.5, -0.8, radians(90.0)});
  for (const bool is_first_wrong : {true, false}) {
    std::vector<MissionMap> missions = truth;
    missions[1].other_answer = wrong;
    if (is_first_wrong) std::swap(missions[1].other_answer, missions[1].mission_from_asr);
    const JoinedMissions joined = join_missions(missions, for_small_missions());
    EXPECT_EQ(joined.missions[1].component, 0);
    EXPECT_EQ(joined.missions[1].is_other_answer, is_first_wrong);
    EXPECT_LT(largest_error_m(joined, truth[1], inverse(second_from_world)), 0.05);
  }
}

TEST(JoinMissions, KeepsTheHeadingsThatAMissionsOwnCorrectionFound) {
  const Row row =
      row_of({4.0, 5.3, 7.1, 3.6, 6.2, 4.4, 5.8, 6.6}, {0.8, 1.4, 1.1, 0.0, 1.9, 0.6, 1.2, 1.6});
  std::vector<MissionMap> missions = {driven(row, {0, 1, 2, 3}, 1, {}),
                                      driven(row, {1, 2, 3, 4, 5, 6, 7}, 11, {4.0, 2.0, 0.7})};
  // Odometry bends by two degrees from room to room; the correction knew better, by walls.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  information.diagonal() << 1e3, 1e3, 1e3;
  for (AsrId id = 11; id < 17; ++id) {
    const auto& pose = missions[1].mission_from_asr;
    Pose2 bent = inverse(pose.at(id)) * pose.at(id + 1);
    bent.theta_rad += radians(2.0);
    missions[1].measured.push_back({id, id + 1, bent, information, false});
  }
  const JoinedMissions joined = join_missions(missions, for_small_missions());
  ASSERT_EQ(joined.missions[1].component, 0);
  const Pose2 world_from_mission = inverse(Pose2{4.0, 2.0, 0.7});
  EXPECT_LT(largest_error_m(joined, missions[1], world_from_mission),
            0.3);  // 1.3 m, were they not kept
}

/// Three rooms, and a corridor of pilasters all alike but for a few boxes.
Row rooms_and_corridor() {
  Row row = row_of({4.0, 5.3, 7.1}, {0.8, 1.4, 1.1});
  const double from = 17.0;
  const double length = 36.0;
  for (const DrawnWall& wall : room_walls(from, 0.0, length, 3.0, 0.9)) row.walls.push_back(wall);
  for (double x = from + 1.6; x < from + length; x += 1.0) {
    for (const double y : {0.0, 2.7}) {
      for (const DrawnWall& wall : room_walls(x, y, 0.3, 0.3, 0.0)) row.walls.push_back(wall);
    }
  }
  for (const double x : {13.3, 24.7, 34.1}) {
    for (const DrawnWall& wall : room_walls(from + x, 0.0, 0.7, 0.6, 0.0))
      row.walls.push_back(wall);
  }
  for (double x = 2.0; x < length; x += 4.0) row.middles.push_back({from + x, 1.5});
  return row;
}

TEST(JoinMissions, StraightensAMissionThatOthersOnlyMeetWhereItHasBent) {
  const Row row = rooms_and_corridor();
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < row.middles.size(); ++i) all.push_back(i);
  const Pose2 second_from_world{4.0, 2.0, 0.7};
  const MissionMap truth = driven(row, all, 11, second_from_world);
  std::vector<MissionMap> missions = {driven(row, {0, 1, 2}, 1, {}), truth,
                                      driven(row, all, 41, {1.0, 1.0, 2.0})};
  // Odometry drew each step of the second too long; nothing told it so.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  information.diagonal() << 1e3, 1e3, 1e4;
  const AsrId last = 10 + static_cast<AsrId>(all.size());
  for (AsrId id = 11; id < last; ++id) {
    Pose2 longer = inverse(truth.mission_from_asr.at(id)) * truth.mission_from_asr.at(id + 1);
    const double stretch = 1.0 + 0.20 / longer.position().norm();
    longer.x_m *= stretch;
    longer.y_m *= stretch;
    missions[1].measured.push_back({id, id + 1, longer, information, false});
    missions[1].mission_from_asr[id + 1] = missions[1].mission_from_asr[id] * longer;
  }
  const JoinedMissions joined = join_missions(missions, for_small_missions());
  for (const JoinedMission& mission : joined.missions) ASSERT_EQ(mission.component, 0);
  EXPECT_LT(largest_error_m(joined, truth, inverse(second_from_world)), 0.5);
  JoinOptions options = for_small_missions();
  options.straightenings = 0;
  const JoinedMissions bent = join_missions(missions, options);
  EXPECT_GT(largest_error_m(bent, truth, inverse(second_from_world)), 0.75);
}

TEST(JoinMissions, GivesTheSameForAnyNumberOfJobs) {
  const std::vector<MissionMap> missions = {
      driven(building(), {0, 1, 2, 3}, 1, {}),
      driven(building(), {3, 2, 1}, 11, {20.0, -7.0, radians(123.0)})};
  const JoinedMissions one = join_missions(missions, for_small_missions(), {}, 1);
  const JoinedMissions three = join_missions(missions, for_small_missions(), {}, 3);
  EXPECT_EQ(one.placement, three.placement);
}

/// Where several processes, here threads, lay the parts that they made.
struct Table {
  explicit Table(std::ptrdiff_t seats) : all_here(seats) {}
  std::barrier<> all_here;
  std::vector<std::string> parts;
  std::atomic<std::size_t> made = 0;
};

/// One of several that run the same: makes each part whose number is its own.
class Seat : public Workers {
 public:
  Seat(Table& table, std::size_t number, std::size_t seats)
      : table_(table), number_(number), seats_(seats) {}

  [[nodiscard]] bool is_shared() const override { return true; }
  [[nodiscard]] std::vector<std::string> shared(
      std::size_t count, int, const std::function<std::string(std::size_t)>& make) const override {
    if (number_ == 0) table_.parts.assign(count, "");
    table_.all_here.arrive_and_wait();
    for (std::size_t i = number_; i < count; i += seats_) table_.parts.at(i) = make(i);
    table_.made += count > number_ ? (count - number_ - 1) / seats_ + 1 : 0;
    table_.all_here.arrive_and_wait();
    std::vector<std::string> all = table_.parts;
    table_.all_here.arrive_and_wait();
    return all;
  }

 private:
  Table& table_;
  std::size_t number_;
  std::size_t seats_;
};

bool are_same(const Closure& a, const Closure& b) {
  return a.from == b.from && a.to == b.to && a.verdict == b.verdict &&
         a.match.agreeing == b.match.agreeing && a.match.unseen == b.match.unseen &&
         a.match.contradicting == b.match.contradicting &&
         a.match.first_from_second == b.match.first_from_second &&
         a.match.information == b.match.information;
}

TEST(JoinMissions, GivesTheSameToEachOfSeveralThatShareTheWork) {
  const std::vector<MissionMap> missions = {
      driven(building(), {0, 1, 2, 3}, 1, {}),
      driven(building(), {3, 2, 1}, 11, {20.0, -7.0, radians(123.0)}),
      driven(building(), {4, 3, 4}, 21, {-4.0, 9.0, radians(-64.0)})};
  const JoinedMissions alone = join_missions(missions, for_small_missions());
  constexpr std::size_t kSeats = 3;
  Table table(kSeats);
  std::vector<JoinedMissions> joined(kSeats);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < kSeats; ++i) {
      threads.emplace_back([&, i] {
        joined[i] = join_missions(missions, for_small_missions(), {}, Seat(table, i, kSeats));
      });
    }
  }
  EXPECT_GT(table.made, 10U);
  for (const JoinedMissions& one : joined) {
    EXPECT_EQ(one.placement, alone.placement);
    EXPECT_TRUE(std::equal(one.closures.begin(), one.closures.end(), alone.closures.begin(),
                           alone.closures.end(), are_same));
    for (std::size_t i = 0; i < missions.size(); ++i) {
      EXPECT_EQ(one.missions[i].component, alone.missions[i].component);
      EXPECT_EQ(one.missions[i].best.score, alone.missions[i].best.score);
      EXPECT_EQ(one.missions[i].best.fitting(), alone.missions[i].best.fitting());
      EXPECT_EQ(one.missions[i].runner_up_score, alone.missions[i].runner_up_score);
    }
  }
}

}  // namespace
}  // namespace roomatlas
