// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include <set>

#include "child.hpp"
#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Another run that holds a place: the system tells one open file from another, also in one
/// process.
class Holder {
 public:
  explicit Holder(const fs::path& lock)
      : descriptor_(open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    EXPECT_EQ(flock(descriptor_, LOCK_EX | LOCK_NB), 0);
    EXPECT_EQ(write(descriptor_, "4321", 4), 4);
  }
  ~Holder() { close(descriptor_); }
  Holder(const Holder&) = delete;
  Holder& operator=(const Holder&) = delete;

 private:
  int descriptor_;
};

TEST(TwoAtOnce, TheSecondRunIntoAFolderNamesTheFirstAndTouchesNothing) {
  const Folder folder;
  Child first("simulate --random-rooms 1000000 -o " + (folder / "out").string());
  ASSERT_TRUE(first.has_said("simulate ...")) << first.err();
  const auto listed = [&] {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder / "out")) {
      const std::string name = entry.path().filename().string();
      if (name.find("-wal") == std::string::npos && name.find("-shm") == std::string::npos) {
        names.insert(name);
      }
    }
    return names;
  };
  const std::set<std::string> before = listed();
  const Outcome second = run("simulate --random-rooms 3 -o " + (folder / "out").string());
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_THAT(second.err, AllOf(HasSubstr((folder / "out").string() + ": another run (process "),
                                HasSubstr("nothing was touched")));
  EXPECT_EQ(listed(), before);

  first.send({SIGKILL});
  EXPECT_EQ(first.wait(), SIGKILL);
  EXPECT_EQ(run("-q simulate --random-rooms 3 -o " + (folder / "out").string()).exit_code, 0)
      << "a killed run leaves no lock";
  EXPECT_FALSE(fs::exists(folder / "out" / ".roomatlas.lock"));
}

TEST(TwoAtOnce, AStoreThatIsBeingWrittenIsNeitherAssembledNorRenamedNorReplaced) {
  const Folder folder;
  const std::string store = assembled_store(folder);
  const std::string bytes = content_of(store);
  const std::string log = folder.write("empty.clf", "").string();
  const Holder other(store + ".lock");
  for (const std::string& command :
       {"assemble " + store, "rename " + store + " 1 Kitchen", "map " + log + " -o " + store}) {
    const Outcome outcome = run("-q " + command);
    EXPECT_EQ(outcome.exit_code, 3) << command;
    EXPECT_THAT(outcome.err, HasSubstr(store + ": another run (process 4321) is writing here"));
  }
  EXPECT_EQ(content_of(store), bytes);
}

TEST(TwoAtOnce, AFileThatIsBeingWrittenIsLeftAlone) {
  const Folder folder;
  const std::string graph = folder.write("in.g2o", "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n").string();
  const std::string out = (folder / "out.g2o").string();
  const Holder other(out + ".part");
  const Outcome outcome = run("-q optimize " + graph + " -o " + out);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr(out + ": another run is writing it"));
  EXPECT_EQ(content_of(out + ".part"), "4321");
}

TEST(TwoAtOnce, TemporaryFilesOfAKilledRunAreRemovedByTheNext) {
  const Folder folder;
  const std::string store = assembled_store(folder);
  for (const char* ending : {".tmp", ".tmp-journal", ".tmp-wal", ".copy.tmp"}) {
    std::ofstream(store + ending) << "half";
  }
  ASSERT_EQ(run("-q rename " + store + " 1 Kitchen").exit_code, 0);
  for (const char* ending :
       {".tmp", ".tmp-journal", ".tmp-wal", ".copy.tmp", ".lock", "-wal", "-shm"}) {
    EXPECT_FALSE(fs::exists(store + ending)) << ending;
  }
}

}  // namespace
}  // namespace roomatlas::test
