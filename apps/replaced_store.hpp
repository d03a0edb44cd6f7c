// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace roomatlas::apps {

/// What SQLite keeps beside a file; it would be taken for the next store's.
void remove_side_files(const std::filesystem::path& store);

/// Puts a finished store in the place of what is there, with that file's permissions. What is there
/// stays beside it as `NAME.former.gpkg` (`NAME.former-2.gpkg`, ...) where it holds what people
/// made and the new one has not: names of rooms and corrections of another building, or said since
/// the new one took them over; tables, columns and styles of other programs; or where it cannot be
/// read. A warning names all of it.
/// @throws InputError where it cannot be replaced, or another program has it open: it stays as it
/// is
void replace_store(const std::filesystem::path& named, const std::filesystem::path& by);

}  // namespace roomatlas::apps
