// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/pipeline/assemble_joined.hpp"

namespace roomatlas::apps {

/// A building that was written, or a mission that stands alone and has its own store already.
struct WrittenBuilding {
  JoinedBuilding building;
  Path store;
  std::size_t rooms = 0;
};

/// Assembled stores, open to be joined: matched by one process or by several, and written by one.
class StoresToJoin {
 public:
  /// Of stores of the same mission one stays; `write` tells of the others.
  /// @throws InputError for a file that is no store
  /// @throws UsageError for buildings that share some of their missions
  explicit StoresToJoin(std::vector<Path> stores);
  StoresToJoin(const StoresToJoin&) = delete;
  StoresToJoin& operator=(const StoresToJoin&) = delete;

  /// What holds together; see `join_stores`.
  [[nodiscard]] std::vector<JoinedBuilding> joined(const Settings& settings,
                                                   const Progress& progress, const Workers& workers,
                                                   std::optional<std::size_t> base = {}) const;
  /// The mission whose frame a building at `place` has in which people named or corrected
  /// something.
  [[nodiscard]] std::optional<std::size_t> base_at(const Path& place) const;
  /// See `join_into`. The caller holds the lock of `place`.
  [[nodiscard]] std::vector<WrittenBuilding> write(const Settings& settings,
                                                   std::vector<JoinedBuilding> buildings,
                                                   const Path& place) const;

 private:
  void leave_out_repeated();

  std::vector<Path> files_;
  std::vector<std::unique_ptr<GeoPackageStore>> missions_;
  std::vector<std::string> left_out_;
};

/// Joins the missions of several assembled stores and writes a store for each building of two and
/// more: the largest at `place`, others beside it as NAME.2.gpkg and so on. Says which mission was
/// joined and why others were not. Missions that stand alone come last, the largest first.
/// @throws NotEnoughError for a store that is not assembled or has no readings
[[nodiscard]] std::vector<WrittenBuilding> join_into(const Settings& settings,
                                                     const std::vector<Path>& stores,
                                                     const Path& place);

/// Whether one of them is of several missions.
[[nodiscard]] bool is_any_joined(const std::vector<WrittenBuilding>& buildings);
/// @throws NotEnoughError where nothing holds any two missions together
void require_any_joined(const std::vector<WrittenBuilding>& buildings);

}  // namespace roomatlas::apps
