// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/plans/plan_geojson.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace roomatlas::testing_io {

/// Reads a plan from a text by way of a temporary file `plan.geojson` of this test's own.
inline FloorPlan read_plan_text(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const Path folder = Path(testing::TempDir()) /
                      (std::string("roomatlas_") + test->test_suite_name() + "_" + test->name());
  std::filesystem::create_directories(folder);
  const Path file = folder / "plan.geojson";
  std::ofstream(file, std::ios::binary) << text;
  struct Cleaner {
    Path folder;
    ~Cleaner() { std::filesystem::remove_all(folder); }
  } const cleaner{folder};
  return read_plan(file);
}

/// A plan file that holds these features.
inline std::string collection(const std::string& features) {
  return R"({"type": "FeatureCollection",
    "roomatlas": {"schema": "plan", "version": 1, "units": "m", "title": "test"},
    "features": [)" +
         features + "]}";
}

}  // namespace roomatlas::testing_io
