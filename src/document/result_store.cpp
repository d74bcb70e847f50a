// SPDX-License-Identifier: MIT
// Results in folders, for programs with a file system; the page does without.
#include <algorithm>
#include <cerrno>
#include <shigusa/files.hpp>
#include <shigusa/run.hpp>

#include "core/index.hpp"
#include "export_file.hpp"
#include "files/file.hpp"
#include "result_folder.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;

// Path of the character's file relative to the folder; empty if there is none.
std::string from_folder(const fs::path& character, const fs::path& folder) {
  if (character.empty()) return {};
  std::error_code error;
  const fs::path path = fs::relative(character, folder, error);
  if (error) return {};
  // empty from one disk of Windows to another
  return (path.empty() ? fs::absolute(character, error) : path).generic_string();
}

FileSettings file_settings(const ExportSettings& settings) {
  return {settings.rate,     settings.clip,           settings.names,
          settings.in_place, settings.only_this_clip, settings.from_svg};
}

// Makes the files of one format, for as many candidates at once as there are threads, which bounds
// the memory held.
class FilesMade {
 public:
  FilesMade(const FinishedRun& run, FileFormat format, const ExportSettings& settings)
      : run_(run), format_(format), settings_(settings) {}

  // The file of a candidate; candidates are requested in order.
  Result<MadeFile> file(std::size_t candidate) {
    const std::size_t block = index(thread_count(run_.task.batch.threads));
    if (candidate % block == 0) make(candidate, block);
    return std::move(made_[candidate % block]);
  }

 private:
  void make(std::size_t first, std::size_t block) {
    const std::vector<Candidate>& candidates = run_.generation.candidates;
    made_.resize(std::min(block, candidates.size() - first));
    parallel_for(static_cast<int>(made_.size()), run_.task.batch.threads, [&](int number, int) {
      const std::size_t i = first + index(number);
      const CharacterSpec& character = run_.file.character;
      FileSettings settings = file_settings(settings_);
      settings.animation = settings_.clip.empty() ? candidate_animation(character, i + 1)
                                                  : free_animation(character, settings_.clip);
      const MotionCost* cost = run_.costs.empty() ? nullptr : &run_.costs[i];
      made_[index(number)] =
          make_file({character, run_.task, candidates[i], settings, cost}, format_);
    });
  }

  const FinishedRun& run_;
  FileFormat format_;
  const ExportSettings& settings_;
  std::vector<Result<MadeFile>> made_;
};

// Takes a file that was made; returns false, with a note, if the motion cannot be exported.
template <class Made>
Result<bool> take(Result<Made> file, Made& made, ResultFiles& files) {
  if (file) {
    made = std::move(*file);
    return true;
  }
  if (file.error().code != ErrorCode::unsupported) return tl::unexpected(file.error());
  Message why = file.error().to_message();
  // the reason is mostly the same for all candidates
  const bool told = !files.notes.empty() && files.notes.back().text == why.text;
  if (!told) files.notes.push_back(std::move(why));
  return false;
}

void note_off(const std::string& name, const std::optional<ReadBack>& back, ResultFiles& files) {
  if (!back || back->off.empty()) return;
  files.notes.push_back(Error{ErrorCode::unsupported, back->off, name}.to_message());
}

// Adds the files of one format to the folder, and lists them in `files`.
Result<void> add_files(const FinishedRun& run, FileFormat format, const ExportSettings& settings,
                       ResultFolder& folder, ResultFiles& files) {
  FilesMade all(run, format, settings);
  for (std::size_t i = 0; i < run.generation.candidates.size(); ++i) {
    MadeFile made;
    SHG_TRY_ASSIGN(const bool leaves, take(all.file(i), made, files));
    if (!leaves) continue;
    const std::string name = candidate_file(i + 1, format);
    note_off(name, made.back, files);
    SHG_TRY_ASSIGN(std::string sha256, folder.add(name, made.bytes));
    files.candidates[i][std::string(word_of(format))] = {name, std::move(sha256), made.back};
  }
  return {};
}

Result<void> add_one_glb(const FinishedRun& run, const ExportSettings& settings,
                         ResultFolder& folder, ResultFiles& files) {
  MadeGlb made;
  SHG_TRY_ASSIGN(const bool leaves,
                 take(make_one_glb(run.file.character, run.task, run.generation.candidates,
                                   file_settings(settings)),
                      made, files));
  if (!leaves) return {};
  SHG_TRY_ASSIGN(const std::string sha256, folder.add(kOneFile, made.bytes));
  for (std::size_t i = 0; i < made.back.size(); ++i) {
    files.candidates[i][std::string(word_of(FileFormat::glb))] = {kOneFile, sha256, made.back[i]};
    note_off(kOneFile, made.back[i], files);
  }
  return {};
}

}  // namespace

Result<void> prepare_folder(const fs::path& folder) {
  if (folder.empty()) {
    return fail(ErrorCode::invalid_argument, "the folder for the result has an empty name");
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error)) {
    return fail(ErrorCode::io,
                "cannot make this folder: " +
                    (error ? error.default_error_condition().message() : "it is a file"),
                folder.string());
  }
  // opening creates a folder within, and removes it
  return ResultFolder().open(folder);
}

Result<WrittenResult> write_result(const fs::path& folder, const FinishedRun& run,
                                   const ExportSettings& settings) {
  SHG_TRY(check_formats(run.file.character, settings.formats));
  ResultFolder out;
  SHG_TRY(out.open(folder));
  const std::size_t count = run.generation.candidates.size();
  ResultFiles files{settings.rate.value_or(kUsualRate),
                    std::vector<CandidateFiles>(count),
                    from_folder(settings.character, folder),
                    {}};
  for (const FileFormat format : settings.formats) {
    if (count > 0 && files.candidates[0].contains(std::string(word_of(format)))) continue;
    const bool one = settings.one_file && format == FileFormat::glb;
    SHG_TRY(one ? add_one_glb(run, settings, out, files)
                : add_files(run, format, settings, out, files));
  }
  const auto has_none = [](const CandidateFiles& each) { return each.empty(); };
  if (!files.notes.empty() &&
      std::all_of(files.candidates.begin(), files.candidates.end(), has_none)) {
    return tl::unexpected(Error{ErrorCode::unsupported, files.notes.front(), {}});
  }
  std::string summary = format_result(run, files);
  SHG_TRY(out.publish(summary));
  return WrittenResult{std::move(summary), std::move(files.notes)};
}

Result<StoredResult> read_result(const fs::path& path, int candidate) {
  std::error_code ignored;
  const bool whole = fs::is_directory(path, ignored);
  const fs::path above = whole ? path : path.parent_path();
  const fs::path place = above.empty() ? fs::path(".") : above;
  const Descriptor folder = open_folder(place);
  if (!folder) return refused(path, "open", errno);
  SHG_TRY(lock_folder(folder, LockKind::shared, place));
  const fs::path summary = whole ? path / kSummaryName : path;
  SHG_TRY_ASSIGN(const std::string text, read_text_file(summary, kResultMaxBytes));
  Result<StoredResult> stored = parse_result(text, summary.string());
  const auto index = static_cast<std::size_t>(candidate) - 1;
  if (!stored || index >= stored->files.size()) return stored;
  SHG_TRY(check_described(place, folder, stored->files[index]));
  return stored;
}

}  // namespace shigusa
