// SPDX-License-Identifier: MIT
#include "export_glb.hpp"

#include <fmt/format.h>

namespace shigusa {
namespace {

constexpr const char* kAboutGlb = R"(
Each file of `motions/` is the character's own file, or the mannequin of a built-in body, with one
animation, called as the motion is, in metres, y up, at {:g} frames a second. It moves to the goals of
the data set's task, which are places in the world, whatever its size{}.
{}

The numbers of each motion are in the data set, by task and rank. {}
)";
constexpr const char* kOwnNumbers = "They are those of these very motions.";
constexpr const char* kOtherNumbers =
    "Scores, verdicts, torques and postures there are those of the data set's own person, not of "
    "this character.";

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

Result<GlbWriter> GlbWriter::of(const DatasetPlan& plan, const DataExportSettings& settings) {
  GlbWriter writer(plan, settings.rate);
  if (settings.character.empty()) {
    SHG_TRY(check_own(plan));
    return writer;
  }
  CharacterSpec spec;
  spec.source = settings.character.string();
  SHG_TRY(check_source(spec));
  SHG_TRY(measure_character(spec, {}));
  SHG_TRY(check_formats(spec, {FileFormat::glb}));
  writer.person_ = std::move(spec);
  return writer;
}

std::string GlbWriter::about() const {
  std::string made = "Motions are played from the data set's parameters.";
  if (searched_ > 0) {
    made = fmt::format(
        "{} of them were searched anew, by the same seed: pieces of work, and motions of a "
        "character that moves by other freedoms than the data set's person. The others are "
        "played from the data set's parameters.",
        searched_);
  }
  const std::string missed =
      missed_ > 0 ? fmt::format("; {} motions end as near as it can get", missed_) : "";
  return fmt::format(fmt::runtime(kAboutGlb), rate_, missed, made,
                     person_ ? kOtherNumbers : kOwnNumbers);
}

Result<std::string> GlbWriter::file_of(const DataMotion& motion) {
  Result<std::string> bytes = glb_of(motion);
  if (bytes || bytes.error().code == ErrorCode::io) return bytes;
  return fail(ErrorCode::unsupported, bytes.error().message, bytes.error().place);
}

Result<std::string> GlbWriter::glb_of(const DataMotion& motion) {
  SHG_TRY_ASSIGN(const Candidate candidate, candidate_of(motion));
  const DrawnAgain& again = made_->again;
  return export_candidate(again.file.character, again.task, candidate, FileFormat::glb,
                          {.rate = rate_, .animation = motion.id()});
}

Result<Candidate> GlbWriter::candidate_of(const DataMotion& motion) {
  SHG_TRY_ASSIGN(DrawnAgain again, drawn_again(*plan_, motion, person_ ? &*person_ : nullptr));
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

Result<Candidate> GlbWriter::searched_candidate(const DataMotion& motion) {
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

}  // namespace shigusa
