// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <shigusa/dataset_export.hpp>
#include <sstream>

#include "core/parse_number.hpp"
#include "dataset/export_caption.hpp"
#include "dataset/export_poses.hpp"
#include "dataset/plans.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// A data set in its own folder, and a folder for exports.
struct MadeSet {
  WorkFolder data;
  WorkFolder out;
  DatasetPlan plan;

  explicit MadeSet(const Json& json, const std::filesystem::path& characters = {})
      : plan(plan_of_json(json, characters)) {
    EXPECT_TRUE(keep_plan(plan, data.path()));
    made(plan, {.folder = data.path()});
  }
  [[nodiscard]] DataExportSettings settings(DataFormat format) const {
    return {.from = data.path(), .to = out.path(), .format = format};
  }
};

Json plan_with(std::vector<std::string> series, const char* character = "half_body") {
  Json json = small_plan(4, 2);
  json["series"] = series;
  json["motions"] = "all";
  json["task"]["character"]["source"] = character;
  return json;
}

DataExportRun exported(const DataExportSettings& settings) {
  const auto run = export_dataset(settings);
  EXPECT_TRUE(run) << run.error().to_string();
  return run.value_or(DataExportRun{});
}

std::string refusal(const DataExportSettings& settings) {
  const auto run = export_dataset(settings);
  return run ? "" : run.error().to_string();
}

// An array of a .npy file of 32-bit floats.
struct Floats {
  std::vector<std::size_t> shape;
  std::vector<float> values;
};

Floats floats_of(const std::string& file) {
  EXPECT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const auto size =
      static_cast<unsigned char>(file[8]) + 256U * static_cast<unsigned char>(file[9]);
  const std::string header = file.substr(10, size);
  EXPECT_EQ((10 + size) % 64, 0u);
  EXPECT_EQ(header.back(), '\n');
  EXPECT_THAT(header, HasSubstr("'descr': '<f4', 'fortran_order': False"));
  Floats array;
  std::istringstream sides(header.substr(header.find("'shape': (") + 10));
  for (std::size_t side = 0; sides >> side;) {
    array.shape.push_back(side);
    sides.ignore(1);
  }
  array.values.resize((file.size() - 10 - size) / 4);
  std::memcpy(array.values.data(), file.data() + 10 + size, 4 * array.values.size());
  return array;
}

// The files of a .zip without compression, by the headers before each.
std::map<std::string, std::string> unzipped(const std::string& zip) {
  const auto number = [&zip](std::size_t at, int bytes) {
    std::size_t value = 0;
    for (int k = bytes; k-- > 0;) {
      value = value << 8 | static_cast<unsigned char>(zip[at + static_cast<std::size_t>(k)]);
    }
    return value;
  };
  std::map<std::string, std::string> files;
  for (std::size_t at = 0; zip.compare(at, 4, "PK\x03\x04") == 0;) {
    EXPECT_EQ(number(at + 8, 2), 0u) << "packed";
    const std::size_t size = number(at + 18, 4);
    const std::size_t name = number(at + 26, 2);
    const std::size_t begin = at + 30 + name + number(at + 28, 2);
    files[zip.substr(at + 30, name)] = zip.substr(begin, size);
    at = begin + size;
  }
  return files;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

// The fields of a line of CSV.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

// The rotation by a rotation vector, by Rodrigues' formula.
Vec3d turned(const Vec3d& turn, const Vec3d& v) {
  const double angle = norm(turn);
  if (angle == 0.0) return v;
  const Vec3d axis = (1.0 / angle) * turn;
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) +
         (1.0 - std::cos(angle)) * dot(axis, v) * axis;
}

