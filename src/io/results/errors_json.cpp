// SPDX-License-Identifier: GPL-3.0-or-later
#include "errors_json.hpp"

#include "text/json.hpp"
#include "text/json_number.hpp"

namespace roomatlas::io {
Json json_of(const RelationSubset& subset) {
  return {{"translation_m", json_of(subset.translation_m)},
          {"rotation_deg", json_of(subset.rotation_deg)}};
}

Json json_of(const Statistics& statistics) {
  return {{"count", statistics.count},
          {"mean", finite(statistics.mean)},
          {"std", finite(statistics.standard_deviation)},
          {"median", finite(statistics.median)},
          {"max", finite(statistics.maximum)},
          {"min", finite(statistics.minimum)},
          {"rmse", finite(statistics.rmse)},
          {"sse", finite(statistics.sse)},
          {"squared", finite(statistics.mean_square)}};
}

Json json_of(const RelationErrors& errors) {
  return {{"relations", errors.relations}, {"matched", errors.matched},
          {"coverage", errors.coverage()}, {"poses", to_string(errors.use)},
          {"all", json_of(errors.all)},    {"local", json_of(errors.local)},
          {"loop", json_of(errors.loop)}};
}

Json json_of(const TruePoseErrors& errors) {
  return {{"poses", errors.poses},
          {"matched", errors.matched},
          {"position_m", json_of(errors.position_m)},
          {"fitted_position_m", json_of(errors.fitted_position_m)},
          {"heading_deg", json_of(errors.heading_deg)}};
}

}  // namespace roomatlas::io
