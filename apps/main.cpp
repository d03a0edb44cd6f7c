// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <glog/logging.h>
#include <malloc.h>

#include <exception>
#include <filesystem>

#include "command_line.hpp"
#include "commands.hpp"
#include "roomatlas/core/issue.hpp"

int main(int argc, char** argv) {
  using namespace roomatlas;
  constexpr int kLargeBytes = 1024 * 1024;
  (void)mallopt(M_MMAP_THRESHOLD, kLargeBytes);  // grids go back to the system once they are freed
  FLAGS_minloglevel = google::GLOG_FATAL;        // Ceres logs even when asked to be silent
  google::InitGoogleLogging(argv[0]);
  const auto fail = [](const std::exception& error, apps::ExitCode code) {
    fmt::print(stderr, "error: {}\n", error.what());
    return code;
  };
  try {
    return apps::run_command_line(argc, argv);
  } catch (const UsageError& error) {
    return fail(error, apps::kUsage);
  } catch (const InputError& error) {
    return fail(error, apps::kInput);
  } catch (const NotEnoughError& error) {
    return fail(error, apps::kNotEnough);
  } catch (const apps::GateFailed& error) {
    return fail(error, apps::kGateFailed);
  } catch (const Interrupted& error) {
    fmt::print(stderr, "{}\n", error.what());
    return apps::kInterrupted;
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(error, apps::kInput);
  } catch (const std::exception& error) {
    return fail(error, apps::kInternal);
  }
}
