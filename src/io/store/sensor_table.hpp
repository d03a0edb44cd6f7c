// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database.hpp"
#include "roomatlas/mission/mission.hpp"

#include <map>
#include <memory>

namespace roomatlas {

/// The sensors of a store: each kept once, told apart by content, handed out as one shared value.
class SensorTable {
 public:
  /// The sensor's id, after writing it when the store does not have it yet.
  [[nodiscard]] std::int64_t id_of(Database& database,
                                   const std::shared_ptr<const RangeSensor>& sensor);
  /// Throws DamagedData when there is no such sensor.
  [[nodiscard]] std::shared_ptr<const RangeSensor> get(Database& database, std::int64_t id);
  /// Forgets what it knows, after a transaction that was rolled back.
  void forget();

 private:
  std::map<std::shared_ptr<const RangeSensor>, std::int64_t> id_of_;
  std::map<std::int64_t, std::shared_ptr<const RangeSensor>> sensor_of_;
};

}  // namespace roomatlas
