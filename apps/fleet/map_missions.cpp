// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_missions.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <set>
#include <thread>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks(10);

/// What the process of a mission says goes here; it stays where the mission fails.
Path said_file(const Path& store) { return store.string() + ".said"; }

/// Becomes the program, and ends when its rank does.
[[noreturn]] void become(const std::vector<char*>& arguments, const Path& said, pid_t rank) {
  (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != rank) _exit(127);  // it died in between
  const int file = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0) (void)dup2(file, STDERR_FILENO);
  (void)execv("/proc/self/exe", arguments.data());
  _exit(127);
}

pid_t start(std::vector<std::string> command, const Path& said) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t rank = getpid();
  const pid_t made = fork();
  if (made == 0) become(arguments, said, rank);
  if (made < 0) throw std::runtime_error(std::string("no process can be made: ") + strerror(errno));
  return made;
}

/// The last line that the process said, without the name of its log; how it ended, where it said
/// nothing.
std::string reason_of(const Path& log, const Path& said, int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("its process was ended by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  }
  std::string reason = fmt::format("its process ended with exit code {}", WEXITSTATUS(status));
  std::ifstream in(said);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("error: ")) reason = line.substr(std::strlen("error: "));
  }
  const std::string named = log.string() + ": ";
  if (reason.starts_with(named)) reason.erase(0, named.size());
  return reason;
}

class MissionMapping {
 public:
  MissionMapping(const FleetMissions& missions, const RunLocks& locks, int slots,
                 const std::function<std::vector<std::string>(std::size_t)>& command)
      : missions_(missions),
        locks_(locks),
        slots_(static_cast<std::size_t>(std::max(1, slots))),
        command_(command) {}
  ~MissionMapping() {
    for (const Running& one : running_) {
      (void)kill(one.process, SIGKILL);
      (void)waitpid(one.process, nullptr, 0);
    }
  }
  MissionMapping(const MissionMapping&) = delete;
  MissionMapping& operator=(const MissionMapping&) = delete;

  /// @returns false once all missions of all ranks are finished
  bool go_on() {
    reap();
    while (running_.size() < slots_ && begin_next()) {
    }
    if (++looks_ % kLooksAtOthers == 0) {
      while (first_open_ < missions_.stores.size() && is_done(first_open_)) ++first_open_;
      if (running_.empty()) take_over();
    }
    return !running_.empty() || first_open_ < missions_.stores.size();
  }

 private:
  struct Running {
    std::size_t mission = 0;
    pid_t process = 0;
    int tries = 0;
  };

  [[nodiscard]] bool is_done(std::size_t i) const {
    return finished_.contains(i) || locks_.is_held(RunLocks::done(i));
  }
  void begin(std::size_t mission, int tries) {
    const Path& store = missions_.stores[mission];
    running_.push_back({mission, start(command_(mission), said_file(store)), tries});
  }
  /// The next mission that nobody has. @returns false where there is none
  bool begin_next() {
    for (; next_ < missions_.stores.size(); ++next_) {
      if (!locks_.take(RunLocks::mission(next_))) continue;
      begin(next_++, 1);
      return true;
    }
    return false;
  }
  /// Of those that another rank had, the first one whose rank has died.
  void take_over() {
    for (std::size_t i = first_open_; i < missions_.stores.size(); ++i) {
      if (is_done(i) || !locks_.take(RunLocks::mission(i))) continue;
      if (is_done(i)) continue;
      spdlog::warn("{}: the rank that mapped it died; another maps it",
                   missions_.logs[i].filename().string());
      begin(i, 1);
      return;
    }
  }
  void reap() {
    std::vector<Running> still;
    for (const Running& one : std::exchange(running_, {})) {
      int status = 0;
      if (waitpid(one.process, &status, WNOHANG) == 0) {
        still.push_back(one);
      } else {
        finish(one, status);
      }
    }
    running_.insert(running_.end(), still.begin(), still.end());
  }
  void finish(const Running& one, int status) {
    const Path& store = missions_.stores[one.mission];
    const std::string name = missions_.logs[one.mission].filename().string();
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
      std::filesystem::remove(said_file(store));
      spdlog::info("{}: mapped", name);
    } else {
      const std::string reason = reason_of(missions_.logs[one.mission], said_file(store), status);
      if (WIFSIGNALED(status) && one.tries < kTries) {
        spdlog::warn("{}: {}; it is tried once more", name, reason);
        begin(one.mission, one.tries + 1);
        return;
      }
      spdlog::warn("{}: failed: {}", name, reason);
      std::ofstream(failure_file(store)) << reason << '\n';
    }
    finished_.insert(one.mission);
    (void)locks_.take(RunLocks::done(one.mission));
  }

  static constexpr int kLooksAtOthers =
      10;                           // a lock of another node is a question over the network
  static constexpr int kTries = 2;  // of what a signal ended, such as the system short of memory

  const FleetMissions& missions_;
  const RunLocks& locks_;
  std::size_t slots_;
  const std::function<std::vector<std::string>(std::size_t)>& command_;
  std::vector<Running> running_;
  std::set<std::size_t> finished_;  ///< by this rank: a process cannot see its own locks
  int looks_ = 0;
  std::size_t next_ = 0;
  std::size_t first_open_ = 0;
};

}  // namespace

Path failure_file(const Path& store) { return store.string() + ".failed"; }

void map_missions(const FleetMissions& missions, const RunLocks& locks, int slots,
                  const std::function<std::vector<std::string>(std::size_t)>& command,
                  const std::function<bool()>& stops) {
  MissionMapping mapping(missions, locks, slots, command);
  while (mapping.go_on()) {
    if (stops()) {
      throw Interrupted("interrupted; run the same command to go on from the finished missions");
    }
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

}  // namespace roomatlas::apps
