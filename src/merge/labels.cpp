// SPDX-License-Identifier: GPL-3.0-or-later
#include "labels.hpp"

#include <algorithm>
#include <map>

namespace roomatlas::planar {
namespace {

constexpr int kMaxRounds = 16;  // each absorbs every small piece once; a chain may need a few

Label& label_at(std::vector<Label>& labels, int region) {
  return labels[static_cast<std::size_t>(region)];
}

void relabel(const Component& component, Label label, std::vector<Label>& labels) {
  for (const int region : component.regions) label_at(labels, region) = label;
}

/// Component of each region; regions of a component are found in ascending order.
std::vector<int> flood(const PlanarMap& map, const std::vector<Label>& labels,
                       std::vector<Component>& components) {
  std::vector<int> component_of(labels.size(), -1);
  for (int seed = 0; seed < map.region_count(); ++seed) {
    if (component_of[static_cast<std::size_t>(seed)] >= 0) continue;
    const int id = static_cast<int>(components.size());
    Component component;
    component.label = labels[static_cast<std::size_t>(seed)];
    component.regions.push_back(seed);
    component_of[static_cast<std::size_t>(seed)] = id;
    for (std::size_t at = 0; at < component.regions.size(); ++at) {
      for (const auto& border : map.borders(component.regions[at])) {
        const auto next = static_cast<std::size_t>(border.region);
        if (component_of[next] >= 0 || labels[next] != component.label) continue;
        component_of[next] = id;
        component.regions.push_back(border.region);
      }
    }
    components.push_back(std::move(component));
  }
  return component_of;
}

void measure(const PlanarMap& map, const std::vector<int>& component_of, Component& component) {
  std::map<int, double> length_mm;
  const int self = component_of[static_cast<std::size_t>(component.regions.front())];
  for (const int region : component.regions) {
    component.area_mm2 += map.area_mm2(region);
    component.is_bounded = component.is_bounded && region != PlanarMap::kOutside;
    for (const auto& border : map.borders(region)) {
      const int other = component_of[static_cast<std::size_t>(border.region)];
      if (other == self) continue;
      length_mm[other] += border.length_mm;
      component.perimeter_mm += border.length_mm;
    }
  }
  for (const auto& [other, length] : length_mm) component.borders.push_back({other, length});
}

}  // namespace

std::vector<Component> components_of(const PlanarMap& map, const std::vector<Label>& labels) {
  std::vector<Component> components;
  const std::vector<int> component_of = flood(map, labels, components);
  for (Component& component : components) measure(map, component_of, component);
  return components;
}

int main_neighbor(const Component& component) {
  const auto longest =
      std::max_element(component.borders.begin(), component.borders.end(),
                       [](const auto& a, const auto& b) { return a.length_mm < b.length_mm; });
  return longest == component.borders.end() ? -1 : longest->region;
}

std::vector<Absorbed> absorb_small_rooms(const PlanarMap& map, double min_area_mm2,
                                         std::vector<Label>& labels) {
  std::vector<Absorbed> absorbed;
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<Component> components = components_of(map, labels);
    std::vector<std::size_t> small;
    for (std::size_t c = 0; c < components.size(); ++c) {
      if (components[c].label >= 0 && components[c].area_mm2 < min_area_mm2) small.push_back(c);
    }
    if (small.empty()) break;
    std::stable_sort(small.begin(), small.end(), [&](std::size_t a, std::size_t b) {
      return components[a].area_mm2 < components[b].area_mm2;
    });
    std::vector<bool> is_settled(components.size(), false);  // has given or taken in this round
    for (const std::size_t c : small) {
      if (is_settled[c]) continue;
      const int neighbor = main_neighbor(components[c]);
      const auto taker = static_cast<std::size_t>(std::max(neighbor, 0));
      const bool is_room = neighbor >= 0 && components[taker].label >= 0;
      if (is_room && is_settled[taker]) continue;  // joined in the next round
      const Label to = is_room ? components[taker].label : kUnknown;
      relabel(components[c], to, labels);
      absorbed.push_back({components[c].label, to, components[c].area_mm2});
      is_settled[c] = true;
      if (is_room) is_settled[taker] = components[taker].area_mm2 < min_area_mm2;
    }
  }
  return absorbed;
}

void fill_pinholes(const PlanarMap& map, double max_area_mm2, std::vector<Label>& labels) {
  const std::vector<Component> components = components_of(map, labels);
  for (const Component& hole : components) {
    if (hole.label != kUnknown || !hole.is_bounded || hole.area_mm2 > max_area_mm2) continue;
    if (hole.borders.size() != 1) continue;
    const Label around = components[static_cast<std::size_t>(hole.borders.front().region)].label;
    if (around >= 0) relabel(hole, around, labels);
  }
}

void clear_wall_crumbs(const PlanarMap& map, double max_area_mm2, std::vector<Label>& labels) {
  const std::vector<Component> components = components_of(map, labels);
  for (const Component& crumb : components) {
    if (crumb.label != kWall || crumb.area_mm2 > max_area_mm2) continue;
    Label taker = kWall;
    double longest_mm = 0.0;
    for (const auto& border : crumb.borders) {
      const Label label = components[static_cast<std::size_t>(border.region)].label;
      if (label < 0 || border.length_mm <= longest_mm) continue;
      taker = label;
      longest_mm = border.length_mm;
    }
    relabel(crumb, taker, labels);
  }
}

void fill_wall_cavities(const PlanarMap& map, double max_width_mm, std::vector<Label>& labels) {
  for (const Component& pocket : components_of(map, labels)) {
    if (pocket.label != kUnknown || !pocket.is_bounded) continue;
    if (2.0 * pocket.area_mm2 < max_width_mm * pocket.perimeter_mm) relabel(pocket, kWall, labels);
  }
}

}  // namespace roomatlas::planar
