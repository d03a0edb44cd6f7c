// SPDX-License-Identifier: GPL-3.0-or-later
#include "fleet.hpp"

#include <mpi.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "command_line.hpp"
#include "console.hpp"
#include "cores.hpp"
#include "exit_code.hpp"
#include "join_stores.hpp"
#include "map_missions.hpp"
#include "mission_stores.hpp"
#include "output_places.hpp"
#include "rank_workers.hpp"
#include "run_locks.hpp"

namespace roomatlas::apps {
namespace {

constexpr std::size_t kFewest = 2;  // missions in a building that is joined

int rank_of_this() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int number_of_ranks() {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

Path missions_folder(const Path& out) { return out.parent_path() / "missions"; }

std::vector<Path> stores_of(const FleetArguments& arguments) {
  std::vector<LogPart> whole;
  for (const Path& log : arguments.logs) whole.push_back({log, {}});
  return stores_for(whole, missions_folder(arguments.out));
}

/// Paths as one message: each ends with the byte that no path holds.
std::string packed(const std::vector<Path>& paths) {
  std::string message;
  for (const Path& path : paths) message += path.string() + '\0';
  return message;
}

std::vector<Path> paths_in(const std::string& message) {
  std::vector<Path> paths;
  for (std::size_t from = 0; from < message.size();) {
    const std::size_t end = message.find('\0', from);
    paths.emplace_back(message.substr(from, end - from));
    from = end + 1;
  }
  return paths;
}

class FleetRank {
 public:
  FleetRank(const Settings& settings, const FleetArguments& arguments, const RunLocks& locks)
      : settings_(settings),
        arguments_(arguments),
        locks_(locks),
        missions_{arguments.logs, {}},
        rank_(rank_of_this()),
        jobs_(settings.jobs > 0 ? settings.jobs : cores_.for_one_rank()) {
    Settings told = settings;
    told.quiet = settings.quiet || rank_ != 0;
    progress_ = console_progress(told);
    told.quiet = true;
    silent_ = console_progress(told);
  }

  FleetOutcome run() {
    if (!is_alone()) return {rank_ == 0 ? exit_code_of([&] { return refuse(); }) : kOk, false};
    for (int leader = 0;; leader = lowest_alive()) {  // the first may have ended the run already
      if (leader > 0 && leader == rank_) {
        spdlog::warn("those before rank {} died; it leads now", leader);
      }
      const RankWorkers workers(locks_, leader, jobs_, [this] { return stops(); });
      try {
        if (const auto code = begin(workers)) return {*code, workers.has_lost_ranks()};
        if (!std::exchange(has_mapped_, true)) map();
        const int code =
            workers.is_leader() ? exit_code_of([&] { return lead(workers); }) : follow(workers);
        return {code, workers.has_lost_ranks()};
      } catch (const LeaderDied&) {
        continue;  // with the next one, from the beginning of the matching
      }
    }
  }

 private:
  /// No other run is at work in the same folder: one answer for all ranks.
  [[nodiscard]] bool is_alone() const {
    int is_alone = locks_.take(RunLocks::rank(rank_)) ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &is_alone, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    return is_alone != 0;
  }
  [[noreturn]] int refuse() const {
    throw InputError(missions_folder(arguments_.out).string() +
                     ": another run is at work here; wait for its end, or give another folder");
  }

  /// The missions' stores become known, where the leader can begin.
  /// @returns an exit code where it cannot, and the run has ended
  std::optional<int> begin(const RankWorkers& workers) {
    const auto hear = [&] {
      hear_stores(workers);
      return static_cast<int>(kOk);
    };
    if (workers.is_leader()) {
      const int code = exit_code_of(hear);
      if (code == kOk) return std::nullopt;
      workers.end();
      return code;
    }
    try {
      (void)hear();
      return std::nullopt;
    } catch (const RunEnded&) {
      return kOk;
    }
  }

  /// A next leader hands round the stores that it was told.
  void hear_stores(const RankWorkers& workers) {
    std::vector<Path>& known = missions_.stores;
    const auto told = workers.shared(
        1, 1, [&](std::size_t) { return packed(known.empty() ? decided_stores() : known); });
    const std::vector<Path> stores = paths_in(told.front());
    if (!known.empty() && stores != known) {
      throw std::runtime_error(
          "the leader died as it handed round the missions' stores; run the same command again");
    }
    known = stores;
  }

  /// What one rank asks for all, before anything is written: whether the building's place is free,
  /// and which store each mission has. Failures of a former run are forgotten.
  [[nodiscard]] std::vector<Path> decided_stores() const {
    require_output_store(arguments_.out, arguments_.logs);
    std::vector<Path> stores = stores_of(arguments_);
    for (const Path& store : stores) std::filesystem::remove(failure_file(store));
    return stores;
  }

  void map() {
    const int slots = number_of_ranks() * jobs_;
    const int each = std::max(1, slots / static_cast<int>(missions_.logs.size()));
    const auto command = [&](std::size_t i) {
      return arguments_.command(i, missions_.stores[i], each);
    };
    (void)progress_("map missions", 0.0);
    map_missions(missions_, locks_, std::max(1, jobs_ / each), command, [this] { return stops(); });
  }

  [[nodiscard]] bool stops() const { return !silent_("", 0.0); }

  [[nodiscard]] int lowest_alive() const {
    int rank = 0;
    while (rank < rank_ && !locks_.is_held(RunLocks::rank(rank))) ++rank;
    return rank;
  }

  /// As the leader saw it: another node may not know of a file yet.
  [[nodiscard]] std::vector<Path> finished(const RankWorkers& workers) const {
    const std::string has_failed =
        workers
            .shared(1, 1,
                    [&](std::size_t) {
                      std::string told;
                      for (const Path& store : missions_.stores) {
                        told += std::filesystem::exists(failure_file(store)) ? '1' : '0';
                      }
                      return told;
                    })
            .front();
    std::vector<Path> stores;
    for (std::size_t i = 0; i < has_failed.size(); ++i) {
      if (has_failed[i] == '0') stores.push_back(missions_.stores[i]);
    }
    return stores;
  }

  int lead(const RankWorkers& workers) const {
    try {
      write(workers);
    } catch (...) {
      (void)tell_failures();
      workers.end();
      throw;
    }
    workers.end();
    return tell_failures() > 0 ? kInput : kOk;
  }

  void write(const RankWorkers& workers) const {
    const std::vector<Path> stores = finished(workers);
    if (stores.size() < kFewest) {
      throw NotEnoughError("fewer than two missions could be mapped: there is nothing to join");
    }
    const PlaceLock lock = lock_new_store(arguments_.out, arguments_.logs);
    const StoresToJoin missions(stores);
    std::vector<JoinedBuilding> buildings = missions.joined(settings_, progress_, workers);
    Settings alone = settings_;  // the others have nothing left to do
    alone.jobs = cores_.take_all(settings_.jobs);
    const auto written = missions.write(alone, std::move(buildings), arguments_.out);
    require_any_joined(written);
    for (const WrittenBuilding& one : written) require_a_room(one.rooms, one.store);
  }

  /// Whatever goes wrong in this rank alone: the others go on without it.
  int follow(const RankWorkers& workers) const {
    try {
      if (const std::vector<Path> stores = finished(workers); stores.size() >= kFewest) {
        (void)StoresToJoin(stores).joined(settings_, progress_, workers);
      }
    } catch (const LeaderDied&) {
      throw;
    } catch (const Interrupted&) {
      throw;
    } catch (const RunEnded&) {
      return kOk;
    } catch (const std::exception& error) {
      spdlog::warn("rank {}: {}; the others go on without it", rank_, error.what());
      locks_.give_back(RunLocks::rank(rank_));
    }
    workers.wait_for_end();
    return kOk;
  }

  int tell_failures() const {
    int failed = 0;
    for (std::size_t i = 0; i < missions_.stores.size(); ++i) {
      std::ifstream in(failure_file(missions_.stores[i]));
      std::string reason;
      if (!std::getline(in, reason)) continue;
      spdlog::warn("{}: not in the building: {}", missions_.logs[i].string(), reason);
      ++failed;
    }
    if (failed > 0) {
      spdlog::warn("{} of {} missions failed", failed, missions_.stores.size());
    }
    return failed;
  }

  const Settings& settings_;
  const FleetArguments& arguments_;
  const RunLocks& locks_;
  FleetMissions missions_;
  NodeCores cores_;
  int rank_;
  int jobs_;
  bool has_mapped_ = false;  ///< once, under whichever leader
  Progress progress_;
  Progress silent_;  ///< asks the same, and tells nothing
};

}  // namespace

void map_mission_of_fleet(const Settings& settings, const Path& log, const Path& store) {
  require_no_map(log);
  (void)map_and_assemble(settings, {log, {}}, store);
}

FleetOutcome run_fleet(const Settings& settings, const FleetArguments& arguments) {
  if (arguments.logs.size() < kFewest) {
    throw UsageError("one mission makes no fleet: `roomatlas build` maps it");
  }
  make_folder(missions_folder(arguments.out));
  const RunLocks locks(missions_folder(arguments.out) / "fleet.lock");
  return FleetRank(settings, arguments, locks).run();
}

}  // namespace roomatlas::apps
