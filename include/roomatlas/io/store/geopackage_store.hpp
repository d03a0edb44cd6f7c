// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/correct/correction.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace roomatlas {

/// The store: one GeoPackage per mission (docs/formats.md). While the online stage writes, each
/// ASR is one transaction in WAL mode; `finish` leaves `journal_mode=DELETE` and rewrites the file
/// with VACUUM INTO, so that its bytes depend on its content alone.
class GeoPackageStore : public AsrSink, public AsrSource {
 public:
  enum class Mode { create, update, read };

  /// `create` replaces what is there; `update` and `read` throw InputError when the file is
  /// missing, no store of ours, or of another schema version (naming both versions).
  GeoPackageStore(const std::filesystem::path& file, Mode mode);
  ~GeoPackageStore() override;

  void put(const Asr& asr) override;
  void put(const TruePose& truth) override;

  [[nodiscard]] std::vector<AsrId> ids() const override;
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override;
  [[nodiscard]] std::vector<TruePose> truth() const override;

  /// Run metadata: tool and schema version, configuration (TOML), SHA-256 of the input, mission
  /// counters. Keys are unique; writing one again replaces it.
  void put_metadata(const std::map<std::string, std::string>& values);
  [[nodiscard]] std::map<std::string, std::string> metadata() const;

  /// Puts other ASRs in the place of all that are there, in one transaction.
  void replace_asrs(const std::vector<Asr>& asrs);
  /// The matches of rooms that were tried, with what became of them; after `put_assembly`, which
  /// deletes those of an earlier run.
  void put_closures(const std::vector<Closure>& closures);
  /// As they were put. Information is zero in a store of an earlier release.
  [[nodiscard]] std::vector<Closure> closures() const;
  /// What `assemble` found: replaces what an earlier run left, in one transaction. Also writes
  /// each ASR's room and the corrected path as a feature layer.
  /// @param paths of ASRs whose readings were matched again: `get` has these from then on, but in
  ///   a store that is open to be updated, so that assembling again begins where it began before
  void put_assembly(const Correction& correction, const FloorPlan& plan,
                    const std::map<AsrId, RoomId>& room_of_asr, const Paths& paths = {});
  /// The same plan with its walls as measured; after `put_assembly`, which deletes that of an
  /// earlier run. Only rooms, doors, walls and free space are kept: all else is the plan's.
  void put_measured_plan(const FloorPlan& plan);
  [[nodiscard]] bool has_assembly() const;
  [[nodiscard]] Correction correction() const;
  [[nodiscard]] FloorPlan plan() const;
  /// The plan with its walls as measured; `plan` where they were not made regular.
  [[nodiscard]] FloorPlan measured_plan() const;

  /// Closes the store and makes its bytes reproducible.
  void finish();

  /// Rows fetched from the database so far: lets a test see that reading stays local.
  [[nodiscard]] std::int64_t rows_read() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace roomatlas