TEST(Export, NpzHoldsTheMotionOnItsOwnSkeleton) {
  const MadeSet set(plan_with({"nodes", "positions"}));
  const DataExportRun run = exported(set.settings(DataFormat::npz));
  const DataFolder data = DataFolder::open(set.data.path()).value();
  const ShardRows rows = read_rows(data, 0, {DatasetSeries::positions}).value();
  ASSERT_FALSE(rows.motions.empty());
  EXPECT_GE(run.motions, rows.motions.size());
  for (const DataMotion& motion : rows.motions) {
    const auto files = unzipped(set.out.get("motions/0000/" + motion.id() + ".npz"));
    const Floats poses = floats_of(files.at("poses.npy"));
    const Floats root = floats_of(files.at("trans.npy"));
    const Floats offsets = floats_of(files.at("offsets.npy"));
    const NodePlaces places = Poses(set.plan).places(motion).value();
    const std::size_t nodes = places.names.size();
    const auto frames =
        static_cast<std::size_t>(frames_at(motion.motion.number("duration_s"), 60.0));
    ASSERT_EQ(poses.shape, (std::vector<std::size_t>{frames, 3 * nodes}));
    EXPECT_EQ(files.count("betas.npy"), 0u);
    // node by node: of a chain of turns, the farthest node sums up the chain
    const auto triple = [](const Floats& array, std::size_t at) {
      return Vec3d{array.values[at], array.values[at + 1], array.values[at + 2]};
    };
    for (std::size_t n = 0; n < nodes; ++n) {
      Vec3d place{};
      for (int up = static_cast<int>(n); places.parents[static_cast<std::size_t>(up)] >= 0;
           up = places.parents[static_cast<std::size_t>(up)]) {
        const auto node = static_cast<std::size_t>(up);
        const auto parent = static_cast<std::size_t>(places.parents[node]);
        place = turned(triple(poses, 3 * ((frames - 1) * nodes + parent)),
                       triple(offsets, 3 * node) + place);
      }
      place = place + triple(root, 3 * (frames - 1));
      // single precision along a chain of ten
      EXPECT_LT(norm(place - places.at(places.frames() - 1, static_cast<int>(n))), 1e-5)
          << places.names[n];
    }
  }
}

TEST(Export, SameDataSameBytes) {
  const MadeSet set(plan_with({"nodes", "positions"}));
  for (const DataFormat format : {DataFormat::npz, DataFormat::csv}) {
    const WorkFolder one;
    const WorkFolder other;
    DataExportSettings settings = set.settings(format);
    settings.to = one.path();
    exported(settings);
    settings.to = other.path();
    exported(settings);
    EXPECT_TRUE(one.contents() == other.contents());
  }
}

TEST(Export, MotionsWhoseSeriesAreNotKeptAreMadeAgainTheSame) {
  const MadeSet kept(plan_with({"nodes"}));
  const MadeSet bare(plan_with({}));
  const MadeSet angles(plan_with({"angles"}));
  exported(kept.settings(DataFormat::npz));
  exported(bare.settings(DataFormat::npz));
  exported(angles.settings(DataFormat::npz));
  int motions = 0;
  for (const auto& [name, bytes] : kept.out.contents()) {
    if (!name.ends_with(".npz")) continue;
    ++motions;
    EXPECT_EQ(bytes, bare.out.get(name)) << name;
    const auto poses = floats_of(unzipped(bytes).at("poses.npy"));
    const auto from_angles = floats_of(unzipped(angles.out.get(name)).at("poses.npy"));
    ASSERT_EQ(poses.values.size(), from_angles.values.size());
    for (std::size_t k = 0; k < poses.values.size(); ++k) {
      // angles are kept in single precision
      ASSERT_NEAR(poses.values[k], from_angles.values[k], 2e-6) << name;
    }
  }
  EXPECT_GT(motions, 3);
}

TEST(Export, HumanMl3dHoldsTheLastPoseWhereThatIsAskedFor) {
  const MadeSet set(plan_with({"positions"}, "human"));
  DataExportSettings settings = set.settings(DataFormat::humanml3d);
  exported(settings);
  EXPECT_THAT(set.out.get("README.md"), HasSubstr("leave out motions of fewer than 40 frames"));
  EXPECT_THAT(set.out.get("README.md"), HasSubstr("With `--least-frames 40`"));
  const DataFolder data = DataFolder::open(set.data.path()).value();
  for (const std::size_t least : {std::size_t{40}, std::size_t{57}}) {
    settings.least_frames = least;
    settings.force = true;
    exported(settings);
    EXPECT_THAT(set.out.get("README.md"), HasSubstr("up to " + std::to_string(least) + " frames"));
    EXPECT_THAT(set.out.get("README.md"), HasSubstr("which is 0 of these"));
    const ShardRows rows = read_rows(data, 0, {}).value();
    for (const DataMotion& motion : rows.motions) {
      const Floats joints = floats_of(set.out.get("new_joints/" + motion.id() + ".npy"));
      const auto frames =
          static_cast<std::size_t>(frames_at(motion.motion.number("duration_s"), 20.0));
      ASSERT_EQ(joints.shape[0], std::max(frames, least));
      for (std::size_t k = 0; k < 66; ++k) {
        EXPECT_EQ(joints.values[(joints.shape[0] - 1) * 66 + k],
                  joints.values[(frames - 1) * 66 + k]);
      }
    }
  }
}

