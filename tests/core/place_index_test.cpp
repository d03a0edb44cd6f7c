// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/place_index.hpp"
#include "roomatlas/correct/place.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <random>

namespace roomatlas {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

bool meet(const Box2& a, const Box2& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

TEST(PlaceIndex, FindsEveryBoxThatMeetsTheQuestionAndFewOthers) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-100.0, 100.0);
  std::uniform_real_distribution<double> size(0.0, 12.0);
  const auto some_box = [&] {
    const Point2 low(place(random), place(random));
    return Box2{low, low + Point2(size(random), size(random))};
  };
  std::vector<Box2> boxes;
  PlaceIndex index;
  for (std::size_t i = 0; i < 500; ++i) {
    boxes.push_back(some_box());
    index.add(i, boxes.back());
  }
  std::size_t found_in_all = 0;
  for (int question = 0; question < 200; ++question) {
    const Box2 box = some_box();
    const std::vector<std::size_t> found = index.near(box);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (meet(box, boxes[i])) {
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), i));
      }
    }
    found_in_all += found.size();
  }
  EXPECT_LT(found_in_all, 200U * 500U / 20U);
}

TEST(PlaceIndex, NeverFindsAnEmptyBoxAndAlwaysOneThatIsNotFinite) {
  PlaceIndex index;
  index.add(0, Box2{});
  index.add(1, {{0.0, 0.0}, {1.0, 1.0}});
  index.add(2, {{0.0, 0.0}, {std::numeric_limits<double>::infinity(), 1.0}});
  index.add(3, {{-1e8, -1e8}, {1e8, 1e8}});
  EXPECT_THAT(index.near(box_around({0.5, 0.5}, 0.1)), ElementsAre(1, 2, 3));
  EXPECT_THAT(index.near(box_around({500.0, 500.0}, 0.1)), ElementsAre(2, 3));
  EXPECT_THAT(index.near(Box2{}), IsEmpty());
}

TEST(PlaceIndex, AnswersAQuestionAboutTheWholeWorldWithEverything) {
  PlaceIndex index;
  index.add(4, box_around({0.0, 0.0}, 0.0));
  index.add(9, box_around({-3e7, 1e3}, 1.0));
  EXPECT_THAT(index.near(box_around({0.0, 0.0}, 1e12)), ElementsAre(4, 9));
}

}  // namespace
}  // namespace roomatlas
