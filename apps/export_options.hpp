// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <vector>

#include "roomatlas/io/georeference.hpp"

namespace roomatlas::apps {

/// What `export` and `build` are told besides the parameters.
struct ExportOptions {
  std::vector<double> georef;  ///< latitude, longitude, heading of the y axis in deg; or empty

  /// Throws UsageError when it is not on the earth.
  [[nodiscard]] std::optional<GeoReference> reference() const;
};

/// Adds `--georef` to a command.
void add_export_options(CLI::App* command, ExportOptions& options);

}  // namespace roomatlas::apps
