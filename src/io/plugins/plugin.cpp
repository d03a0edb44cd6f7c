// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/plugin.hpp"

#include <dlfcn.h>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::io {
namespace {

/// Loading again what is loaded costs nothing and gives the same handle.
void* loaded(const Plugin& plugin) {
  return dlopen(plugin.file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
}

/// Why the linker did not do what it was last asked.
std::string reason() {
  const char* const text = dlerror();
  return text == nullptr ? "no reason given" : text;
}

/// And not a library that it needs, or memory.
bool is_missing(const Plugin& plugin, const std::string& reason) {
  return reason.starts_with(plugin.file + ": cannot open shared object file: No such file");
}

[[noreturn]] void fail(const Plugin& plugin, const std::string& reason) {
  const std::string text = plugin.purpose + " needs the plug-in " + plugin.file +
                           ", which cannot be loaded (" + reason + "): `apt-get install ";
  if (is_missing(plugin, reason)) {
    throw UsageError(text + plugin.package + "`, or name its folder in LD_LIBRARY_PATH");
  }
  throw InputError(text + "--reinstall " + plugin.package +
                   "` where its files are damaged or of another version");
}

}  // namespace

void* address_in(const Plugin& plugin, const char* function) {
  void* const library = loaded(plugin);
  if (library == nullptr) fail(plugin, reason());
  void* const address = dlsym(library, function);
  if (address == nullptr) fail(plugin, reason());
  return address;
}

bool is_there(const Plugin& plugin) {
  return loaded(plugin) != nullptr || !is_missing(plugin, reason());
}

}  // namespace roomatlas::io
