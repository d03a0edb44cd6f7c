// SPDX-License-Identifier: GPL-3.0-or-later
// The targets under clang's libFuzzer: fuzz_readers --target=NAME [its flags] FOLDER; with
// --seeds=FOLDER it writes what there is to begin with, and ends; --list names the targets.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "mutate.hpp"
#include "roomatlas/core/issue.hpp"
#include "target.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace roomatlas::fuzz;

const Target* target = nullptr;

void write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : target->seeds()) {
    std::ofstream(folder / ("seed-" + std::to_string(++number)), std::ios::binary) << seed;
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  std::string name;
  std::string seeds;
  for (int i = 1; i < *count; ++i) {
    const std::string_view argument = (*arguments)[i];
    if (argument.starts_with("--target=")) name = argument.substr(9);
    if (argument.starts_with("--seeds=")) seeds = argument.substr(8);
    if (argument != "--list") continue;
    for (const Target& known : all_targets()) std::printf("%s\n", known.name.c_str());
    std::exit(0);
  }
  try {
    target = &target_named(name);
  } catch (const roomatlas::UsageError& error) {
    std::fprintf(stderr, "fuzz_readers: %s\n", error.what());
    std::exit(2);
  }
  if (seeds.empty()) return 0;
  write_seeds(seeds);
  std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  run_input(*target, std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}

/// Half of the mutations are our own, which know numbers in text.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, most);
  Random random(seed);
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string changed = mutated(bytes, bytes, random, most);
  std::copy(changed.begin(), changed.end(), data);
  return changed.size();
}
