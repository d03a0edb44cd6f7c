// SPDX-License-Identifier: GPL-3.0-or-later
#include "carmen_message.hpp"

#include <algorithm>
#include <array>

namespace roomatlas::io {
namespace {

constexpr std::array kTags = {
    CarmenTag{"ODOM", CarmenKind::odometry},
    CarmenTag{"FLASER", CarmenKind::laser, LaserPlace::front},
    CarmenTag{"RLASER", CarmenKind::laser, LaserPlace::rear},
    CarmenTag{"ROBOTLASER1", CarmenKind::laser, LaserPlace::front},
    CarmenTag{"ROBOTLASER2", CarmenKind::laser, LaserPlace::rear},
    CarmenTag{"RAWLASER1", CarmenKind::laser, LaserPlace::front},
    CarmenTag{"RAWLASER2", CarmenKind::laser, LaserPlace::rear},
    CarmenTag{"RAWLASER3", CarmenKind::laser},
    CarmenTag{"RAWLASER4", CarmenKind::laser},
    CarmenTag{"SONAR", CarmenKind::sonar},
    CarmenTag{"TRUEPOS", CarmenKind::true_pose},
    CarmenTag{"PARAM", CarmenKind::parameter},
};

}  // namespace

const CarmenTag* find_carmen_tag(std::string_view name) {
  const auto found = std::find_if(kTags.begin(), kTags.end(),
                                  [&](const CarmenTag& tag) { return tag.name == name; });
  return found == kTags.end() ? nullptr : &*found;
}

bool begins_carmen_tag(std::string_view text) {
  return std::any_of(kTags.begin(), kTags.end(),
                     [&](const CarmenTag& tag) { return tag.name.starts_with(text); });
}

std::string list_carmen_tags() {
  std::string list;
  for (const CarmenTag& tag : kTags) {
    if (!list.empty()) list += ", ";
    list += tag.name;
  }
  return list;
}

}  // namespace roomatlas::io
