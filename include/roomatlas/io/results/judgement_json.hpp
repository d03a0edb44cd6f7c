// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "roomatlas/plan/judgement.hpp"

namespace roomatlas {

/// A judgement as one JSON object: what is said, why, and the figures that it is made from.
[[nodiscard]] std::string to_json(const Judgement& judgement);

/// The way back. Nothing for an empty text.
/// @throws InputError where it is no judgement
[[nodiscard]] std::optional<Judgement> judgement_of(const std::string& json);

}  // namespace roomatlas
