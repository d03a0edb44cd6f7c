// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/report.hpp"

#include "report_assets.hpp"
#include "roomatlas/draw/markup_text.hpp"

namespace roomatlas {
namespace {

/// JSON inside a script element must not hold what could end it; in JSON a `<` stands in texts
/// only.
std::string script_text(const std::string& json) {
  std::string escaped;
  for (const char c : json) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string part(const std::string& name, const std::string& title, const std::string& data_json) {
  if (name == "title") return markup_text(title);
  if (name == "data") return script_text(data_json);
  return drawing::report_assets().at(name);
}

}  // namespace

std::string report_page(const std::string& title, const std::string& data_json) {
  const std::string& page = drawing::report_assets().at("page.html");
  std::string html;
  std::size_t at = 0;
  for (std::size_t open = page.find("{{"); open != std::string::npos; open = page.find("{{", at)) {
    const std::size_t close = page.find("}}", open);
    html.append(page, at, open - at);
    html += part(page.substr(open + 2, close - open - 2), title, data_json);
    at = close + 2;
  }
  return html.append(page, at, std::string::npos);
}

}  // namespace roomatlas
