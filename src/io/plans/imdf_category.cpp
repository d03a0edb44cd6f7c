// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>

#include "roomatlas/io/plans/imdf.hpp"

namespace roomatlas {
namespace {

struct Word {
  const char* word;      ///< in the room's name, lower case
  const char* category;  ///< UNIT-CATEGORY
};

/// The first that is found holds, so that a "meeting room" is not called a room.
constexpr std::array<Word, 26> kWords = {{{"elevator", "elevator"},
                                          {"lift", "elevator"},
                                          {"escalator", "escalator"},
                                          {"stairs", "stairs"},
                                          {"staircase", "stairs"},
                                          {"stairwell", "stairs"},
                                          {"restroom", "restroom"},
                                          {"toilet", "restroom"},
                                          {"toilets", "restroom"},
                                          {"wc", "restroom"},
                                          {"shower", "shower"},
                                          {"kitchen", "kitchen"},
                                          {"conference", "conferenceroom"},
                                          {"meeting", "conferenceroom"},
                                          {"office", "office"},
                                          {"lab", "laboratory"},
                                          {"laboratory", "laboratory"},
                                          {"classroom", "classroom"},
                                          {"auditorium", "auditorium"},
                                          {"library", "library"},
                                          {"server", "serverroom"},
                                          {"storage", "storage"},
                                          {"lobby", "lobby"},
                                          {"lounge", "lounge"},
                                          {"corridor", "walkway"},
                                          {"hallway", "walkway"}}};

/// The name with blanks for all that is no letter of ASCII, in lower case, and around it.
std::string words_of(const std::string& name) {
  std::string words = " " + name + " ";
  std::transform(words.begin(), words.end(), words.begin(), [](unsigned char c) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c >= 0x80U;
    return is_letter ? static_cast<char>(c < 0x80U ? std::tolower(c) : c) : ' ';
  });
  return words;
}

}  // namespace

std::string imdf_category(const PlanRoom& room) {
  const std::string words = words_of(room.name);
  for (const Word& entry : kWords) {
    if (words.find(" " + std::string(entry.word) + " ") != std::string::npos) return entry.category;
  }
  return room.kind == RoomKind::corridor ? "walkway" : "room";
}

}  // namespace roomatlas
