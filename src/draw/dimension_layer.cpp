// SPDX-License-Identifier: GPL-3.0-or-later
#include "dimension_text.hpp"
#include "plan_layers.hpp"
#include "style.hpp"
#include "svg.hpp"

#include "roomatlas/draw/dimensions.hpp"

#include <algorithm>

namespace roomatlas::drawing {
namespace {

constexpr double kInner_mm = 6.0;   // from the building to the chain over its walls ...
constexpr double kOuter_mm = 12.5;  // ... and to the overall dimension
constexpr double kGap_mm = 2.0;     // between the building and extension lines
constexpr double kOver_mm = 1.3;    // extension lines go on behind a dimension line ...
constexpr double kTick_mm = 0.9;    // ... and half a tick reaches as far to each side
constexpr double kLift_mm = 0.8;    // of text above its line
constexpr double kAside_mm =
    1.8;  // of text aside from the line: beyond the ends of the ticks' lines
constexpr double kClear_mm = 3.6;  // from the inner chain to where lines of the outer one begin

/// A chain on paper: along the lower edge, or upwards beside the left one.
struct Row {
  Point2 start;     ///< where the building begins, on the edge of its box
  Point2 along;     ///< the way in which the text reads
  Point2 outwards;  ///< away from the building
  [[nodiscard]] Point2 at(double along_mm, double out_mm) const {
    return start + along_mm * along + out_mm * outwards;
  }
};

Row row_of(const DimensionChain& chain, const Sheet& sheet) {
  const Point2 along = sheet.to_paper.direction(chain.along);
  const Point2 outwards = sheet.to_paper.direction(chain.outwards);
  const Point2 first = sheet.to_paper(chain.at(0));
  const bool is_below = std::abs(outwards.y()) > 0.5;
  const Point2 start = is_below ? Point2(first.x(), sheet.content_mm.max.y())
                                : Point2(sheet.content_mm.min.x(), first.y());
  return {start, along, outwards};
}

class DimensionPen {
 public:
  DimensionPen(pugi::xml_node group, const Row& row, const LineWeights& weights)
      : group_(group), row_(row), weights_(weights) {}

  /// A dimension line with its ticks, and extension lines from `from_mm`.
  void line(const std::vector<double>& places_mm, double out_mm, double from_mm) {
    add_line(group_, row_.at(places_mm.front() - kOver_mm, out_mm),
             row_.at(places_mm.back() + kOver_mm, out_mm));
    const Point2 tick = kTick_mm * (row_.along - row_.outwards);
    for (const double place : places_mm) {
      const Point2 at = row_.at(place, out_mm);
      add_line(group_, row_.at(place, from_mm), row_.at(place, out_mm + kOver_mm),
               {{"class", "extension"}});
      add_line(group_, at - tick, at + tick,
               {{"class", "tick"}, {"stroke-width", number(weights_.cut)}});
    }
  }

  /// Above its line as one reads it; beyond the line, seen from the building, where it is aside.
  void text(const DimensionText& text, double out_mm, const char* kind) {
    const bool is_upright = std::abs(row_.along.y()) > 0.5;  // its upper side looks away
    const double capital_mm = kDimensionText_mm * kCapHeight;
    double baseline_mm = is_upright ? out_mm + kLift_mm : out_mm - kLift_mm;
    if (text.is_aside) {
      baseline_mm =
          is_upright ? out_mm + kLift_mm + capital_mm + 0.5 : out_mm + kAside_mm + capital_mm;
    }
    const Point2 at = row_.at(text.middle_mm, baseline_mm);
    pugi::xml_node node =
        add_text(group_, at, text.text, {kDimensionText_mm, Weight::normal, Anchor::middle, kInk});
    node.append_attribute("class") = kind;
    node.append_attribute("stroke") = "none";
    if (!is_upright) return;
    const std::string turn = "rotate(-90 " + number(at.x()) + " " + number(at.y()) + ")";
    node.append_attribute("transform") = turn.c_str();
  }

 private:
  pugi::xml_node group_;
  Row row_;
  LineWeights weights_;
};

void add_chain(pugi::xml_node layer, const DimensionChain& chain, const Sheet& sheet) {
  const Row row = row_of(chain, sheet);
  const LineWeights weights = line_weights(sheet.scale);
  const double mm_per_m = sheet.to_paper.mm_per_m;
  pugi::xml_node group = add(layer, "g", {{"class", "chain"}});
  DimensionPen pen(group, row, weights);
  const auto on_paper = [&](const std::vector<double>& stations_m) {
    std::vector<double> places_mm;
    places_mm.reserve(stations_m.size());
    for (const double station : stations_m) places_mm.push_back(mm_per_m * station);
    return places_mm;
  };
  const FittedChain fitted = fitted_chain(chain.stations_m, mm_per_m);
  const bool has_parts = fitted.stations_m.size() > 2;
  if (has_parts) {
    pen.line(on_paper(fitted.stations_m), kInner_mm, kGap_mm);
    for (const DimensionText& text : fitted.texts) pen.text(text, kInner_mm, "part");
  }
  const std::vector<double> ends = {chain.stations_m.front(), chain.stations_m.back()};
  pen.line(on_paper(ends), kOuter_mm, has_parts ? kInner_mm + kClear_mm : kGap_mm);
  DimensionText total;
  total.text = metres_text(centimetres(ends).front()) + "\u00a0m";
  total.middle_mm = mm_per_m * chain.total_m() / 2.0;
  pen.text(total, kOuter_mm, "total");
}

}  // namespace

void add_dimensions(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet) {
  pugi::xml_node layer =
      add_layer(svg, "dimensions", true,
                {{"stroke", kFaintInk}, {"stroke-width", number(line_weights(sheet.scale).fine)}});
  for (const DimensionChain& chain : dimension_chains(plan)) add_chain(layer, chain, sheet);
}

}  // namespace roomatlas::drawing
