// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "export_index.hpp"
#include "export_npy.hpp"
#include "export_poses.hpp"
#include "export_writer.hpp"

namespace shigusa {
namespace {

// Rotation vector: axis times angle (rad), 0 to π.
Vec3d axis_angle(const Quatd& turn) {
  const Quatd q = turn.w < 0.0 ? Quatd{-turn.x, -turn.y, -turn.z, -turn.w} : turn;
  const Vec3d v{q.x, q.y, q.z};
  const double sine = norm(v);
  // for small angles the sine is half the angle
  return (sine > 1e-12 ? 2.0 * atan2(sine, q.w) / sine : 2.0) * v;
}

void push(const Vec3d& v, std::vector<float>& into) {
  for (int k = 0; k < 3; ++k) into.push_back(static_cast<float>(v[k]));
}

// Goals of a motion's task.
void add_goals(const DataMotion& motion, npy::Arrays& arrays) {
  std::vector<std::string> effectors;
  std::vector<double> places;
  std::vector<double> loads;
  for (const Row& goal : motion.goals) {
    effectors.push_back(goal.text("effector"));
    const Vec3d place = goal.point("position_m");
    places.insert(places.end(), {place.x, place.y, place.z});
    loads.push_back(goal.number("load_kg"));
  }
  arrays.emplace_back("goal_effectors", npy::texts(effectors));
  arrays.emplace_back("goal_positions", npy::doubles(places, {effectors.size(), 3}));
  arrays.emplace_back("goal_loads", npy::doubles(loads, {effectors.size()}));
}

npy::Arrays arrays_of(const DataMotion& motion, const NodeMotion& nodes, double rate) {
  const std::size_t frames = nodes.frames();
  const std::size_t count = nodes.names.size();
  std::vector<float> poses;
  std::vector<float> places;
  std::vector<float> offsets;
  for (const Quatd& turn : nodes.turns) push(axis_angle(turn), poses);
  for (const Vec3d& place : nodes.root) push(place, places);
  for (const Vec3d& offset : nodes.offsets) push(offset, offsets);
  const std::vector<std::int32_t> parents(nodes.parents.begin(), nodes.parents.end());
  npy::Arrays arrays{
      {"poses", npy::floats(poses, {frames, 3 * count})},
      {"trans", npy::floats(places, {frames, 3})},
      {"gender", npy::text(motion.task.text("sex"))},
      // AMASS files use both spellings, and readers expect one of them
      {"mocap_framerate", npy::number(rate)},
      {"mocap_frame_rate", npy::number(rate)},
      {"joint_names", npy::texts(nodes.names)},
      {"parents", npy::integers(parents, {count})},
      {"offsets", npy::floats(offsets, {count, 3})},
      {"skeleton", npy::text("shigusa (not SMPL)")},
      {"up_axis", npy::text("y")},
      {"task", npy::whole(motion.number())},
      {"rank", npy::whole(motion.rank())},
      {"stature", npy::number(motion.task.number("stature_m"))},
      {"mass", npy::number(motion.task.number("mass_kg"))},
      {"duration", npy::number(motion.motion.number("duration_s"))},
      {"score", npy::number(motion.motion.number("score"))},
      {"verdict", npy::text(motion.motion.text("verdict"))},
      {"words", npy::text(motion.motion.text("words"))},
  };
  add_goals(motion, arrays);
  return arrays;
}

constexpr const char* kAboutNpz = R"(
Each file of `motions/` is a NumPy archive (`numpy.load`). The keys that AMASS has mean what they mean
there, on shigusa's own skeleton, which is not SMPL's:

| key | value |
|---|---|
| `poses` | frames × 3·nodes: how each node is turned in its parent, axis times angle (rad) |
| `trans` | frames × 3: where the first node, the hips, is in the world (m) |
| `gender` | `male` or `female` |
| `mocap_framerate`, `mocap_frame_rate` | frames a second, by both of AMASS's spellings |

There are no `betas` and no `dmpls`: the body is no shape of SMPL's. In their place stand

| key | value |
|---|---|
| `joint_names` | the nodes in the order of `poses`, by VRM's names |
| `parents` | of each node the parent's index, -1 of the first |
| `offsets` | nodes × 3: where each node is in its parent (m); turns of 0 are the body upright, arms hanging |
| `skeleton` | `shigusa (not SMPL)` |
| `up_axis` | `y`; the body faces z at the start, and its left is x. AMASS has z up |
| `stature`, `mass` | m, kg |
| `task`, `rank`, `duration`, `score`, `verdict`, `words` | of the motion |
| `goal_effectors`, `goal_positions`, `goal_loads` | what it reaches for, where (m, world), and what it holds (kg) |

A node is where its parent is, plus the parent's turn (with those above it) times its offset. The last
frame is the first that is not before the motion's end, and shows that end.
`index.csv` has a row a motion with all of its numbers.
)";

class NpzWriter : public DataWriter {
 public:
  explicit NpzWriter(const ExportJob& job) : job_(job), poses_(job.data.plan) {}

  [[nodiscard]] std::vector<DatasetSeries> series() const override {
    return poses_.series_for_turns();
  }
  Result<void> add(const DataMotion& motion) override {
    if (index_.motions() == 0) SHG_TRY(index_.begin(job_));
    SHG_TRY_ASSIGN(const NodeMotion nodes, poses_.turns(motion));
    SHG_TRY_ASSIGN(const std::string bytes,
                   npy::archive(arrays_of(motion, at_rate(nodes, job_.rate), job_.rate)));
    const std::string file = motion_file(motion, "npz");
    SHG_TRY(job_.folder.put(file, bytes));
    return index_.add(motion, file);
  }
  Result<void> finish() override {
    SHG_TRY(index_.finish());
    return job_.folder.put("README.md", about_export(job_, index_.motions()) + kAboutNpz);
  }

 private:
  const ExportJob& job_;
  Poses poses_;
  ExportIndex index_;
};

}  // namespace

template <>
Result<std::unique_ptr<DataWriter>> make_writer<DataFormat::npz>(const ExportJob& job) {
  return std::make_unique<NpzWriter>(job);
}

}  // namespace shigusa
