// SPDX-License-Identifier: GPL-3.0-or-later
// Spaces without doors are one room, in however many pieces they were mapped.
#include <gtest/gtest.h>

#include "pipeline/memory_mission.hpp"
#include "roomatlas/pipeline/assemble.hpp"

namespace roomatlas {
namespace {

using namespace test;

void expect_one_room(const WorldDrawing& drawing, double true_area_m2, const MapOptions& options) {
  const MemoryStore store = mapped(events_of(readings_in(drawing)), options);
  EXPECT_GT(store.asrs.size(), 2U) << "mapped in several pieces";
  const Assembly assembly = assemble(store, {}, {});
  ASSERT_EQ(assembly.plan.rooms.size(), 1U);
  EXPECT_TRUE(assembly.plan.doors.empty());
  EXPECT_TRUE(assembly.doors.empty());
  EXPECT_EQ(assembly.plan.rooms[0].asrs.size(), store.asrs.size());
  EXPECT_NEAR(assembly.plan.rooms[0].area_m2, true_area_m2, 0.1 * true_area_m2);
  for (const auto& [asr, room] : assembly.room_of_asr) EXPECT_EQ(room, 1) << "ASR " << asr;
}

TEST(Pipeline, TakesAnOpenHallWithoutDoorsForOneRoom) {
  const WorldDrawing hall = {"########################################",  //
                             "#                                      #",  //
                             "#                                      #",  //
                             "#     b                          c     #",  //
                             "#                                      #",  //
                             "#                                      #",  //
                             "#                                      #",  //
                             "#                                      #",  //
                             "#     e                                #",  //
                             "#                                      #",  //
                             "#                                      #",  //
                             "#                                      #",  //
                             "#     a                          d     #",  //
                             "#     f                                #",  //
                             "#                                      #",  //
                             "########################################"};
  expect_one_room(hall, 38 * 14 * 0.09, {});
}

TEST(Pipeline, TakesACorridorLongerThanAPieceForOneRoom) {
  const WorldDrawing corridor = {std::string(102, '#'),
                                 "#" + std::string(100, ' ') + "#",
                                 "#" + std::string(100, ' ') + "#",
                                 "#   a" + std::string(92, ' ') + "b   #",
                                 "#" + std::string(100, ' ') + "#",
                                 "#" + std::string(100, ' ') + "#",
                                 std::string(102, '#')};
  for (const double piece_m : {5.0, 8.0}) {
    MapOptions options;
    options.record.max_piece_path_m = piece_m;
    expect_one_room(corridor, 100 * 5 * 0.09, options);
  }
}

}  // namespace
}  // namespace roomatlas
