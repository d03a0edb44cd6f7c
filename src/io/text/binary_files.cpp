// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/binary_files.hpp"

#include <algorithm>
#include <cctype>

namespace roomatlas::io {
namespace {

/// MRPT's framing of an object: the length of its class's name with the highest bit set, and the
/// name (CArchive::WriteObject): "CSensoryFrame", since MRPT 2 "mrpt::obs::CSensoryFrame".
bool is_mrpt_object(std::string_view beginning) {
  constexpr unsigned kMark = 0x80;
  constexpr std::size_t kShortest = 3;
  if (beginning.empty()) return false;
  const auto first = static_cast<unsigned char>(beginning.front());
  const std::size_t length = first & ~kMark;
  if ((first & kMark) == 0 || length < kShortest || beginning.size() <= length) return false;
  const std::string_view name = beginning.substr(1, length);
  const auto is_of_a_name = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == ':';
  };
  const std::size_t scope = name.rfind(':');
  const std::string_view plain = scope == std::string_view::npos ? name : name.substr(scope + 1);
  return plain.starts_with('C') && std::all_of(name.begin(), name.end(), is_of_a_name);
}

}  // namespace

std::string binary_kind(std::string_view beginning, bool is_packed) {
  const bool is_recording = beginning.starts_with("#ROSBAG V") ||
                            beginning.starts_with("\x89MCAP0\r\n") ||
                            beginning.starts_with("SQLite format 3");
  if (is_packed && is_recording) return "is a recording packed by gzip: unpack it with gunzip";
  if (is_mrpt_object(beginning)) {
    return "is a rawlog of MRPT, which is not read; expected a CARMEN log or a recording of "
           "topics: play it into a bag (rawlog_play of ROS's mrpt_rawlog, and `rosbag record`)";
  }
  return "";
}

}  // namespace roomatlas::io
