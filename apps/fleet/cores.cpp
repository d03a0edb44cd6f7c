// SPDX-License-Identifier: GPL-3.0-or-later
#include "cores.hpp"

#include <mpi.h>

#include <algorithm>

namespace roomatlas::apps {

NodeCores::NodeCores() {
  cpu_set_t own = {};
  (void)sched_getaffinity(0, sizeof own, &own);
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  MPI_Comm_size(node, &ranks_);
  MPI_Allreduce(&own, &all_, sizeof own, MPI_BYTE, MPI_BOR, node);
  MPI_Comm_free(&node);
}

int NodeCores::for_one_rank() const { return std::max(1, CPU_COUNT(&all_) / ranks_); }

int NodeCores::take_all(int jobs) const {
  (void)sched_setaffinity(0, sizeof all_, &all_);
  return jobs > 0 ? jobs * ranks_ : std::max(1, CPU_COUNT(&all_));
}

}  // namespace roomatlas::apps
