// SPDX-License-Identifier: GPL-3.0-or-later
#include "labels.hpp"

#include <algorithm>

namespace roomatlas::planar {
namespace {

using Border = PlanarMap::Border;

constexpr int kMaxRounds = 16;  // each absorbs every small piece once; a chain may need a few

/// Regions of one label that hang together by more than a vertex.
struct Component {
  Label label = kUnknown;
  bool is_bounded = true;
  double area_mm2 = 0.0;
  std::size_t first = 0;  ///< of its regions
  std::size_t count = 0;
};

/// All components of a labelled map. Keeps a reference to the map.
class Components {
 public:
  Components(const RegionMap& regions, const std::vector<Label>& labels);

  [[nodiscard]] const std::vector<Component>& all() const { return all_; }
  [[nodiscard]] Label label(const Border& border) const {
    return all_[static_cast<std::size_t>(border.region)].label;
  }
  /// Here `region` is the neighbouring component; each once, ascending.
  [[nodiscard]] std::vector<Border> borders(const Component& component) const;
  void relabel(const Component& component, Label label, std::vector<Label>& labels) const {
    for (const int region : regions_of(component)) labels[static_cast<std::size_t>(region)] = label;
  }

 private:
  [[nodiscard]] std::span<const int> regions_of(const Component& component) const {
    return {order_.data() + component.first, component.count};
  }

  const RegionMap& regions_;
  std::vector<Component> all_;
  std::vector<int> component_of_;
  std::vector<int> order_;  ///< regions, component by component
};

Components::Components(const RegionMap& regions, const std::vector<Label>& labels)
    : regions_(regions), component_of_(labels.size(), -1) {
  order_.reserve(labels.size());
  for (std::size_t seed = 0; seed < labels.size(); ++seed) {
    if (component_of_[seed] >= 0) continue;
    const int id = static_cast<int>(all_.size());
    Component component{labels[seed], true, 0.0, order_.size(), 0};
    order_.push_back(static_cast<int>(seed));
    component_of_[seed] = id;
    for (std::size_t at = component.first; at < order_.size(); ++at) {
      const int region = order_[at];
      component.area_mm2 += regions.map().area_mm2(region);
      component.is_bounded = component.is_bounded && region != PlanarMap::kOutside;
      for (const Border& border : regions.borders(region)) {
        const auto next = static_cast<std::size_t>(border.region);
        if (component_of_[next] >= 0 || labels[next] != component.label) continue;
        component_of_[next] = id;
        order_.push_back(border.region);
      }
    }
    component.count = order_.size() - component.first;
    all_.push_back(component);
  }
}

/// Adds up the stretches with each neighbour, in ascending order of the neighbours.
void join_stretches(std::vector<Border>& stretches) {
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Border& a, const Border& b) { return a.region < b.region; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    if (kept > 0 && stretches[kept - 1].region == stretches[i].region) {
      stretches[kept - 1].length_mm += stretches[i].length_mm;
    } else {
      stretches[kept++] = stretches[i];
    }
  }
  stretches.resize(kept);
}

std::vector<Border> Components::borders(const Component& component) const {
  std::vector<Border> found;
  const std::span<const int> regions = regions_of(component);
  const int self = component_of_[static_cast<std::size_t>(regions.front())];
  for (const int region : regions) {
    for (const Border& border : regions_.borders(region)) {
      const int other = component_of_[static_cast<std::size_t>(border.region)];
      if (other != self) found.push_back({other, border.length_mm});
    }
  }
  join_stretches(found);
  return found;
}

/// The neighbour with the longest common border; -1 without neighbours.
int main_neighbor(const std::vector<Border>& borders) {
  const auto longest =
      std::max_element(borders.begin(), borders.end(),
                       [](const auto& a, const auto& b) { return a.length_mm < b.length_mm; });
  return longest == borders.end() ? -1 : longest->region;
}

/// Indices of the pieces of rooms that are too small, the smallest first.
std::vector<std::size_t> small_rooms(const std::vector<Component>& components,
                                     double min_area_mm2) {
  std::vector<std::size_t> small;
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (components[c].label >= 0 && components[c].area_mm2 < min_area_mm2) small.push_back(c);
  }
  std::stable_sort(small.begin(), small.end(), [&](std::size_t a, std::size_t b) {
    return components[a].area_mm2 < components[b].area_mm2;
  });
  return small;
}

}  // namespace

