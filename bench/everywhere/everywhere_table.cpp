// SPDX-License-Identifier: GPL-3.0-or-later
#include "everywhere_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

namespace roomatlas::bench {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kWorst = 10;

template <typename... Values>
std::string text(const char* format, Values... values) {
  char line[512];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

double number_at(const Json& one, const char* path) {
  const Json::json_pointer pointer(path);
  if (!one.contains(pointer) || !one.at(pointer).is_number()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return one.at(pointer).get<double>();
}

/// Of the numbers that are any, the one below which a share of them lies.
double quantile(std::vector<double> values, double share) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// Rooms neither split nor merged.
bool has_right_graph(const Json& one) {
  return number_at(one, "/truth/graph/split") == 0.0 &&
         number_at(one, "/truth/graph/merged") == 0.0;
}

std::string line_of(const std::string& name, const std::vector<const Json*>& cases) {
  const auto counted = [&](const auto& holds) {
    return static_cast<std::size_t>(
        std::count_if(cases.begin(), cases.end(), [&](const Json* one) { return holds(*one); }));
  };
  const auto values = [&](const char* path) {
    std::vector<double> numbers;
    for (const Json* one : cases) numbers.push_back(number_at(*one, path));
    return numbers;
  };
  const auto is = [](const char* key) {
    return [key](const Json& one) { return one.at(key).get<bool>(); };
  };
  const std::size_t count = cases.size();
  const std::size_t right = counted(is("right"));
  const Interval share = wilson(right, count);
  const std::size_t failed = counted([](const Json& one) { return one.contains("failure"); });
  const std::size_t trusted = counted(is("trusted"));
  const std::size_t fooled = counted([](const Json& one) {
    return one.at("trusted").get<bool>() && !one.at("right").get<bool>();
  });
  const std::vector<double> away_m = values("/truth/rms_position_m");
  return text(
      "| %s | %zu | %zu | %.0f (%.0f to %.0f) | %zu | %.2f | %.2f | %.2f | %zu | %zu | %zu | %.0f "
      "|\n",
      name.c_str(), count, right, 100.0 * static_cast<double>(right) / static_cast<double>(count),
      100.0 * share.low, 100.0 * share.high, counted(has_right_graph), quantile(away_m, 0.5),
      quantile(away_m, 0.9), quantile(values("/truth/max_visit_position_m"), 0.5), trusted, fooled,
      failed, quantile(values("/processor_s"), 0.5));
}

using Groups = std::map<std::string, std::vector<const Json*>>;

std::string lines_of(const Groups& groups) {
  std::string lines;
  for (const auto& [name, cases] : groups) lines += line_of(name, cases);
  return lines;
}

/// How bad a wrong map is: those that came to nothing first.
double badness(const Json& one) {
  const double away_m = number_at(one, "/truth/rms_position_m");
  return std::isnan(away_m) ? std::numeric_limits<double>::infinity() : away_m;
}

std::string worst_of(std::vector<const Json*> cases) {
  std::erase_if(cases, [](const Json* one) { return one->at("right").get<bool>(); });
  std::stable_sort(cases.begin(), cases.end(),
                   [](const Json* a, const Json* b) { return badness(*a) > badness(*b); });
  if (cases.size() > kWorst) cases.resize(kWorst);
  std::string lines;
  for (const Json* one : cases) {
    lines +=
        everywhere_line(*one) +
        text("    ./run bench everywhere --seed %llu --from %llu --count 1 --keep\n",
             one->at("seed").get<unsigned long long>(), one->at("case").get<unsigned long long>());
  }
  return lines;
}

}  // namespace

Interval wilson(std::size_t hits, std::size_t count) {
  if (count == 0) return {};
  constexpr double z = 1.959964;
  const auto n = static_cast<double>(count);
  const double share = static_cast<double>(hits) / n;
  const double middle = share + z * z / (2.0 * n);
  const double half = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  const double whole = 1.0 + z * z / n;
  return {std::max(0.0, (middle - half) / whole), std::min(1.0, (middle + half) / whole)};
}

std::string everywhere_line(const Json& one) {
  std::string faults;
  for (const Json& fault : one.at("faults")) faults += ", " + fault.get<std::string>();
  const std::string failure =
      one.contains("failure") ? "; " + one.at("failure").get<std::string>() : std::string();
  return text(
      "case %llu (%s; %s; %s%s): %s%s, %.2f m, %.1f deg%.200s\n",
      one.at("case").get<unsigned long long>(), one.at("stratum").get<std::string>().c_str(),
      one.at("building").get<std::string>().c_str(), one.at("sensor").get<std::string>().c_str(),
      faults.c_str(), one.at("right").get<bool>() ? "right" : "WRONG",
      one.at("trusted").get<bool>() ? ", trusted" : "", number_at(one, "/truth/rms_position_m"),
      number_at(one, "/truth/rms_heading_deg"), failure.c_str());
}

std::string everywhere_table(const std::vector<Json>& cases) {
  Groups strata;
  Groups buildings;
  Groups sensors;
  Groups faults;
  std::vector<const Json*> judged;
  std::size_t undrawn = 0;
  for (const Json& one : cases) {
    if (one.contains("drawn") && !one.at("drawn").get<bool>()) {
      ++undrawn;
      continue;
    }
    judged.push_back(&one);
    const std::string stratum = one.at("stratum");
    strata[stratum].push_back(&one);
    strata["all"].push_back(&one);
    buildings[stratum + ": " + one.at("building").get<std::string>()].push_back(&one);
    sensors[stratum + ": " + one.at("sensor").get<std::string>()].push_back(&one);
    for (const Json& fault : one.at("faults")) {
      faults[stratum + ": " + fault.get<std::string>()].push_back(&one);
    }
  }
  std::string table =
      "| missions | number | right | % (95 %) | graph right | RMS (m), median | 90 % | worst visit "
      "(m), median "
      "| trusted | trusted and wrong | failed | processor (s), median |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Groups* groups : {&strata, &sensors, &faults, &buildings}) table += lines_of(*groups);
  if (undrawn > 0) table += text("\n%zu missions could not be simulated.\n", undrawn);
  return table + "\nWorst:\n\n" + worst_of(judged);
}

}  // namespace roomatlas::bench
