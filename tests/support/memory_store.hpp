// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/memory_store.hpp"

namespace roomatlas::test {

using roomatlas::MemoryStore;

}  // namespace roomatlas::test