TEST(Export, HumanMl3dHasItsJointsFramesAndSentences) {
  const MadeSet set(plan_with({"positions"}, "human"));
  const DataExportRun run = exported(set.settings(DataFormat::humanml3d));
  const DataFolder data = DataFolder::open(set.data.path()).value();
  const ShardRows rows = read_rows(data, 0, {}).value();
  enum { pelvis = 0, left_knee = 4, left_foot = 10, right_foot = 11, head = 15 };
  for (const DataMotion& motion : rows.motions) {
    const Floats joints = floats_of(set.out.get("new_joints/" + motion.id() + ".npy"));
    const auto frames =
        static_cast<std::size_t>(frames_at(motion.motion.number("duration_s"), 20.0));
    ASSERT_EQ(joints.shape, (std::vector<std::size_t>{frames, 22, 3}));
    const auto height = [&](std::size_t frame, std::size_t joint) {
      return static_cast<double>(joints.values[(frame * 22 + joint) * 3 + 1]);
    };
    EXPECT_GT(height(0, head), height(0, pelvis) + 0.5);
    EXPECT_GT(height(0, pelvis), height(0, left_knee) + 0.3);
    EXPECT_GT(height(0, left_knee), height(0, left_foot) + 0.3);
    // where toes bend is two centimetres above the sole
    for (std::size_t f = 0; f < frames; ++f) {
      EXPECT_NEAR(height(f, left_foot), 0.0, 0.025);
      EXPECT_NEAR(height(f, right_foot), 0.0, 0.025);
    }
    const std::string text = set.out.get("texts/" + motion.id() + ".txt");
    EXPECT_THAT(text, testing::StartsWith("a person "));
    EXPECT_THAT(text, HasSubstr("#a/DET person/NOUN "));
    EXPECT_THAT(text, testing::EndsWith("#0.0#0.0\n"));
  }
  std::set<std::string> named;
  for (const char* part : {"train.txt", "val.txt", "test.txt"}) {
    for (const std::string& id : lines_of(set.out.get(part))) EXPECT_TRUE(named.insert(id).second);
  }
  EXPECT_EQ(named.size(), run.motions);
}

TEST(Export, HumanMl3dNeedsTwoArmsAndLegs) {
  const MadeSet set(plan_with({"positions"}));
  EXPECT_THAT(refusal(set.settings(DataFormat::humanml3d)),
              HasSubstr("no motion can leave as humanml3d: motion 000000-1: the body has no node"));
}

struct Aim {
  const char* effector;
  Vec3d at;
  double load;
};
// A motion of a person of 1.7 m who squats and reaches for these goals.
std::string caption_for(const std::vector<Aim>& aims, double error = 0.0) {
  const auto text = [](const char* name) {
    return Column{.name = name, .type = ElementType::text, .text_size = 16};
  };
  Table motions{"/motions", {{"stoop_squat_index"}, {"error_m"}}};
  motions["stoop_squat_index"].push(10.0);
  motions["error_m"].push(error);
  Table tasks{"/tasks", {{"stature_m"}}};
  tasks["stature_m"].push(1.7);
  Table goals{"/goals", {text("effector"), {.name = "position_m", .shape = {3}}, {"load_kg"}}};
  DataMotion motion{{&motions, 0}, {&tasks, 0}, {}, {}};
  for (const Aim& aim : aims) {
    motion.goals.push_back({&goals, motion.goals.size()});
    goals["effector"].push(std::string_view(aim.effector));
    goals["position_m"].push(aim.at);
    goals["load_kg"].push(aim.load);
  }
  return caption_of(motion);
}

