// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/joined_source.hpp"

#include <gtest/gtest.h>

#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

MemoryStore mission(int visits) {
  MemoryStore store;
  for (int id = 1; id <= visits; ++id) {
    Asr asr;
    asr.id = id;
    asr.start_s = 100.0 * visits + id;
    if (id < visits) {
      asr.exits.emplace_back();
      asr.exits.back().neighbor = id + 1;
    }
    store.put(asr);
  }
  return store;
}

TEST(JoinedSource, NumbersTheVisitsOfEachMissionBehindThoseBefore) {
  const MemoryStore two = mission(2);
  const MemoryStore three = mission(3);
  const JoinedSource joined({&two, &three});
  EXPECT_EQ(joined.ids(), (std::vector<AsrId>{1, 2, 3, 4, 5}));
  EXPECT_EQ(joined.offset(1), 2);
  const Asr fourth = joined.get(4, AsrDetail::geometry);
  EXPECT_EQ(fourth.id, 4);
  EXPECT_EQ(fourth.start_s, 302.0);
  EXPECT_EQ(fourth.exits.at(0).neighbor, 5);
  EXPECT_EQ(joined.get(1, AsrDetail::geometry).exits.at(0).neighbor, 2);
  EXPECT_TRUE(joined.get(2, AsrDetail::geometry).exits.empty());  // no way from mission to mission
  EXPECT_THROW((void)joined.get(6, AsrDetail::geometry), InputError);
}

}  // namespace
}  // namespace roomatlas
