// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/for_each_index.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <latch>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace roomatlas {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ForEachIndex, CallsEachIndexOnceForAnyNumberOfJobs) {
  for (const int jobs : {0, 1, 2, 5, 100}) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
      std::vector<std::atomic<int>> calls(count);
      for_each_index(count, jobs, [&](std::size_t i) { ++calls[i]; });
      EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](const auto& n) { return n == 1; }))
          << count << " indices, " << jobs << " jobs";
    }
  }
}

TEST(ForEachIndex, WithOneJobWorksInOrderInTheCallingThread) {
  std::vector<std::size_t> order;
  std::set<std::thread::id> threads;
  for_each_index(4, 1, [&](std::size_t i) {
    order.push_back(i);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_THAT(order, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(threads, ElementsAre(std::this_thread::get_id()));
}

/// Each body waits for all others: without as many threads the test would never end.
TEST(ForEachIndex, RunsAsManyAtOnceAsThereAreJobs) {
  std::latch all_there(3);
  for_each_index(3, 3, [&](std::size_t) { all_there.arrive_and_wait(); });
  EXPECT_TRUE(all_there.try_wait());
}

TEST(ForEachIndex, NeverUsesMoreThreadsThanJobs) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  for_each_index(200, 2, [&](std::size_t) {
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_LE(threads.size(), 2U);
}

/// The second index fails first and the first after it: the first is told all the same.
TEST(ForEachIndex, ThrowsWhatTheLowestIndexThrewWhicheverFailedFirst) {
  std::latch second_has_begun(1);
  const auto fail = [&](std::size_t i) {
    if (i == 1) second_has_begun.count_down();
    if (i == 0) second_has_begun.wait();
    throw std::runtime_error("index " + std::to_string(i));
  };
  try {
    for_each_index(2, 2, fail);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "index 0");
  }
}

TEST(ForEachIndex, BeginsNoMoreAfterAFailure) {
  std::vector<std::size_t> begun;
  EXPECT_THROW(for_each_index(100, 1,
                              [&](std::size_t i) {
                                begun.push_back(i);
                                if (i == 2) throw std::runtime_error("no more");
                              }),
               std::runtime_error);
  EXPECT_THAT(begun, ElementsAre(0, 1, 2));
}

TEST(ForEachIndex, AsksTheCallerInItsOwnThreadAloneAndStopsWhenItThrows) {
  std::atomic<int> bodies = 0;
  std::set<std::thread::id> askers;
  const auto stop_at_third = [&](std::size_t) {
    askers.insert(std::this_thread::get_id());
    if (bodies >= 2) throw std::runtime_error("enough");
  };
  EXPECT_THROW(for_each_index(
                   1'000'000, 2, [&](std::size_t) { ++bodies; }, stop_at_third),
               std::runtime_error);
  EXPECT_THAT(askers, ElementsAre(std::this_thread::get_id()));
  EXPECT_LT(bodies, 1'000'000);
}

TEST(ResultsOf, StandInTheOrderOfTheirIndices) {
  for (const int jobs : {1, 2, 5}) {
    const auto squares = results_of<std::size_t>(6, jobs, [](std::size_t i) { return i * i; });
    EXPECT_THAT(squares, ElementsAre(0, 1, 4, 9, 16, 25));
  }
  EXPECT_THAT(results_of<int>(0, 2, [](std::size_t) { return 1; }), IsEmpty());
}

TEST(ThreadCount, IsThatOfTheCoresWhereNoneIsGiven) {
  EXPECT_EQ(thread_count(3), 3U);
  EXPECT_EQ(thread_count(0), std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace
}  // namespace roomatlas
