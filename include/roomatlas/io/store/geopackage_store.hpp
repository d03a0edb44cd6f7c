// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/checkpoint_sink.hpp"
#include "roomatlas/assembly/assembly_store.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace roomatlas {

/// A store that another release wrote, and that this one cannot read.
struct OtherVersion : InputError {
  using InputError::InputError;
};

/// The store: one GeoPackage per mission (docs/formats.md). While the online stage writes, each
/// ASR is one transaction in WAL mode; `finish` leaves `journal_mode=DELETE` and rewrites the file
/// with VACUUM INTO, so that its bytes depend on its content alone.
class GeoPackageStore : public CheckpointSink, public AssemblyStore {
 public:
  enum class Mode { create, update, read, read_as_mapped };

  /// `create` replaces what is there; `read_as_mapped` gives paths as an assembly begins with them,
  /// see `put(const Assembly&, ...)`. All but `create` throw InputError when the file is
  /// missing, no store of ours, or of another schema version (OtherVersion, naming both).
  GeoPackageStore(const std::filesystem::path& file, Mode mode);
  ~GeoPackageStore() override;

  [[nodiscard]] const std::filesystem::path& file() const;

  void put(const Asr& asr) override;
  void put(const TruePose& truth) override;
  void put(const Asr& asr, const std::string& checkpoint) override;

  /// Where the online stage was when it was stopped.
  struct Unfinished {
    AsrId last_asr = 0;      ///< that was whole
    std::string checkpoint;  ///< as it was put with it
    std::map<std::string, std::string> origin;
  };
  /// Nothing in a store that is finished or was assembled, or in which no room is whole. Throws
  /// InputError where the checkpoint's sum is wrong.
  [[nodiscard]] std::optional<Unfinished> unfinished() const;
  /// Says what the store will be made from and with; kept until it is finished or assembled.
  void put_origin(const std::map<std::string, std::string>& origin);
  /// Removes what came after the checkpoint, such as rooms of a run that was interrupted, and what
  /// the next run puts again: metadata and former rooms.
  void go_back_to_checkpoint();

  [[nodiscard]] std::vector<AsrId> ids() const override;
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override;
  [[nodiscard]] std::vector<TruePose> truth() const override;

  /// Run metadata: tool and schema version, configuration (TOML), SHA-256 of the input, mission
  /// counters. Keys are unique; writing one again replaces it.
  void put_metadata(const std::map<std::string, std::string>& values);
  [[nodiscard]] std::map<std::string, std::string> metadata() const;

  [[nodiscard]] StoredMission mission() const override;
  [[nodiscard]] std::vector<MemberMission> members() const override;
  /// Says which missions the ASRs are of; replaces what was said.
  void put_members(const std::vector<MemberMission>& members);

  /// Paths of readings that were matched again: `get` has these from then on where the store is
  /// open to be read, and no other, so that assembling again begins where it began before.
  void put(const Assembly& assembly, const std::string& configuration) override;
  [[nodiscard]] bool has_assembly() const override;
  [[nodiscard]] Correction correction() const override;
  [[nodiscard]] FloorPlan plan() const override;
  /// The plan with its walls as measured; `plan` where they were not made regular.
  [[nodiscard]] FloorPlan measured_plan() const;
  /// How far the assembly can be relied on; nothing where it was not judged.
  [[nodiscard]] std::optional<Judgement> judgement() const;
  [[nodiscard]] Placement other_answer() const override;
  /// The matches of rooms that were tried. Information is zero in a store of an earlier release.
  [[nodiscard]] std::vector<Closure> closures() const override;

  /// What the next assembly carries numbers and names over from: the plan's rooms and named ones
  /// that the plan has not; or those that were put, until an assembly.
  [[nodiscard]] std::vector<PlanRoom> former_rooms() const override;
  /// Rooms of a store that this one replaces, until an assembly has carried over their numbers and
  /// names; areas and polygons are kept with them.
  void put_former_rooms(const std::vector<PlanRoom>& rooms);

  /// Closes the store and makes its bytes reproducible.
  void finish();
  /// Whether it is as `finish` left it. A run that was killed before leaves a whole store whose
  /// bytes are not yet those of its content alone.
  [[nodiscard]] bool is_finished() const;

  /// Rows fetched from the database so far: lets a test see that reading stays local.
  [[nodiscard]] std::int64_t rows_read() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace roomatlas
