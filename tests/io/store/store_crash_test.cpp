// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/store/store_samples.hpp"

#include <sqlite3.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace roomatlas {
namespace {

using Mode = GeoPackageStore::Mode;

/// Where in the life of its third ASR's transaction a child process kills itself.
enum class Moment { row_written, before_commit, after_commit };

struct WriteBomb {
  Moment moment = Moment::row_written;
  int commits_left = 0;
  bool armed = false;
};
WriteBomb write_bomb;  // of the child process; SQLite's extension hook takes no argument

void on_written_row(void*, int, const char*, const char* table, sqlite3_int64) {
  if (write_bomb.armed && write_bomb.moment == Moment::row_written &&
      std::string(table) == "path_samples") {
    ::kill(::getpid(), SIGKILL);
  }
}
int on_write_commit(void*) {
  if (write_bomb.armed && write_bomb.moment == Moment::before_commit) ::kill(::getpid(), SIGKILL);
  return 0;
}
int lay_write_bomb(sqlite3* db, char**, const void*) {
  sqlite3_update_hook(db, on_written_row, nullptr);
  sqlite3_commit_hook(db, on_write_commit, nullptr);
  return SQLITE_OK;
}

/// Writes ASRs in a child process that is killed in the transaction of ASR 3.
void crash_in_the_third_asr(const std::filesystem::path& file, Moment moment) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    write_bomb.moment = moment;
    sqlite3_auto_extension(reinterpret_cast<void (*)()>(lay_write_bomb));
    GeoPackageStore store(file, Mode::create);
    for (AsrId id = 1; id <= 3; ++id) {
      write_bomb.armed = id == 3;
      store.put(TruePose{static_cast<double>(id), {}});
      store.put(sample_asr(id, 3000));  // more than SQLite's cache holds
    }
    ::kill(::getpid(), SIGKILL);  // after the commit, before anything is closed
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

class StoreAfterAKill : public testing::TestWithParam<Moment> {};

TEST_P(StoreAfterAKill, HoldsWholeAsrsOnlyAndCanBeContinued) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  crash_in_the_third_asr(file, GetParam());
  const AsrId last = GetParam() == Moment::after_commit ? 3 : 2;
  {
    const GeoPackageStore store(file, Mode::read);
    EXPECT_EQ(static_cast<AsrId>(store.ids().size()), last);
    EXPECT_EQ(static_cast<AsrId>(store.truth().size()), last);
    for (AsrId id = 1; id <= last; ++id) {
      expect_same(store.get(id, AsrDetail::readings), sample_asr(id, 3000));
    }
  }
  GeoPackageStore store(file, Mode::update);
  for (AsrId id = last + 1; id <= 3; ++id) {
    store.put(TruePose{static_cast<double>(id), {}});
    store.put(sample_asr(id, 3000));
  }
  store.finish();

  GeoPackageStore undisturbed(directory / "undisturbed.gpkg", Mode::create);
  for (AsrId id = 1; id <= 3; ++id) {
    undisturbed.put(TruePose{static_cast<double>(id), {}});
    undisturbed.put(sample_asr(id, 3000));
  }
  undisturbed.finish();
  EXPECT_TRUE(bytes_of(file) == bytes_of(directory / "undisturbed.gpkg"));
}

std::string words(Moment moment) {
  switch (moment) {
    case Moment::row_written:
      return "RowWritten";
    case Moment::before_commit:
      return "BeforeCommit";
    case Moment::after_commit:
      return "AfterCommit";
  }
  return "";
}
void PrintTo(Moment moment, std::ostream* out) { *out << words(moment); }
std::string name_of(const testing::TestParamInfo<Moment>& moment) { return words(moment.param); }

INSTANTIATE_TEST_SUITE_P(At, StoreAfterAKill,
                         testing::Values(Moment::row_written, Moment::before_commit,
                                         Moment::after_commit),
                         name_of);

TEST(StoreAfterAKillFromOutside, HoldsEveryAsrThatWasAcknowledged) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  for (int round = 0; round < 6; ++round) {
    int acknowledged[2];
    ASSERT_EQ(::pipe(acknowledged), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      GeoPackageStore store(file, Mode::create);
      for (AsrId id = 1;; ++id) {
        store.put(sample_asr(id, 400));
        if (::write(acknowledged[1], "x", 1) != 1) ::_exit(1);
      }
    }
    ::close(acknowledged[1]);
    char byte = 0;
    AsrId count = 0;
    while (count < 3 && ::read(acknowledged[0], &byte, 1) == 1) ++count;
    std::this_thread::sleep_for(std::chrono::microseconds(700 * round));
    ::kill(child, SIGKILL);
    while (::read(acknowledged[0], &byte, 1) == 1) ++count;
    ::close(acknowledged[0]);
    ::waitpid(child, nullptr, 0);

    const GeoPackageStore store(file, round % 2 == 0 ? Mode::read : Mode::update);
    const std::vector<AsrId> ids = store.ids();
    ASSERT_GE(static_cast<AsrId>(ids.size()), count);
    ASSERT_LE(static_cast<AsrId>(ids.size()), count + 1);  // committed, not yet acknowledged
    for (const AsrId id : ids) {
      expect_same(store.get(id, AsrDetail::readings), sample_asr(id, 400));
    }
  }
}

}  // namespace
}  // namespace roomatlas
