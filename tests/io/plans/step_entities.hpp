// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace roomatlas::test {

/// An instance of a STEP file; arguments at the outermost level, as they stand there.
struct StepEntity {
  std::string type;
  std::vector<std::string> arguments;
};

/// The DATA section by reference ("#7"). Says what is no instance as one of type "?".
std::map<std::string, StepEntity> step_entities(const std::string& file);

/// Rules of IFC4 that the file breaks, a sentence each: how many attributes an entity has, of which
/// kind they are, that references lead to what may stand there, that GlobalIds are unique and of
/// the right letters, and how often things may be related.
std::vector<std::string> broken_ifc_rules(const std::string& file);

}  // namespace roomatlas::test
