// SPDX-License-Identifier: MIT
#include "auditor.hpp"

#include <algorithm>
#include <ctime>
#include <mutex>
#include <shigusa/files.hpp>

namespace shigusa::bench {
namespace {

// Arm libraries of all threads, in memory.
LimbStore shared_store() {
  static std::mutex mutex;
  static std::map<std::string, std::string> files;
  return {.load = [](const std::string& name) -> std::optional<std::string> {
            const std::lock_guard lock(mutex);
            const auto found = files.find(name);
            if (found == files.end()) return std::nullopt;
            return found->second;
          },
          .save =
              [](const std::string& name, std::string_view bytes) {
                const std::lock_guard lock(mutex);
                files[name] = std::string(bytes);
              }};
}

// CPU time of this thread
double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool is_impossible(const Candidate& candidate) {
  return candidate.judgement.verdict == Verdict::impossible;
}

// Order of a candidate in a result apart from its score: possible motions first, and within each
// group, for the preset flat, those without collisions.
int rank_class(const Candidate& candidate, Preset preset) {
  const bool collides = candidate.measures.collides.depth > kCollisionDepth;
  return 2 * static_cast<int>(is_impossible(candidate)) +
         static_cast<int>(preset == Preset::flat && collides);
}

void judge_ranks(const GenerateResult& generation, Preset preset, Audit& audit) {
  const std::vector<Candidate>& all = generation.candidates;
  audit.require(!all.empty(), "there is no candidate");
  if (all.empty()) return;
  if (generation.meets_goals()) {
    const bool none = std::all_of(all.begin(), all.end(), is_impossible);
    audit.require((generation.status == ReachStatus::unsteady) == none,
                  "the status is unsteady, or not, against the verdicts");
    ++audit.best[std::string(word_of(all.front().judgement.verdict))];
  }
  for (std::size_t i = 1; i < all.size(); ++i) {
    const int before = rank_class(all[i - 1], preset);
    const int now = rank_class(all[i], preset);
    audit.require(before <= now, "a worse kind of candidate ranks above");
    if (before != now) continue;
    audit.require(all[i - 1].score.total <= all[i].score.total,
                  "candidates are not in their order");
  }
}

// The task's body on its standing foot, without loads.
Result<Task> standing(Task task) {
  const std::vector<Goal> goals = task.goals;
  for (Goal& goal : task.goals) goal.load = 0.0;
  SHG_TRY_ASSIGN(const PreparedTask on_feet, PreparedTask::of(task));
  Task result = on_feet.task();
  result.goals = goals;
  return result;
}

std::vector<std::string> nodes_of(const Candidate& candidate) {
  std::vector<std::string> nodes;
  for (const GoalResult& goal : candidate.goals) nodes.push_back(goal.node);
  for (const ContactResult& foot : candidate.contacts) {
    nodes.push_back(foot.node);
    if (const std::string knee = knee_of(foot.node); !knee.empty()) nodes.push_back(knee);
  }
  return nodes;
}

// Hands missing from the file: each moves with the file's link that carries it, from its reported
// start position.
void add_made_hands(Judged& judged) {
  const BodyModel& body = judged.task.body;
  const std::vector<Vec3d> start = start_places(judged.task);
  for (int e = 0; e < static_cast<int>(body.effectors().size()); ++e) {
    const Effector& hand = body.effector(e);
    if (judged.motion.has(hand.node)) continue;
    const std::string joint = file_joint(judged.task, hand.link);
    for (const RobotTree::Joint& above : judged.robot->joints()) {
      if (above.name != joint) continue;
      const Transformd& first = judged.motion.at(above.child, 0);
      const Vec3d in_link =
          transpose_times(first.rotation, start[static_cast<std::size_t>(e)] - first.translation);
      const std::size_t carrier = judged.motion.nodes.at(above.child);
      judged.motion.nodes[hand.node] = judged.motion.places.front().size();
      for (std::vector<Transformd>& frame : judged.motion.places) {
        frame.push_back({frame[carrier].rotation, frame[carrier] * in_link});
      }
    }
  }
}

// Reads the files; `second`: also the character's own glTF file, or MuJoCo's placements.
Result<void> read_files(Judged& judged, bool second) {
  const auto file = [&](FileFormat format) {
    return export_candidate(judged.character, judged.task, judged.candidate, format);
  };
  SHG_TRY_ASSIGN(const std::string csv, file(FileFormat::csv));
  judged.table = Table(csv);
  if (judged.robot != nullptr) {
    judged.links = judged.robot->places(judged.task.robot->root, judged.table);
    judged.motion = motion_of_robot(judged.links);
    if (judged.mujoco != nullptr && second) {
      judged.other_files.push_back(
          judged.mujoco->motion(judged.task.robot->root, judged.table, nodes_of(judged.candidate)));
    }
    add_made_hands(judged);
    return {};
  }
  SHG_TRY_ASSIGN(const std::string bvh, file(FileFormat::bvh));
  judged.motion = motion_of_bvh(bvh, judged.character, judged.task.body);
  const bool leaves = judged.character.rig && check_formats(judged.character, {FileFormat::glb});
  if (!second || !leaves) return {};
  SHG_TRY_ASSIGN(const std::string glb, file(FileFormat::glb));
  judged.other_files.push_back(motion_of_glb(glb, judged.character, nodes_of(judged.candidate)));
  return {};
}

}  // namespace

void Auditor::take(const Kind& kind, DrawnTask drawn) {
  const double begin = thread_seconds();
  drawn.file.evaluations = evaluations_;
  ++audit_.tasks;
  audit_.place =
      std::string(kind.name) + ", " + drawn.file.character.source + "\n" + format_task(drawn.file);
  Result<Task> task = make_task(drawn.file, {});
  if (!task) return audit_.require(false, task.error().to_string());
  task->batch.threads = 1;
  task->layers.store = shared_store();
  Result<GenerateResult> generation = generate(*task);
  if (!generation) {
    const bool may = kind.may_be_refused && generation.error().code == ErrorCode::invalid_argument;
    ++audit_.refused;
    return audit_.require(may, generation.error().to_string());
  }
  judge_all(drawn, *task, *std::move(generation));
  audit_.seconds += thread_seconds() - begin;
}

void Auditor::judge_all(const DrawnTask& drawn, const Task& task, GenerateResult generation) {
  ++audit_.statuses[std::string(word_of(generation.status))];
  if (flaw_ == Flaw::order_wrong) {
    std::reverse(generation.candidates.begin(), generation.candidates.end());
  }
  judge_ranks(generation, task.preset, audit_);
  const Result<Task> stands = standing(played_task(task, generation));
  if (!stands) return audit_.require(false, stands.error().to_string());
  bool first = true;
  for (Candidate& candidate : generation.candidates) {
    const RobotTree* robot =
        drawn.who != nullptr && drawn.who->robot ? &*drawn.who->robot : nullptr;
    judge_candidate({.character = drawn.file.character,
                     .robot = robot,
                     .mujoco = drawn.who != nullptr ? drawn.who->mujoco.get() : nullptr,
                     .task = *stands,
                     .meets_goals = generation.meets_goals(),
                     .candidate = std::move(candidate)},
                    first);
    first = false;
  }
}

void Auditor::judge_candidate(Judged judged, bool first) {
  ++audit_.candidates;
  ++audit_.verdicts[std::string(word_of(judged.candidate.judgement.verdict))];
  const Result<void> read = read_files(judged, first);
  if (!read) return audit_.require(false, read.error().to_string());
  spoil(flaw_, judged);
  audit_.require(judged.motion.finite(), "numbers are not finite");
  for (const auto& judge : {judge_goals, judge_feet, judge_limits, judge_boxes, judge_flesh,
                            judge_seat, judge_rests, judge_verdict, judge_masses}) {
    judge(judged, audit_);
  }
}

}  // namespace shigusa::bench
