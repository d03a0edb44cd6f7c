// SPDX-License-Identifier: GPL-3.0-or-later
#include "exit_code.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include "command_line.hpp"
#include "commands.hpp"
#include "printable.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {
namespace {

/// Says it if it can: where standard error is closed or full, the exit code must do.
void tell(const std::string& text) { (void)std::fputs((text + '\n').c_str(), stderr); }

InputError not_printed(const std::string& reason) {
  return InputError("standard output cannot be written: " + reason +
                    "; what was printed is not whole, files that were named are written");
}

/// What was printed is out, or it was not done.
void require_printed() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw not_printed(errno == 0 ? "it is closed or full" : std::strerror(errno));
}

}  // namespace

int exit_code_of(const std::function<int()>& work) {
  const auto fail = [](const std::exception& error, ExitCode code) {
    tell("error: " + printable_lines(error.what()));
    return code;
  };
  try {
    const int code = work();
    require_printed();
    return code;
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
    return fail(InputError(error.path1().string() + ": cannot be read or written: " +
                           error.code().message() + "; check the path, its links and permissions"),
                kInput);
  } catch (const std::system_error& error) {  // of standard output, or of a thread
    if (std::ferror(stdout) == 0) return fail(error, kInput);
    return fail(not_printed(error.code().message()), kInput);
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
