// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/seen_last.hpp"

#include <array>

#include "roomatlas/core/counted.hpp"

namespace roomatlas {
namespace {

/// "2 pieces of furniture gone"
std::string words(ChangeKind kind, std::size_t count) {
  const std::string what = to_string(kind);
  const std::size_t end = what.rfind(' ');
  const std::string state = what.substr(end);
  const std::string thing = what.substr(0, end);
  if (thing == "furniture")
    return counted(count, "piece of furniture", "pieces of furniture") + state;
  if (thing == "door leaf") return counted(count, "door leaf", "door leaves") + state;
  return counted(count, thing) + state;
}

}  // namespace

std::string words(const SeenLast& seen) {
  std::array<std::size_t, kChangeKinds> counts{};
  for (const ThingSeenLast& thing : seen.things) ++counts.at(static_cast<std::size_t>(thing.kind));
  std::string list;
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    if (counts[kind] == 0) continue;
    list += (list.empty() ? "" : ", ") + words(static_cast<ChangeKind>(kind), counts[kind]);
  }
  const bool is_one = seen.things.size() == 1;
  return counted(seen.things.size(), "thing") + (is_one ? " is" : " are") + " drawn as " +
         seen.mission + " saw " + (is_one ? "it" : "them") + " last (" + list + ")";
}

}  // namespace roomatlas