RegionMap::RegionMap(const PlanarMap& map) : map_(map) {
  std::vector<Border> stretches;
  first_.push_back(0);
  for (int region = 0; region < map.region_count(); ++region) {
    stretches.clear();
    map.add_borders(region, stretches);
    join_stretches(stretches);
    borders_.insert(borders_.end(), stretches.begin(), stretches.end());
    first_.push_back(borders_.size());
  }
}

std::vector<Absorbed> absorb_small_rooms(const RegionMap& regions, double min_area_mm2,
                                         std::vector<Label>& labels) {
  std::vector<Absorbed> absorbed;
  bool is_done = false;
  for (int round = 0; round < kMaxRounds && !is_done; ++round) {
    is_done = true;
    const Components components(regions, labels);
    const std::vector<Component>& all = components.all();
    const std::vector<std::size_t> small = small_rooms(all, min_area_mm2);
    std::vector<char> is_settled(all.size(), 0);  // has given or taken in this round
    for (const std::size_t c : small) {
      if (is_settled[c] != 0) {
        is_done = false;  // what it took may have made it large enough, or not
        continue;
      }
      const int neighbor = main_neighbor(components.borders(all[c]));
      const auto taker = static_cast<std::size_t>(std::max(neighbor, 0));
      const bool is_room = neighbor >= 0 && all[taker].label >= 0;
      if (is_room && is_settled[taker] != 0) {
        is_done = false;  // joined in the next round
        continue;
      }
      const Label to = is_room ? all[taker].label : kUnknown;
      components.relabel(all[c], to, labels);
      absorbed.push_back({all[c].label, to, all[c].area_mm2});
      is_settled[c] = 1;
      if (is_room) is_settled[taker] = all[taker].area_mm2 < min_area_mm2 ? 1 : 0;
    }
  }
  return absorbed;
}

void fill_pinholes(const RegionMap& regions, double max_area_mm2, std::vector<Label>& labels) {
  const Components components(regions, labels);
  for (const Component& hole : components.all()) {
    if (hole.label != kUnknown || !hole.is_bounded || hole.area_mm2 > max_area_mm2) continue;
    const std::vector<Border> borders = components.borders(hole);
    if (borders.size() != 1) continue;
    const Label around = components.label(borders.front());
    if (around >= 0) components.relabel(hole, around, labels);
  }
}

void clear_wall_crumbs(const RegionMap& regions, double max_area_mm2, std::vector<Label>& labels) {
  const Components components(regions, labels);
  for (const Component& wall : components.all()) {
    if (wall.label != kWall) continue;
    Label taker = kUnknown;
    bool is_of_something = false;
    double longest_mm = 0.0;
    for (const Border& border : components.borders(wall)) {
      const Label label = components.label(border);
      is_of_something = is_of_something || label >= 0 || label == kDoor;
      if (label < 0 || border.length_mm <= longest_mm) continue;
      taker = label;
      longest_mm = border.length_mm;
    }
    const bool is_crumb = wall.area_mm2 <= max_area_mm2 && taker >= 0;
    if (is_crumb || !is_of_something) components.relabel(wall, taker, labels);
  }
}

void fill_wall_cavities(const RegionMap& regions, double max_width_mm, std::vector<Label>& labels) {
  const Components components(regions, labels);
  for (const Component& pocket : components.all()) {
    if (pocket.label != kUnknown || !pocket.is_bounded) continue;
    double perimeter_mm = 0.0;
    for (const Border& border : components.borders(pocket)) perimeter_mm += border.length_mm;
    if (2.0 * pocket.area_mm2 < max_width_mm * perimeter_mm) {
      components.relabel(pocket, kWall, labels);
    }
  }
}

}  // namespace roomatlas::planar
