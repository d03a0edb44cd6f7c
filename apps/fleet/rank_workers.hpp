// SPDX-License-Identifier: GPL-3.0-or-later
// The ranks of an MPI run as workers: each makes its parts, the leader hands all of them round.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "roomatlas/core/workers.hpp"
#include "run_locks.hpp"

namespace roomatlas::apps {

/// Thrown in the others when the rank died that they follow: they begin again with the next.
struct LeaderDied : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown in the others when the leader has ended the run.
struct RunEnded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One rank among those that are alive. The leader, the lowest of them, makes the parts of whoever
/// dies meanwhile.
class RankWorkers : public Workers {
 public:
  /// @param stops asked while it waits; true ends the wait with Interrupted
  RankWorkers(const RunLocks& locks, int leader, int jobs, std::function<bool()> stops);

  [[nodiscard]] bool is_leader() const { return rank_ == leader_; }
  [[nodiscard]] bool is_shared() const override { return size_ - leader_ > 1; }
  /// @throws LeaderDied, RunEnded, Interrupted
  [[nodiscard]] std::vector<std::string> shared(
      std::size_t count, int jobs,
      const std::function<std::string(std::size_t)>& make) const override;

  /// The leader tells the others that the run has ended.
  void end() const;
  /// The others wait for that. @throws LeaderDied, Interrupted
  void wait_for_end() const;
  /// Known once the run has ended: whether ranks died. MPI_Finalize would wait for them for ever.
  [[nodiscard]] bool has_lost_ranks() const { return has_lost_ranks_; }

 private:
  using Parts = std::vector<std::string>;

  /// Those of a count that a rank makes.
  [[nodiscard]] std::vector<std::size_t> parts_of(int rank, std::size_t count) const;
  void collect(Parts& all, int jobs, const std::function<std::string(std::size_t)>& make) const;
  /// @returns false where the rank died
  bool receive(int rank, std::string& message) const;
  bool send(int rank, const std::string& message) const;
  void send_to_all(const std::string& message) const;
  /// The leader's next message. @throws LeaderDied
  [[nodiscard]] std::string from_leader() const;
  /// Asks again and again whether something has come about. @returns false where the rank died
  bool wait_for(int rank, const std::function<bool()>& has_come) const;

  const RunLocks& locks_;
  int leader_;
  std::function<bool()> stops_;
  int rank_ = 0;
  int size_ = 1;
  mutable bool has_lost_ranks_ = false;
  mutable std::vector<int> live_;  ///< as the leader knows them; the same in each rank
};

}  // namespace roomatlas::apps
