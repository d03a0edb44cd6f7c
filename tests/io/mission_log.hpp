// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/temporary_folder.hpp"

#include "roomatlas/io/logs/open_mission.hpp"

#include <zlib.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace roomatlas::test {

/// Everything that a log gives.
struct ReadLog {
  std::vector<RangeReading> readings;
  std::vector<TruePose> true_poses;
  MissionInfo info;
};

inline ReadLog read_all(const std::unique_ptr<MissionSource>& source) {
  ReadLog log;
  while (auto event = source->next()) {
    if (auto* reading = std::get_if<RangeReading>(&*event)) log.readings.push_back(*reading);
    if (auto* pose = std::get_if<TruePose>(&*event)) log.true_poses.push_back(*pose);
  }
  log.info = source->info();
  return log;
}

inline ReadLog read_log(const Path& file, const MissionOptions& options = {}) {
  return read_all(open_mission(file, options));
}

inline ReadLog read_text(const std::string& text, const MissionOptions& options = {}) {
  const TemporaryFolder folder;
  return read_log(folder.write("mission.clf", text), options);
}

/// As it is mapped.
inline ReadLog read_text_to_map(const std::string& text) {
  const TemporaryFolder folder;
  return read_all(open_mission_to_map(folder.write("mission.clf", text), {}));
}

/// `value` repeated, each time with a blank before it: the readings of a scan.
inline std::string times(int count, const std::string& value) {
  std::string text;
  for (int i = 0; i < count; ++i) text += " " + value;
  return text;
}

inline std::vector<std::string> texts(const Issues& issues) {
  std::vector<std::string> lines;
  for (const Issue& issue : issues) lines.push_back(to_string(issue));
  return lines;
}

/// The text as the bytes of a gzip file.
inline std::string gzipped(const TemporaryFolder& folder, const std::string& text) {
  const std::string name = folder / "scratch.gz";
  gzFile file = gzopen(name.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  return bytes_of(name);
}

}  // namespace roomatlas::test
