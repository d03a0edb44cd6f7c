// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <istream>
#include <vector>

namespace roomatlas::apps {

/// Reads the file of `--config` line by line: one parameter a line, without sections. Throws
/// UsageError with file, line, what is wrong and what to do.
class ConfigurationFile : public CLI::ConfigTOML {
 public:
  /// @param app asked for the file's name when it is read
  explicit ConfigurationFile(const CLI::App& app) : app_(app) {}

  [[nodiscard]] std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

 private:
  const CLI::App& app_;
};

}  // namespace roomatlas::apps
