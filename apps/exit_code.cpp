// SPDX-License-Identifier: GPL-3.0-or-later
#include "exit_code.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "command_line.hpp"
#include "commands.hpp"
#include "printable.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {
namespace {

/// Says it if it can: where standard error is closed or full, the exit code must do.
void tell(const std::string& text) { (void)std::fputs((text + '\n').c_str(), stderr); }

}  // namespace

int exit_code_of(const std::function<int()>& work) {
  const auto fail = [](const std::exception& error, ExitCode code) {
    tell("error: " + printable_lines(error.what()));
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
    tell(printable_lines(error.what()));
    return kInterrupted;
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(error, kInput);
  } catch (const std::bad_alloc&) {
    tell(
        "error: not enough memory for this input: what it holds lies too far apart, or is "
        "damaged; a larger --cell needs less");
    return kInput;
  } catch (const std::exception& error) {
    return fail(error, kInternal);
  }
}

}  // namespace roomatlas::apps
