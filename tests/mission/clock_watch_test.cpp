// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "io/mission_log.hpp"

namespace roomatlas {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What is told of the clock of scans at these times.
std::vector<std::string> told_of(const std::vector<double>& times_s) {
  std::string log;
  double x_m = 0.0;
  for (const double time_s : times_s) {
    const std::string pose = std::to_string(x_m += 0.01) + " 0 0";
    const std::string time = std::to_string(time_s);
    log += "FLASER 3 1.0 2.0 1.5 " + pose + " " + pose + " " + time + " host " + time + "\n";
  }
  std::vector<std::string> told;
  for (const std::string& text : test::texts(test::read_text_to_map(log).info.issues)) {
    if (text.find("time: ") != std::string::npos) told.push_back(text);
  }
  return told;
}

TEST(ClockWatch, SaysNothingOfAClockThatRuns) {
  EXPECT_THAT(told_of({100.0, 100.1, 100.2, 103.0}), IsEmpty());
  EXPECT_THAT(told_of({100.0, 100.1, 100.05, 100.2}), IsEmpty());  // two sensors, out of order
  EXPECT_THAT(told_of({100.0}), IsEmpty());
}

TEST(ClockWatch, CountsStepsBackAndNamesTheFirst) {
  EXPECT_THAT(told_of({100.0, 100.1, 20.0, 20.1, 3.0}),
              ElementsAre(HasSubstr(
                  "goes back 2 times, first from 100.1 s to 20.0 s at reading 3: readings")));
  EXPECT_THAT(told_of({100.0, 96.0, 92.0}), ElementsAre(HasSubstr("goes back 2 times")));
}

TEST(ClockWatch, AsksWhetherTimesAreInMilliseconds) {
  EXPECT_THAT(told_of({0.0, 100.0, 200.0}), ElementsAre(HasSubstr("100.0 s apart in the mean")));
}

}  // namespace
}  // namespace roomatlas
