// SPDX-License-Identifier: GPL-3.0-or-later
#include "did_you_mean.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace roomatlas::apps {
namespace {

constexpr std::size_t kMostNames = 3;

/// Letters to be left out, added, changed or swapped with their neighbours to get from one to the
/// other, each stretch edited once (optimal string alignment; Boytsov, ACM J. Exp. Algorithmics 16,
/// 2011).
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) edits[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) edits[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      edits[i][j] = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, changed});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
    }
  }
  return edits[a.size()][b.size()];
}

/// Lower case, one sign for the several between words, and no leading ones.
std::string without_dashes(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '_' || c == ' ') c = '-';
  }
  return name.substr(std::min(name.size(), name.find_first_not_of('-')));
}

/// How far a name is from what was typed; none where it was hardly meant.
std::size_t distance(const std::string& typed, const std::string& name, std::size_t none) {
  constexpr std::size_t kShortestBeginning = 3;
  constexpr std::size_t kLettersPerEdit = 3;
  constexpr std::size_t kMostEdits = 3;
  const std::string wanted = without_dashes(name);
  if (typed.size() >= kShortestBeginning && wanted.starts_with(typed)) return 1;
  const std::size_t edits = edits_between(typed, wanted);
  const std::size_t most = std::clamp(typed.size() / kLettersPerEdit, std::size_t{1}, kMostEdits);
  const bool is_all_new = edits >= std::max(typed.size(), wanted.size());
  return edits <= most && !is_all_new ? edits : none;
}

}  // namespace

std::vector<std::string> nearest(const std::string& typed, const std::vector<std::string>& names) {
  constexpr std::size_t kNone = 1000;
  constexpr std::size_t kLongest = 64;  // no name is as long, and no memory is needed for it
  const std::string wanted = without_dashes(typed);
  if (wanted.empty() || wanted.size() > kLongest) return {};
  std::set<std::pair<std::size_t, std::string>> near;
  for (const std::string& name : names) {
    const std::size_t edits = distance(wanted, name, kNone);
    if (edits < kNone) near.emplace(edits, name);
  }
  std::vector<std::string> found;
  for (const auto& [edits, name] : near) {
    if (edits > near.begin()->first || found.size() == kMostNames) break;
    found.push_back(name);
  }
  return found;
}

std::string did_you_mean(const std::string& typed, const std::vector<std::string>& names) {
  const std::vector<std::string> found = nearest(typed, names);
  std::string text;
  for (std::size_t i = 0; i < found.size(); ++i) {
    text += (i == 0 ? "; did you mean " : i + 1 < found.size() ? ", " : " or ") + found[i];
  }
  return text.empty() ? text : text + "?";
}

}  // namespace roomatlas::apps
