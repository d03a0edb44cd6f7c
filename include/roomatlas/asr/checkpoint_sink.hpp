// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/asr/store.hpp"

namespace roomatlas {

/// A sink that also keeps where a run that is stopped can go on.
class CheckpointSink : public AsrSink {
 public:
  using AsrSink::put;
  /// Takes a whole ASR and, in the same breath, what a run needs to go on behind it: a crash leaves
  /// both or none. The checkpoint before it is forgotten.
  /// @param checkpoint bytes that mean something to who wrote them alone (`MapCheckpoint`)
  virtual void put(const Asr& asr, const std::string& checkpoint) = 0;
};

}  // namespace roomatlas