TEST(Export, CaptionsTellOfHandsThatAreNearEachOtherAsOne) {
  EXPECT_EQ(caption_for({{"right_hand", {-0.27, 0.6, 0.5}, 2}, {"left_hand", {0.27, 0.8, 0.5}, 3}}),
            "a person squats and reaches down in front with both hands, holding 5 kg");
  EXPECT_EQ(caption_for({{"right_hand", {-0.4, 1.7, 0.5}, 2}, {"left_hand", {0.4, 0.1, -0.5}, 0}}),
            "a person squats, reaches up in front to the right with the right hand, holding 2 kg "
            "and reaches down to the floor behind to the left with the left hand");
  EXPECT_EQ(caption_for({{"left_foot", {0.2, 0.1, 0}, 0}, {"right_hand", {0, 1.2, 0.1}, 0}}, 0.02),
            "a person squats, moves the left foot down to the floor to the left and reaches out "
            "with the right hand");
}

TEST(Export, TokensArePlainFormsOfKnownWords) {
  EXPECT_EQ(tokens_of("a person squats, turns left and reaches up with both hands, holding 5 kg"),
            "a/DET person/NOUN squat/VERB turn/VERB left/ADJ and/CCONJ reach/VERB up/ADV with/ADP "
            "both/DET hand/NOUN hold/VERB kg/NOUN");
}

TEST(Export, CsvHasARowAMotionWithItsNumbers) {
  const MadeSet set(plan_with({"angles", "contacts"}));
  DataExportSettings settings = set.settings(DataFormat::csv);
  settings.series = true;
  const DataExportRun run = exported(settings);
  const std::vector<std::string> lines = lines_of(set.out.get("index.csv"));
  ASSERT_EQ(lines.size(), run.motions + 1);
  const std::vector<std::string> names = fields_of(lines[0]);
  const auto place = [&names](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    EXPECT_NE(found, names.end()) << name;
    return static_cast<std::size_t>(found - names.begin());
  };
  const DataFolder data = DataFolder::open(set.data.path()).value();
  std::size_t line = 1;
  for (const std::uint64_t shard : data.shards) {
    const ShardRows rows = read_rows(data, shard, {}).value();
    for (const DataMotion& motion : rows.motions) {
      const std::vector<std::string> fields = fields_of(lines[line++]);
      ASSERT_EQ(fields.size(), names.size());
      EXPECT_EQ(fields[place("motion")], motion.id());
      EXPECT_EQ(parse_number(fields[place("score")]), motion.motion.number("score"));
      EXPECT_EQ(fields[place("words")], motion.motion.text("words"));
      EXPECT_EQ(fields[place("verdict")], motion.motion.text("verdict"));
      EXPECT_EQ(parse_number(fields[place("goal1.position_m.y")]),
                motion.goals[0].number("position_m", 1));
      const std::vector<std::string>& parameters = *motion.motion.table->names_of("parameters");
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        const double value = motion.motion.number("parameters", k);
        const std::string& field = fields[place("parameters." + parameters[k])];
        EXPECT_EQ(parse_number(field), is_finite(value) ? std::optional(value) : std::nullopt);
      }
      const std::vector<std::string> frames = lines_of(set.out.get(fields[place("file")]));
      ASSERT_EQ(frames.size(), 62u);
      const std::size_t columns = fields_of(frames[0]).size();
      for (const std::string& frame : frames) EXPECT_EQ(fields_of(frame).size(), columns);
    }
  }
}

TEST(Export, LimitsPickMotions) {
  const MadeSet set(plan_with({}));
  const std::uint64_t all = exported(set.settings(DataFormat::csv)).motions;
  std::uint64_t parts = 0;
  for (const char* part : {"train", "validation", "test"}) {
    const WorkFolder out;
    DataExportSettings settings = set.settings(DataFormat::csv);
    settings.to = out.path();
    settings.split = part;
    const auto run = export_dataset(settings);
    parts += run ? run->motions : 0;
  }
  EXPECT_EQ(parts, all);
  const WorkFolder out;
  DataExportSettings settings = set.settings(DataFormat::csv);
  settings.to = out.path();
  settings.tasks = TaskRange{1, 3};
  settings.most = 2;
  EXPECT_EQ(exported(settings).motions, 2u);
  for (const std::string& line : lines_of(out.get("index.csv"))) {
    if (line.starts_with("motion,")) continue;
    EXPECT_THAT(line,
                testing::AnyOf(testing::StartsWith("000001-"), testing::StartsWith("000002-")));
  }
}

