// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "export_index.hpp"
#include "export_poses.hpp"
#include "export_writer.hpp"

namespace shigusa {
namespace {

constexpr const char* kAboutGlb = R"(
Each file of `motions/` is the character's own file, or the mannequin of a built-in body, with one
animation, called as the motion is, in metres, y up, at {:g} frames a second. It moves to the goals of the data set's task, which are places in
the world, whatever its size{}.
{}
`index.csv` has a row a motion with all of its numbers in the data set. {}
)";
constexpr const char* kOwnNumbers = "They are those of these very motions.\n";
constexpr const char* kOtherNumbers =
    "Scores, verdicts, torques and postures there are those of the data set's own person, not of "
    "this "
    "character.\n";

// Motions of one task, generated for a character.
struct Made {
  std::uint64_t number = 0;
  DrawnAgain again;
  std::optional<MotionPlayer> player{};
  std::optional<GenerateResult> searched{};  // if it is not played
};

class GlbWriter : public DataWriter {
 public:
  GlbWriter(const ExportJob& job, std::optional<CharacterSpec> person)
      : job_(job), person_(std::move(person)) {}

  [[nodiscard]] std::vector<DatasetSeries> series() const override { return {}; }
  void count(DataExportRun& run) const override {
    run.searched = searched_;
    run.missed = missed_;
  }

  Result<void> add(const DataMotion& motion) override {
    SHG_TRY_ASSIGN(const std::string bytes, left_out(motion));
    if (index_.motions() == 0) SHG_TRY(index_.begin(job_));
    const std::string file = motion_file(motion, "glb");
    SHG_TRY(job_.folder.put(file, bytes));
    return index_.add(motion, file);
  }

  Result<void> finish() override {
    SHG_TRY(index_.finish());
    std::string made = "Motions are played from the data set's parameters.";
    if (searched_ > 0) {
      made = fmt::format(
          "{} of them were searched anew, by the same seed: pieces of work, and motions of a "
          "character that moves by other freedoms than the data set's person. The others are "
          "played from the data set's parameters.",
          searched_);
    }
    std::string text = about_export(job_, index_.motions());
    const std::string missed =
        missed_ > 0 ? fmt::format("; {} motions end as near as it can get", missed_) : "";
    text += fmt::format(fmt::runtime(kAboutGlb), job_.rate, missed, made,
                        person_ ? kOtherNumbers : kOwnNumbers);
    return job_.folder.put("README.md", text);
  }

 private:
  // GLB of a motion; ErrorCode::unsupported if it cannot be made for the character.
  Result<std::string> left_out(const DataMotion& motion) {
    Result<std::string> bytes = glb_of(motion);
    if (bytes || bytes.error().code == ErrorCode::io) return bytes;
    return fail(ErrorCode::unsupported, bytes.error().message, bytes.error().place);
  }

  Result<std::string> glb_of(const DataMotion& motion) {
    SHG_TRY_ASSIGN(const Candidate candidate, candidate_of(motion));
    const Made& made = *made_;
    return export_candidate(made.again.file.character, made.again.task, candidate, FileFormat::glb,
                            {.rate = job_.rate, .animation = motion.id()});
  }

  Result<Candidate> candidate_of(const DataMotion& motion) {
    SHG_TRY_ASSIGN(DrawnAgain again,
                   drawn_again(job_.data.plan, motion, person_ ? &*person_ : nullptr));
    SHG_TRY(check_formats(again.file.character, {FileFormat::glb}));
    if (!made_ || made_->number != motion.number()) {
      made_.emplace(Made{.number = motion.number(), .again = std::move(again)});
    } else {
      made_->again = std::move(again);
    }
    const Task& task = made_->again.task;
    // a data set has the parameters of a single motion
    if (!task.actions.empty() || !made_->again.misfit.empty()) return searched_candidate(motion);
    if (!made_->player) {
      SHG_TRY_ASSIGN(made_->player, MotionPlayer::of(task));
    }
    SHG_TRY_ASSIGN(GenerateResult result, made_->player->play(made_->again.parameters));
    if (!result.meets_goals()) ++missed_;
    return std::move(result.candidates.front());
  }

  Result<Candidate> searched_candidate(const DataMotion& motion) {
    if (!made_->searched) {
      const Task& task = made_->again.task;
      SHG_TRY_ASSIGN(made_->searched, task.actions.empty() ? generate(task) : perform(task));
    }
    const auto& all = made_->searched->candidates;
    if (motion.rank() > all.size()) {
      return fail(ErrorCode::unsupported,
                  fmt::format("a search for this character found {} motions, not {}", all.size(),
                              motion.rank()));
    }
    ++searched_;
    if (!made_->searched->meets_goals()) ++missed_;
    return all[motion.rank() - 1];
  }

  const ExportJob& job_;
  std::optional<CharacterSpec> person_;
  std::optional<Made> made_;
  ExportIndex index_;
  std::uint64_t searched_ = 0;
  std::uint64_t missed_ = 0;
};

bool can_be_glb(const FormatInfo& info) {
  return info.person && is_file(info.format, NeededFile::gltf);
}

// Fails if no task of the plan has a character whose file can be exported.
Result<void> check_own(const DatasetPlan& plan) {
  const bool built_in = plan.character_files().empty();
  if (built_in && has_mannequin()) return {};
  for (const std::string& file : plan.character_files()) {
    const auto format = format_of_file(file);
    if (format && can_be_glb(info_of(*format))) return {};
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("the data set's own bodies have no file to leave in: give a character's "
                          "file ({})",
                          format_endings(can_be_glb)),
              "--character");
}

}  // namespace

template <>
Result<std::unique_ptr<DataWriter>> make_writer<DataFormat::glb>(const ExportJob& job) {
  std::optional<CharacterSpec> person;
  if (job.settings.character.empty()) {
    SHG_TRY(check_own(job.data.plan));
  } else {
    CharacterSpec spec;
    spec.source = job.settings.character.string();
    SHG_TRY(check_source(spec));
    SHG_TRY(measure_character(spec, {}));
    SHG_TRY(check_formats(spec, {FileFormat::glb}));
    person = std::move(spec);
  }
  return std::make_unique<GlbWriter>(job, std::move(person));
}

}  // namespace shigusa
