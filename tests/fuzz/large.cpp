// SPDX-License-Identifier: GPL-3.0-or-later
#include "large.hpp"

#include <functional>

#include "mutate.hpp"

namespace roomatlas::fuzz {
namespace {

constexpr std::size_t kMegabyte = 1'000'000;

std::string position(double x, double y) {
  return "[" + std::to_string(x) + "," + std::to_string(y) + "]";
}

/// A ring from its corners, closed.
std::string ring(const std::vector<std::string>& corners) {
  std::string text = "[";
  for (const std::string& corner : corners) text += corner + ",";
  return text + corners.front() + "]";
}

std::string box(double x, double y, double width, double height) {
  return ring({position(x, y), position(x + width, y), position(x + width, y + height),
               position(x, y + height)});
}

/// Rooms of these coordinates, as long as they take less than a megabyte together.
std::string rooms(const std::function<std::string(int)>& coordinates) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (int i = 0;; ++i) {
    const std::string room =
        R"({"type":"Feature","properties":{"indoor":"room"},"geometry":{"type":"Polygon","coordinates":[)" +
        coordinates(i) + "]}}";
    if (i > 0 && text.size() + room.size() > kMegabyte) break;
    text += (i > 0 ? "," : "") + room;
  }
  return text + "]}";
}

std::string scribble() {
  Random random(1);
  std::vector<std::string> corners;
  for (std::size_t i = 0; i < kMegabyte / 24; ++i) {
    corners.push_back(
        position(static_cast<double>(random() % 1000), static_cast<double>(random() % 1000)));
  }
  return ring(corners);
}

std::string pierced() {
  std::string text = box(0.0, 0.0, 1000.0, 1000.0);
  for (int i = 0; text.size() < kMegabyte; ++i) {
    text += "," + box(0.1 + i % 100, 0.1 + i / 100, 0.5, 0.5);
  }
  return text;
}

/// A grey picture of 1000 x 1000 pixels.
std::string picture(const std::function<int(int, int)>& grey) {
  std::string bytes = "P5\n1000 1000\n255\n";
  for (int y = 0; y < 1000; ++y) {
    for (int x = 0; x < 1000; ++x) bytes += static_cast<char>(grey(x, y));
  }
  return bytes;
}

std::string lines(const std::function<std::string(int)>& line) {
  std::string text;
  for (int i = 1; text.size() < kMegabyte; ++i) text += line(i) + "\n";
  return text;
}

}  // namespace

std::vector<std::string> large_worlds() {
  return {rooms([](int i) {
            const double at = 2.0 * (i / 2);
            return i % 2 == 0 ? box(0.0, at, 3000.0, 1.0) : box(at, 0.0, 1.0, 3000.0);
          }),
          rooms([](int i) { return box(0.01 * i, 0.01 * i, 50.0, 50.0); }),
          rooms([](int i) { return box(i % 60, i / 60, 1.0, 1.0); }),
          rooms([](int i) { return i == 0 ? scribble() : std::string(kMegabyte, ' '); }),
          rooms([](int i) { return i == 0 ? pierced() : std::string(kMegabyte, ' '); })};
}

std::vector<std::string> large_pictures() {
  Random random(1);
  return {picture([&](int, int) { return random() % 2 == 0 ? 0 : 254; }),
          picture([](int x, int y) { return y % 2 == 0 && x > 0 ? 0 : 254; }),
          picture([&](int, int) { return static_cast<int>(random() % 256); })};
}

std::vector<std::string> large_logs() {
  const auto number = [](int value) { return std::to_string(value); };
  std::string sweep = "FLASER 80000";
  for (int i = 0; i < 80'000; ++i) sweep += " 1.5";
  return {lines([&](int i) {
            return "SONAR 0.5236 2 1.25 3 0." + number(i) + " 0.2 1.571 0.3 -0.2 0 " + number(i) +
                   " h 0";
          }),
          lines([&](int i) { return sweep + " 0 0 0 0 0 0 " + number(i) + " h 0"; }),
          "ODOM 0 0 0 0 0 0 1 h 0\n" + lines([&](int i) { return "T" + number(i) + " 1"; })};
}

}  // namespace roomatlas::fuzz
