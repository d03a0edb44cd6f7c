// SPDX-License-Identifier: GPL-3.0-or-later
// Whenever a program that puts an assembly is killed, the store has the one before or the new one.
#include <sqlite3.h>
#include <sys/wait.h>

#include <csignal>

#include "io/store/assembly_samples.hpp"

namespace roomatlas {
namespace {

using Mode = GeoPackageStore::Mode;

/// Kills the child process at one of the moments at which SQLite tells of its work.
struct Bomb {
  int commits_left = -1;  ///< before this commit; negative: not armed
  int rows_left = -1;     ///< after this row
};
Bomb bomb;  // of the child process; SQLite's extension hook takes no argument

void on_row(void*, int, const char*, const char*, sqlite3_int64) {
  if (bomb.rows_left >= 0 && bomb.rows_left-- == 0) ::kill(::getpid(), SIGKILL);
}
int on_commit(void*) {
  if (bomb.commits_left >= 0 && bomb.commits_left-- == 0) ::kill(::getpid(), SIGKILL);
  return 0;
}
int lay_bomb(sqlite3* db, char**, const void*) {
  sqlite3_update_hook(db, on_row, nullptr);
  sqlite3_commit_hook(db, on_commit, nullptr);
  return SQLITE_OK;
}

Closure sample_closure(int agreeing) {
  Closure closure;
  closure.from = 1;
  closure.to = 2;
  closure.match.agreeing = agreeing;
  return closure;
}

/// All that an assembly consists of; two of them differ in each of its parts.
Assembly whole_assembly(int version) {
  FloorPlan plan = sample_plan();
  plan.title = "assembly " + std::to_string(version);
  Assembly assembly = sample_assembly(sample_correction(2 + version), plan, {{1, version}});
  assembly.measured_plan = plan;
  assembly.measured_plan->rooms.front().area_m2 = version;
  assembly.closures.assign(static_cast<std::size_t>(version), sample_closure(version));
  assembly.sonars.emplace();
  assembly.sonars->habits.lag_s = version;
  for (AsrId id = 1; id <= 2 + version; ++id) {
    assembly.mapped_again.push_back(sample_asr(id, 10 * version));
  }
  return assembly;
}

std::string configuration_of(int version) { return "cell = 0." + std::to_string(version); }

void write_first(const std::filesystem::path& file) {
  GeoPackageStore store(file, Mode::create);
  for (AsrId id = 1; id <= 3; ++id) store.put(sample_asr(id));
  store.put_former_rooms(sample_plan().rooms);
  store.put(whole_assembly(1), configuration_of(1));
  store.finish();
}

/// Puts the second assembly in a child process. @returns whether it was killed on the way
bool put_second(const std::filesystem::path& file, const Bomb& armed) {
  const pid_t child = ::fork();
  if (child == 0) {
    sqlite3_auto_extension(reinterpret_cast<void (*)()>(lay_bomb));
    GeoPackageStore store(file, Mode::update);
    const Assembly assembly = whole_assembly(2);
    bomb = armed;
    store.put(assembly, configuration_of(2));
    store.finish();
    ::_exit(0);
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFSIGNALED(status);
}

/// Which assembly a store has; every part of it has to be of the same.
int version_in(const std::filesystem::path& file) {
  const GeoPackageStore store(file, Mode::read);
  EXPECT_TRUE(store.has_assembly());
  const int version = store.plan().title == "assembly 1" ? 1 : 2;
  const Assembly expected = whole_assembly(version);
  expect_same(store.plan(), expected.plan);
  expect_same(store.correction(), expected.correction);
  EXPECT_EQ(store.measured_plan().rooms.front().area_m2, version);
  EXPECT_EQ(store.closures().size(), static_cast<std::size_t>(version));
  EXPECT_EQ(store.metadata().at("assembly_configuration"), configuration_of(version));
  EXPECT_EQ(store.metadata().at("rooms_configuration"), configuration_of(version));
  EXPECT_EQ(store.ids().size(), expected.mapped_again.size());
  for (const AsrId id : store.ids()) {
    EXPECT_EQ(store.get(id, AsrDetail::path).path.size(), static_cast<std::size_t>(10 * version));
    EXPECT_EQ(store.get(id, AsrDetail::geometry).room, id == 1 ? version : 0);
  }
  EXPECT_EQ(store.former_rooms().size(), expected.plan.rooms.size());
  return version;
}

TEST(AssemblyAfterAKill, IsTheOldOrTheNewOneWholeAtEveryCommit) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  std::vector<int> versions;
  for (int commit = 0;; ++commit) {
    write_first(file);
    const bool killed = put_second(file, {commit, -1});
    versions.push_back(version_in(file));
    if (!killed) break;
  }
  EXPECT_GE(versions.size(), 3U) << "killed at no commit";
  EXPECT_EQ(versions.front(), 1) << "before its only commit";
  for (std::size_t i = 1; i < versions.size(); ++i) EXPECT_EQ(versions[i], 2) << "kill " << i;
}

TEST(AssemblyAfterAKill, IsTheOldOrTheNewOneWholeBetweenAnyTwoRows) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  int kills = 0;
  for (int row = 0;; row += 17) {
    write_first(file);
    const bool killed = put_second(file, {-1, row});
    const int version = version_in(file);
    if (!killed) break;
    kills += version == 1 ? 1 : 0;
  }
  EXPECT_GT(kills, 5);
}

}  // namespace
}  // namespace roomatlas
