// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <shigusa/edit.hpp>
#include <utility>

#include "commands.hpp"
#include "table.hpp"

namespace shigusa::app {
namespace {

namespace fs = std::filesystem;

// The folder that the result is in.
fs::path folder_of(const EditOptions& options) {
  const fs::path result = options.result;
  std::error_code ignored;
  const fs::path folder = fs::is_directory(result, ignored) ? result : result.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

// An edit never writes over what it started from.
Result<void> check_folder(const EditOptions& options) {
  std::error_code ignored;
  if (options.out.empty() || !fs::equivalent(options.out, folder_of(options), ignored)) return {};
  return fail(ErrorCode::invalid_argument,
              "is the result's own folder, which an edit never writes over; give another",
              "--out " + options.out);
}

// The folder that the edit goes to, made: the one that the user gives, or else a new "edit-1",
// "edit-2", … or "mirror-1", … beside the result, which no other program has.
Result<fs::path> make_folder(const EditOptions& options) {
  fs::path folder = options.out;
  for (int k = 1; options.out.empty(); ++k) {
    folder = folder_of(options) / fmt::format("{}-{}", options.mirror ? "mirror" : "edit", k);
    std::error_code error;
    if (fs::create_directory(folder, error)) break;
    if (error && error != std::errc::file_exists) {
      return fail(ErrorCode::io, "cannot make this folder: " + error.message(), folder.string());
    }
  }
  SHG_TRY(prepare_folder(folder));
  return folder;
}

// Finds the file of the result's person: the user's, or else the one that the result names, which
// may be gone. Returns its path.
Result<fs::path> attach_character(const EditOptions& options, StoredResult& stored) {
  CharacterSpec& person = stored.task.character;
  if (options.character) {
    const auto attached = attach_file(person, *options.character);
    return attached ? Result<fs::path>(*options.character) : tl::unexpected(attached.error());
  }
  if (!person.landmarks) return fs::path{};
  fs::path file;
  std::string why = "the result does not say where that is";
  if (!stored.character.empty()) {
    file = folder_of(options) / stored.character;
    const auto attached = attach_file(person, file);
    if (attached) return file;
    why = attached.error().to_string();
  }
  note(person.source,
       "without the file the motion leaves on the measured body's own skeleton, and not as " +
           format_words([](const FormatInfo& info) { return info.needs != NeededFile::none; },
                        "or") +
           ": give it by --character FILE (" + why + ")");
  return file;
}

// As the result was written, but for what cannot be without the person's file.
ExportSettings usual_settings(const StoredResult& stored, int candidate, const fs::path& file) {
  ExportSettings usual{.formats = {}, .rate = stored.rate, .character = file};
  const auto index = static_cast<std::size_t>(candidate) - 1;
  if (index < stored.files.size()) {
    for (const auto& [name, written] : stored.files[index]) {
      const auto format = parse_formats(name);
      if (!format || !check_formats(stored.task.character, *format)) continue;
      usual.formats.push_back(format->front());
    }
  }
  if (usual.formats.empty()) usual.formats = usual_formats(stored.task.character);
  return usual;
}

}  // namespace

Result<int> edit(const EditOptions& options) {
  SHG_TRY(parse_formats(options.files.formats.value_or("")));
  SHG_TRY(check_folder(options));
  SHG_TRY_ASSIGN(StoredResult stored, read_result(options.result, options.candidate));
  if (options.mirror) {
    SHG_TRY(mirror_result(stored));
  }
  SHG_TRY_ASSIGN(const Task task, make_task(stored.task, {}));
  SHG_TRY_ASSIGN(const fs::path file, attach_character(options, stored));
  SHG_TRY_ASSIGN(const ExportSettings settings,
                 export_settings(options.files, stored.task.character,
                                 usual_settings(stored, options.candidate, file)));
  const auto begin = std::chrono::steady_clock::now();
  const Result<GenerateResult> generation = [&]() -> Result<GenerateResult> {
    SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(task));
    return replay(player, stored, options.candidate, options.assignments);
  }();
  if (!generation) {
    const Error& error = generation.error();
    const auto& given = options.assignments;
    const bool by_call = std::find(given.begin(), given.end(), error.place) != given.end();
    const std::string place = error.place.empty() ? options.result : error.place;
    return fail(error.code, error.message, (by_call ? "--set " : "") + place);
  }
  RunInfo info = replay_info(options.mirror ? "mirror" : "edit", begin);
  SHG_TRY_ASSIGN(const fs::path folder, make_folder(options));
  Result<int> delivered = deliver({stored.task, task, *generation, std::move(info)},
                                  {.folder = folder, .settings = settings, .json = options.json});
  // a folder in which nothing could be written goes again
  std::error_code ignored;
  if (!delivered && options.out.empty()) fs::remove(folder, ignored);
  return delivered;
}

}  // namespace shigusa::app
