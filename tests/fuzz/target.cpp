// SPDX-License-Identifier: GPL-3.0-or-later
#include "target.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::fuzz {
namespace {

namespace fs = std::filesystem;

/// In memory where the system offers that, and gone with the program.
class Scratch {
 public:
  Scratch() {
    const fs::path memory = "/dev/shm";
    std::error_code error;
    const bool is_there = fs::is_directory(memory, error) && access(memory.c_str(), W_OK) == 0;
    std::string name =
        ((is_there ? memory : fs::temp_directory_path()) / "roomatlas-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for inputs");
    path_ = name;
    setenv("TMPDIR", name.c_str(), 1);  // what readers unpack goes there too
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

const Scratch& scratch() {
  static const Scratch folder;
  return folder;
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

[[noreturn]] void fail(const Target& target, const std::string& what) {
  std::fprintf(stderr, "%s: %s\n", target.name.c_str(), what.c_str());
  std::abort();
}

}  // namespace

void run_input(const Target& target, const std::string& bytes) {
  const fs::path file = scratch() / target.file_name;
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  const auto require_place = [&](const std::exception& error) {
    const std::string text = error.what();
    // The input, or a file beside it that it names.
    const bool names_file = text.find(target.file_name) != std::string::npos ||
                            text.find(file.parent_path().string() + "/") != std::string::npos;
    if (!names_file) fail(target, "names no file: " + text);
  };
  try {
    target.read(file, bytes);
  } catch (const InputError& error) {
    require_place(error);
  } catch (const NotEnoughError& error) {
    require_place(error);
  } catch (const UsageError& error) {
    require_place(error);
  } catch (const std::exception& error) {
    fail(target, std::string("an error that no reader may have: ") + error.what());
  }
}

const std::vector<Target>& all_targets() {
  static const std::vector<Target> targets = [] {
    std::vector<Target> all;
    for (const std::vector<Target>& family : families()) {
      all.insert(all.end(), family.begin(), family.end());
    }
    return all;
  }();
  return targets;
}

const Target& target_named(const std::string& name) {
  std::string names;
  for (const Target& target : all_targets()) {
    if (target.name == name) return target;
    names += " " + target.name;
  }
  throw UsageError("no target '" + name + "'; expected one of" + names);
}

std::string written(const std::string& file_name,
                    const std::function<void(const Path& file)>& write) {
  const fs::path file = scratch() / ("seed-" + file_name);
  write(file);
  std::string bytes = content_of(file);
  fs::remove_all(file);
  return bytes;
}

std::vector<std::string> pose_seeds() {
  return {"# t x y z qx qy qz qw\n1.5 1 2 0 0 0 0 1\n2.5 1.5 2 0 0 0 0.7 0.7\n3.5 2 2 0 0 0 1 0\n",
          "1 0 0 5\n0 1 0 6\n0 0 1 0\n", "1 0 0 5 0 1 0 6 0 0 1 0\n0 -1 0 5 1 0 0 6 0 0 1 0\n",
          "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0.1\n",
          "ODOM 0 0 0 0 0 0 1 h 0\nFLASER 1 7 1 2 3 1 2 3 5 h 0\nTRUEPOS 1 2 3 4 5 6 5 h 0\n"};
}

std::string shipped(const std::string& file) {
  return content_of(fs::path(ROOMATLAS_SOURCE_DIR) / "data" / file);
}

}  // namespace roomatlas::fuzz
