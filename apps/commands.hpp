// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "settings.hpp"

namespace roomatlas::apps {

using Path = std::filesystem::path;

// Each command reads, makes one call of the library, writes and reports. They throw what the
// library throws; `main` turns that into an exit code.

void info(const Settings& settings, const Path& log);
void build(const Settings& settings, const Path& log, const Path& out,
           const std::vector<Path>& truth);
void map(const Settings& settings, const Path& log, const Path& store);
void assemble(const Settings& settings, const Path& store);
void export_all(const Settings& settings, const Path& store,
                const std::vector<std::string>& formats, const Path& out);
void evaluate(const Settings& settings, const Path& store, const std::vector<Path>& truth);
void simulate(const Settings& settings, const Path& world, const Path& drive, const Path& out);
void simulate_rooms(const Settings& settings, std::int64_t rooms, const Path& out);

/// The formats that `export` knows.
[[nodiscard]] std::vector<std::string> export_formats();

}  // namespace roomatlas::apps
