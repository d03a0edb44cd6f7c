// SPDX-License-Identifier: GPL-3.0-or-later
// roomatlas-fleet: many missions, mapped and joined by the ranks of an MPI run.
#include <fmt/format.h>
#include <mpi.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "bind_parameters.hpp"
#include "command_line.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "fleet.hpp"
#include "man_page.hpp"
#include "printable.hpp"
#include "roomatlas/core/issue.hpp"
#include "set_up_process.hpp"

namespace {

using namespace roomatlas;
using namespace roomatlas::apps;

struct CommandLine {
  Settings settings;
  FleetArguments files;
  // In the process of one mission:
  std::vector<int> mission;  ///< its number and the threads
  Path store;                ///< its own
};

/// @returns the exit code of a command line that is answered at once
std::optional<int> read(int argc, char** argv, CommandLine& line) {
  CLI::App app("mission logs of a fleet -> one building, by the ranks of an MPI run",
               "roomatlas-fleet");
  app.set_version_flag("--version", ROOMATLAS_VERSION);
  add_configuration_file(app);
  app.allow_config_extras(false);
  app.add_flag("-q,--quiet", line.settings.quiet, "errors alone on stderr")->configurable(false);
  app.add_flag("-v,--verbose", line.settings.verbose, "more on stderr")->configurable(false);
  app.add_option("MISSION", line.files.logs, "mission logs of one building or campus")
      ->required()
      ->configurable(false);
  app.add_option("-o,--output", line.files.out,
                 "store to write, such as building.gpkg; each mission's own store is put into the "
                 "folder `missions` beside it")
      ->required()
      ->configurable(false);
  CLI::Option* one =
      app.add_option("--one-mission", line.mission)->expected(2)->group("")->configurable(false);
  CLI::Option* store = app.add_option("--in-store", line.store)->group("")->configurable(false);
  one->needs(store);
  store->needs(one);
  bind_parameters(app, line.settings);
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  const bool speaks = rank == nullptr || std::string(rank) == "0";  // one of all is enough
  app.footer("mpirun --enable-recovery -n 8 roomatlas-fleet MISSION... -o building.gpkg");
  if (argc == 2 && std::string(argv[1]) == "--man") {  // for who installs it
    fmt::print("{}", man_page_alone(text_of(app), "[OPTIONS] MISSION... -o building.gpkg"));
    return kOk;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return speaks ? app.exit(success) : 0;
  } catch (const CLI::ParseError& error) {
    if (speaks)
      fmt::print(stderr, "error: {}\nrun `roomatlas-fleet --help`\n",
                 printable_lines(error.what()));
    return kUsage;
  }
  complete(line.settings, app);
  return std::nullopt;
}

/// One open store a mission, and some more.
void allow_many_files() {
  struct rlimit limit = {};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  (void)setrlimit(RLIMIT_NOFILE, &limit);
}

int run_mission(CommandLine& line) {
  line.settings.jobs = line.mission[1];
  line.settings.quiet = true;
  set_up_console(line.settings);
  return exit_code_of([&] {
    const auto number = static_cast<std::size_t>(line.mission[0]);
    map_mission_of_fleet(line.settings, line.files.logs.at(number), line.store);
    return static_cast<int>(kOk);
  });
}

int run_rank(CommandLine& line, int argc, char** argv) {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr) {
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);  // no rank outlives who started it
  }
  allow_many_files();
  set_up_console(line.settings);
  const std::vector<std::string> words(argv, argv + argc);
  line.files.command = [&words](std::size_t mission, const Path& store, int jobs) {
    std::vector<std::string> command = words;
    command.insert(command.begin() + 1,  // before a "--", behind which all are logs
                   {"--one-mission", fmt::format("{}", mission), fmt::format("{}", jobs),
                    "--in-store=" + store.string()});
    return command;
  };
  MPI_Init(&argc, &argv);
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);  // of a rank that died
  std::optional<FleetOutcome> outcome;
  const int code = exit_code_of([&] {
    outcome = run_fleet(line.settings, line.files);
    return outcome->exit_code;
  });
  if (!outcome) MPI_Abort(MPI_COMM_WORLD, code);
  if (outcome->has_lost_ranks) {
    (void)std::fflush(nullptr);
    _exit(code);  // MPI_Finalize would wait for those that died
  }
  MPI_Finalize();
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  set_up_process(argv[0]);
  CommandLine line;
  if (const auto answered = read(argc, argv, line)) return *answered;
  return line.mission.empty() ? run_rank(line, argc, argv) : run_mission(line);
}
