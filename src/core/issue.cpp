// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/issue.hpp"

namespace roomatlas {

std::string to_string(const Issue& issue) {
  std::string text = issue.file;
  if (issue.line > 0) text += ":" + std::to_string(issue.line);
  if (!text.empty()) text += ": ";
  if (!issue.field.empty()) text += issue.field + ": ";
  return text + issue.message;
}

}  // namespace roomatlas
