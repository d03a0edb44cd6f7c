// SPDX-License-Identifier: GPL-3.0-or-later
#include "exit_code.hpp"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <new>

#include "command_line.hpp"
#include "commands.hpp"
#include "printable.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {

int exit_code_of(const std::function<int()>& work) {
  const auto fail = [](const std::exception& error, ExitCode code) {
    fmt::print(stderr, "error: {}\n", printable_lines(error.what()));
    return code;
  };
  try {
    return work();
  } catch (const UsageError& error) {
    return fail(error, kUsage);
  } catch (const InputError& error) {
    return fail(error, kInput);
  } catch (const NotEnoughError& error) {
    return fail(error, kNotEnough);
  } catch (const GateFailed& error) {
    return fail(error, kGateFailed);
  } catch (const Interrupted& error) {
    fmt::print(stderr, "{}\n", printable_lines(error.what()));
    return kInterrupted;
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(error, kInput);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr,
               "error: not enough memory for this input: what it holds lies too far apart, or is "
               "damaged; a larger --cell needs less\n");
    return kInput;
  } catch (const std::exception& error) {
    return fail(error, kInternal);
  }
}

}  // namespace roomatlas::apps
