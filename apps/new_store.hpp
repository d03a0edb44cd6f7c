// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

namespace roomatlas::apps {

/// Where a store is made: at its place where nothing is there, else beside it in `FILE.new`, so
/// that what is there stays whole until the new one is finished, however the run ends. Links stay;
/// the new file has from its beginning the permissions of the one that it replaces.
class NewStore {
 public:
  /// @throws InputError when the place is a directory
  explicit NewStore(const std::filesystem::path& place);
  /// An unfinished one that is there already, at its place or beside it.
  NewStore(const std::filesystem::path& place, const std::filesystem::path& unfinished);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// The finished store takes its place. It must not be open any more.
  void put_in_place() const;
  /// After an interruption: takes the place of an unfinished store, and stays beside any other
  /// file. @returns where it is
  [[nodiscard]] std::filesystem::path keep_unfinished() const;
  /// After an error: removed, unless a run can go on with it; a warning says so then.
  void give_up() const;
  /// Removed: nothing can come of it.
  void remove() const;

 private:
  std::filesystem::path place_;
  std::filesystem::path file_;
};

/// Where a store is made that takes this place once it is finished.
[[nodiscard]] std::filesystem::path place_beside(const std::filesystem::path& place);

/// A copy of a finished store takes a place. What is there stays whole until then.
/// @param change the copy, before it takes the place
/// @throws InputError where it cannot be written
void put_copy_in_place(const std::filesystem::path& finished, const std::filesystem::path& named,
                       const std::function<void(const std::filesystem::path& copy)>& change);

/// Puts the store in its place that a run had finished beside it when it was stopped, and removes
/// one with which none can go on.
void settle_new_store(const std::filesystem::path& named);

/// Removes the temporary files of a run that was killed. The store must not be in use.
void remove_leftovers(const std::filesystem::path& named);

}  // namespace roomatlas::apps
