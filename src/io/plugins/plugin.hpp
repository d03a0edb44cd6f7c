// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace roomatlas::io {

/// A shared library of ours that is loaded when what it does is asked for: what it needs, and that
/// is much, burdens nobody else.
struct Plugin {
  std::string file;     ///< its name, for the dynamic linker
  std::string purpose;  ///< what cannot be done without it, for messages: "DXF"
  std::string package;  ///< Debian's package that has it
};

/// The plug-in's function of that name. The dynamic linker looks for the file: in the run path of
/// the program (or of the Python module) that holds this library, in LD_LIBRARY_PATH, and where
/// libraries are. It stays loaded. Throws UsageError where there is none, InputError where it
/// cannot be loaded (it is damaged, of another version, or memory is short), with the linker's
/// reason and what to do.
[[nodiscard]] void* address_in(const Plugin& plugin, const char* function);

template <typename Function>
[[nodiscard]] Function* function_in(const Plugin& plugin, const char* name) {
  return reinterpret_cast<Function*>(address_in(plugin, name));
}

/// Whether there is such a file; it need not be loadable.
[[nodiscard]] bool is_there(const Plugin& plugin);

}  // namespace roomatlas::io
