// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters and CLI11: one of the files that include it.
#pragma once

#include <CLI/CLI.hpp>

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "roomatlas/io/files/input_file.hpp"
#include "settings.hpp"

namespace roomatlas::apps {

/// Adds every parameter to the program: its flag, its key in the configuration file and its line in
/// `--help` and `config --print`.
void bind_parameters(CLI::App& app, Settings& settings);

/// Keeps what was given, and all parameters as they are set, after parsing.
void complete(Settings& settings, const CLI::App& app);

/// Reads the file of `--config` line by line: one parameter a line, without sections. Throws
/// UsageError with file, line, what is wrong and what to do.
class ConfigurationFile : public CLI::ConfigTOML {
 public:
  using Watches = std::map<std::string, std::unique_ptr<PipeWatch>>;

  /// @param app asked for the file's name when it is read
  /// @param opening by their names, once; let go when the file is open
  explicit ConfigurationFile(const CLI::App& app, std::shared_ptr<Watches> opening = {})
      : app_(app), opening_(std::move(opening)) {}

  [[nodiscard]] std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

 private:
  const CLI::App& app_;
  std::shared_ptr<Watches> opening_;
};

/// The option --config, whose file is read before the parameters on the command line.
void add_configuration_file(CLI::App& app);

}  // namespace roomatlas::apps
