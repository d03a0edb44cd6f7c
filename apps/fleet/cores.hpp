// SPDX-License-Identifier: GPL-3.0-or-later
// The cores that a rank may use.
#pragma once

#include <sched.h>

namespace roomatlas::apps {

/// Those of the ranks of one node: mpirun binds each to some, or leaves all to all.
class NodeCores {
 public:
  /// Every rank calls it.
  NodeCores();

  /// Threads for this rank, as long as the others of its node work too.
  [[nodiscard]] int for_one_rank() const;
  /// Threads once the others have nothing left to do: `jobs` of each, or as many as they all have
  /// cores. This rank may run on all of these from now on.
  [[nodiscard]] int take_all(int jobs) const;

 private:
  cpu_set_t all_ = {};
  int ranks_ = 1;
};

}  // namespace roomatlas::apps
