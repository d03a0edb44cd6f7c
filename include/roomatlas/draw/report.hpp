// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace roomatlas {

/// The report page: one HTML document that needs no other file and no network, with a map
/// (Leaflet), a table of rooms linked to it, the correction's ledger, errors and parameters.
/// @param title of the page, plain text
/// @param data_json what the page shows, as `report_data` in io gives it
[[nodiscard]] std::string report_page(const std::string& title, const std::string& data_json);

}  // namespace roomatlas