TEST(Export, RefusesWhatIsNotAllowed) {
  const MadeSet set(plan_with({}));
  DataExportSettings settings = set.settings(DataFormat::csv);
  settings.split = "tests";
  EXPECT_THAT(refusal(settings), HasSubstr("allowed are train, validation and test"));
  settings = set.settings(DataFormat::csv);
  settings.tasks = TaskRange{2, 9};
  EXPECT_THAT(refusal(settings), HasSubstr("the plan has 4 tasks"));
  settings = set.settings(DataFormat::humanml3d);
  settings.rate = 30.0;
  EXPECT_THAT(refusal(settings), HasSubstr("at 20 frames a second alone"));
  EXPECT_TRUE(set.out.contents().empty());
  settings = set.settings(DataFormat::csv);
  set.out.put("mine.txt", "of another program");
  EXPECT_THAT(refusal(settings), HasSubstr("is not empty"));
  settings.force = true;
  exported(settings);
  EXPECT_EQ(set.out.get("mine.txt"), "of another program");
}

TEST(Export, GlbOfBuiltInBodiesIsTheMannequin) {
  const MadeSet set(plan_with({}));
  const DataExportSettings settings = set.settings(DataFormat::glb);
  if (!has_mannequin()) {
    EXPECT_THAT(refusal(settings), HasSubstr("give a character's file"));
    return;
  }
  const DataExportRun run = exported(settings);
  EXPECT_EQ(run.left_out, 0u) << run.why;
  std::uint64_t files = 0;
  for (const auto& [name, bytes] : set.out.contents()) {
    if (!name.ends_with(".glb")) continue;
    ++files;
    EXPECT_TRUE(set.out.get(name).starts_with("glTF")) << name;
  }
  EXPECT_EQ(files, run.motions);
  EXPECT_GT(files, 0u);
}

TEST(Export, GlbMovesAnyCharacterByTheSameParameters) {
  const std::filesystem::path characters = std::filesystem::path(SHIGUSA_SHARED_DIR) / "characters";
  const std::filesystem::path file = characters / "lab0_CesiumMan.glb";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  Json json = plan_with({"nodes"});
  json["task"]["character"] = {{"source", file.filename().string()}};
  json["tasks"] = 2;
  const MadeSet set(json, characters);
  DataExportSettings settings = set.settings(DataFormat::glb);
  const DataExportRun own = exported(settings);
  EXPECT_EQ(own.left_out, 0u) << own.why;
  const WorkFolder out;
  settings.to = out.path();
  settings.character = file;
  const DataExportRun given = exported(settings);
  EXPECT_EQ(given.motions, own.motions);
  EXPECT_EQ(given.searched, 0u);
  int files = 0;
  for (const auto& [name, bytes] : set.out.contents()) {
    if (!name.ends_with(".glb")) continue;
    ++files;
    EXPECT_EQ(set.out.get(name).substr(0, 4), "glTF");
    EXPECT_TRUE(set.out.get(name) == out.get(name)) << name;
  }
  EXPECT_EQ(static_cast<std::uint64_t>(files), own.motions);
  // the parameters that are played give the very motion that the data set has
  const DataFolder data = DataFolder::open(set.data.path()).value();
  const ShardRows rows = read_rows(data, 0, {DatasetSeries::nodes}).value();
  for (const DataMotion& motion : rows.motions) {
    const DrawnAgain again = drawn_again(set.plan, motion).value();
    ASSERT_EQ(again.misfit, "");
    const Candidate candidate = regenerate(again.task, again.parameters).value().candidates.front();
    EXPECT_EQ(candidate.score.total, motion.motion.number("score"));
  }
}

}  // namespace
}  // namespace shigusa
