// SPDX-License-Identifier: GPL-3.0-or-later
#include "people.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kSlowestMPerS = 0.5;
constexpr double kFastestMPerS = 1.2;
constexpr double kShortestWayM = 5.0;
constexpr double kLongestWayM = 25.0;
constexpr double kLongestPauseS = 10.0;  // at the end of a way
constexpr double kPatienceS = 2.0;       // before the robot, until another way is sought
constexpr double kPoliteM = 0.5;         // beyond touching: people do not come nearer to the robot
constexpr double kBackOffM = 0.25;       // beyond touching: they step back
constexpr double kAppearM = 3.0;         // at least so far from the robot
constexpr double kTouchMarginM = 0.05;   // nobody stands nearer, not even for an instant
constexpr int kTries = 50;               // to find a place to appear
constexpr int kDirections = 16;          // in which a step back is tried
constexpr int kSides = 12;               // of a person's outline

}  // namespace

People::People(const FloorPlan& world, const SimulationOptions& options, const Point2& robot)
    : period_s_(1.0 / options.rate_hz),
      touching_m_(std::hypot(options.footprint.length_m, options.footprint.width_m) / 2.0 +
                  kPersonRadius_m + kTouchMarginM),
      random_(options.seed, "people") {
  if (options.people == 0) return;
  ways_.emplace(world, robot, WalkOptions{});
  people_.resize(static_cast<std::size_t>(options.people));
  for (Person& person : people_) {
    person.speed_m_per_s = between(kSlowestMPerS, kFastestMPerS);
    appear(person, robot);
  }
}

double People::between(double low, double high) { return low + (high - low) * random_.uniform(); }

void People::appear(Person& person, const Point2& robot) {
  person.way.clear();
  person.at.reset();
  for (int i = 0; i < kTries && !person.at; ++i) {
    const auto place = ways_->place(random_.uniform());
    if (place && (*place - robot).norm() >= kAppearM) person.at = place;
  }
}

void People::step(const Point2& robot) {
  for (Person& person : people_) {
    if (!person.at) appear(person, robot);
    if (!person.at) continue;
    person.pause_s -= period_s_;
    if ((*person.at - robot).norm() < touching_m_ + kBackOffM) {
      step_back(person, robot);
    } else if (person.pause_s <= 0.0) {
      walk(person, robot);
    }
    if ((*person.at - robot).norm() < touching_m_) appear(person, robot);
  }
}

/// Along the way, as far as the robot lets.
void People::walk(Person& person, const Point2& robot) {
  if (person.way.empty()) {
    const double length_m = between(kShortestWayM, kLongestWayM);
    person.way = ways_->way_from(*person.at, length_m, random_.uniform());
    std::reverse(person.way.begin(), person.way.end());
  }
  Point2 at = *person.at;
  double left_m = person.speed_m_per_s * period_s_;
  while (left_m > 0.0 && !person.way.empty()) {
    const Point2 ahead = person.way.back() - at;
    const double ahead_m = ahead.norm();
    at = ahead_m > left_m ? Point2(at + left_m / ahead_m * ahead) : person.way.back();
    if (ahead_m <= left_m) person.way.pop_back();
    left_m -= ahead_m;
  }
  const double now_m = (at - robot).norm();
  if (now_m < touching_m_ + kPoliteM && now_m < (*person.at - robot).norm()) {
    person.way.clear();
    person.pause_s = kPatienceS;
    return;
  }
  person.at = at;
  if (person.way.empty()) person.pause_s = between(0.0, kLongestPauseS);
}

/// A step at full speed to where it is farthest from the robot.
void People::step_back(Person& person, const Point2& robot) {
  person.way.clear();
  Point2 best = *person.at;
  for (int i = 0; i < kDirections; ++i) {
    const Point2 at =
        *person.at + kFastestMPerS * period_s_ * direction(2.0 * kPi * i / kDirections);
    if (ways_->is_walked(at) && (at - robot).norm() > (best - robot).norm()) best = at;
  }
  person.at = best;
}

std::vector<Point2> People::places() const {
  std::vector<Point2> places;
  for (const Person& person : people_) {
    if (person.at) places.push_back(*person.at);
  }
  return places;
}

std::vector<Segment2> People::edges() const {
  std::vector<Segment2> edges;
  const auto corner = [](const Point2& middle, int i) {
    return Point2(middle + kPersonRadius_m * direction(2.0 * kPi * (i % kSides) / kSides));
  };
  for (const Point2& at : places()) {
    for (int i = 0; i < kSides; ++i) edges.push_back({corner(at, i), corner(at, i + 1)});
  }
  return edges;
}

}  // namespace roomatlas
