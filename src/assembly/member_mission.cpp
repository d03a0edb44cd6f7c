// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/assembly/member_mission.hpp"

#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

bool is_called(const MemberMission& member, std::size_t number, const std::string& name) {
  return name == member.name || name == std::to_string(number) ||
         name == member.name.substr(0, member.name.find('.'));
}

}  // namespace

std::size_t index_of(const std::vector<MemberMission>& members, const std::string& name) {
  std::vector<std::size_t> found;
  std::string known;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (is_called(members[i], i + 1, name)) found.push_back(i);
    known += (i > 0 ? ", " : "") + std::to_string(i + 1) + " (" + members[i].name + ")";
  }
  if (found.size() == 1) return found.front();
  throw UsageError("mission " + name + ": the building has " +
                   (found.empty() ? "none" : "several") + " of that name; its missions are " +
                   known + ": say the number");
}

}  // namespace roomatlas
