// SPDX-License-Identifier: GPL-3.0-or-later
#include "trust_samples.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "roomatlas/io/results/judgement_json.hpp"

namespace roomatlas::bench {
namespace {

using Json = nlohmann::json;

constexpr double kShare = 0.9;  // of the visits that keep the bar

double number(const Json& json) { return json.is_number() ? std::abs(json.get<double>()) : 0.0; }

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// How the mission was corrected: a laser's log may have been taken as sonars.
SensorKind sensor_of(const std::vector<JudgedFigure>& figures) {
  const bool has_loops =
      std::any_of(figures.begin(), figures.end(),
                  [](const JudgedFigure& figure) { return figure.name == "loops a visit"; });
  return has_loops ? SensorKind::laser : SensorKind::sonar;
}

TrustSample sample_of(const Json& one) {
  TrustSample sample;
  sample.name = std::to_string(one.at("seed").get<std::uint64_t>()) + "/" +
                std::to_string(one.at("case").get<std::uint64_t>());
  sample.stratum = one.at("stratum").get<std::string>();
  sample.said = judgement_of(one.at("summary").at("judgement").dump()).value();
  sample.figures = sample.said.figures;
  sample.sensor = sensor_of(sample.figures);
  const Json& truth = one.at("truth");
  sample.is_right = truth.at("right").get<bool>();
  sample.off = std::max(number(truth.at("max_visit_position_m")) / kRightPlace_m,
                        number(truth.at("max_room_heading_deg")) / kRightHeading_deg);
  sample.heading_deg = number(truth.at("max_visit_heading_deg"));
  sample.scale_share = std::max(number(truth.at("scale_x")), number(truth.at("scale_y")));
  std::map<AsrId, const VisitJudgement*> said;
  for (const VisitJudgement& visit : sample.said.visits) said[visit.asr] = &visit;
  std::vector<double> places_m;
  for (const Json& visit : truth.at("visits")) {
    const double place_m = visit.at("position_m").get<double>();
    places_m.push_back(place_m);
    const auto judged = said.find(visit.at("asr").get<AsrId>());
    if (judged == said.end()) continue;
    sample.visits.push_back(
        {judged->second->figures,
         place_m <= kRightPlace_m && visit.at("heading_deg").get<double>() <= kRightHeading_deg,
         place_m, judged->second->place_m, judged->second->probability});
  }
  sample.place_m = quantile(std::move(places_m), kShare);
  return sample;
}

/// Whether a map was made and could be judged; what was not is no sample of a judgement.
bool is_judged(const Json& one) {
  return one.contains("summary") && one["summary"].contains("judgement") && one.contains("truth") &&
         one["truth"].contains("visits");
}

}  // namespace

std::vector<TrustSample> read_samples(const std::vector<std::filesystem::path>& files) {
  std::vector<TrustSample> samples;
  for (const std::filesystem::path& file : files) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    for (std::string line; std::getline(stream, line);) {
      const Json one = Json::parse(line);
      if (is_judged(one)) samples.push_back(sample_of(one));
    }
  }
  std::sort(samples.begin(), samples.end(),
            [](const TrustSample& a, const TrustSample& b) { return a.name < b.name; });
  return samples;
}

}  // namespace roomatlas::bench
