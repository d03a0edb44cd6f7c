// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_trust.hpp"

#include <array>
#include <cstdio>

#include "everywhere/everywhere_table.hpp"

namespace roomatlas::bench {
namespace {

constexpr std::array kBounds = {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 0.99, 1.0 + 1e-9};
constexpr double kTrusted = 0.95;
constexpr double kNearlyTrusted = 0.9;

template <typename... Values>
std::string line(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// A probability that was given, and whether it came true.
struct Said {
  double probability = 0.0;
  bool is_right = false;
};

std::string reliability(const std::string& title, const std::vector<Said>& all) {
  std::string text = "**" + title + "**\n\n| said | how many | said, mean | right | 95 % |\n" +
                     "|---|---|---|---|---|\n";
  for (std::size_t i = 0; i + 1 < kBounds.size(); ++i) {
    std::size_t count = 0, right = 0;
    double sum = 0.0;
    for (const Said& said : all) {
      if (said.probability < kBounds[i] || said.probability >= kBounds[i + 1]) continue;
      ++count;
      right += said.is_right ? 1 : 0;
      sum += said.probability;
    }
    if (count == 0) continue;
    const Interval interval = wilson(right, count);
    const auto of = static_cast<double>(count);
    text += line("| %.2f to %.2f | %zu | %.3f | %.3f | %.2f to %.2f |\n", kBounds[i],
                 std::min(1.0, kBounds[i + 1]), count, sum / of, static_cast<double>(right) / of,
                 interval.low, interval.high);
  }
  return text + "\n";
}

/// How many of some are so.
struct Share {
  std::size_t part = 0;
  std::size_t all = 0;
  void add(bool is_so) {
    ++all;
    part += is_so ? 1 : 0;
  }
};

std::string row(const char* what, const Share& share) {
  const Interval interval = wilson(share.part, share.all);
  return line(
      "| %s | %zu of %zu | %.3f | %.2f to %.2f |\n", what, share.part, share.all,
      share.all == 0 ? 0.0 : static_cast<double>(share.part) / static_cast<double>(share.all),
      interval.low, interval.high);
}

std::string summary(const std::vector<TrustSample>& samples) {
  Share right, trusted_right, right_given_90, place, heading, scale, visits;
  for (const TrustSample& one : samples) {
    right.add(one.is_right);
    if (one.said.probability >= kTrusted) trusted_right.add(one.is_right);
    if (one.is_right) right_given_90.add(one.said.probability >= kNearlyTrusted);
    place.add(one.place_m <= one.said.place_m);
    heading.add(one.heading_deg <= one.said.heading_deg);
    scale.add(one.scale_share <= one.said.scale_share);
    for (const TrustVisit& visit : one.visits) visits.add(visit.place_m <= visit.said_m);
  }
  return "| what | count | share | 95 % |\n|---|---|---|---|\n" + row("missions right", right) +
         row("right, of those given 0.95 and more", trusted_right) +
         row("given 0.9 and more, of those right", right_given_90) +
         row("places within their bar", place) + row("headings within their bar", heading) +
         row("scales within their bar", scale) + row("visits within their bar", visits) + "\n";
}

}  // namespace

std::string trust_tables(const std::vector<TrustSample>& samples) {
  std::string text;
  for (const SensorKind sensor : {SensorKind::laser, SensorKind::sonar}) {
    std::vector<TrustSample> own;
    std::vector<Said> maps, visits;
    std::string trusted_wrong;
    for (const TrustSample& one : samples) {
      if (one.sensor != sensor) continue;
      own.push_back(one);
      maps.push_back({one.said.probability, one.is_right});
      for (const TrustVisit& visit : one.visits) {
        visits.push_back({visit.probability, visit.is_right});
      }
      if (!one.is_right && one.said.probability >= kTrusted) {
        trusted_wrong +=
            line("| %s | %s | %.3f | %.2f | %.1f |\n", one.name.c_str(), one.stratum.c_str(),
                 one.said.probability, one.place_m, one.heading_deg);
      }
    }
    if (own.empty()) continue;
    text += sensor == SensorKind::laser ? "### Lasers\n\n" : "### Sonars\n\n";
    text += summary(own) + reliability("Maps", maps) + reliability("Visits", visits);
    if (!trusted_wrong.empty()) {
      text +=
          "Wrong, and given 0.95 or more:\n\n| run/case | stratum | said | 9 of 10 visits "
          "within (m) | largest heading error (deg) |\n|---|---|---|---|---|\n" +
          trusted_wrong + "\n";
    }
  }
  return text;
}

}  // namespace roomatlas::bench
