// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Everything of the module; each topic has its own header.
#include "roomatlas/evaluate/alignment.hpp"
#include "roomatlas/evaluate/ape_rpe.hpp"
#include "roomatlas/evaluate/bootstrap.hpp"
#include "roomatlas/evaluate/compare.hpp"
#include "roomatlas/evaluate/figures.hpp"
#include "roomatlas/evaluate/plan_errors.hpp"
#include "roomatlas/evaluate/pose_lookup.hpp"
#include "roomatlas/evaluate/relations.hpp"
#include "roomatlas/evaluate/restamp.hpp"
#include "roomatlas/evaluate/statistics.hpp"
#include "roomatlas/evaluate/time_ranges.hpp"
#include "roomatlas/evaluate/true_poses.hpp"
