// SPDX-License-Identifier: MIT
#include "mujoco_file.hpp"

#ifdef SHIGUSA_HAS_MUJOCO
#include <mujoco/mujoco.h>
#endif

namespace shigusa::bench {

#ifdef SHIGUSA_HAS_MUJOCO
namespace {

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

class ReadFile final : public MujocoFile {
 public:
  explicit ReadFile(std::unique_ptr<mjModel, Free> model) : model_(std::move(model)) {}

  // a ball is three columns of a table, and a quaternion in MuJoCo
  [[nodiscard]] bool has_balls() const {
    for (int j = 0; j < model_->njnt; ++j) {
      if (model_->jnt_type[j] == mjJNT_BALL) return true;
    }
    return false;
  }

  [[nodiscard]] OutsideMotion motion(const std::string& root, const Table& table,
                                     const std::vector<std::string>& bodies) const override {
    OutsideMotion motion;
    const int root_body = mj_name2id(model_.get(), mjOBJ_BODY, root.c_str());
    if (root_body < 0) return motion;
    std::vector<int> found;
    for (const std::string& name : bodies) {
      const int body = mj_name2id(model_.get(), mjOBJ_BODY, name.c_str());
      if (body < 0 || motion.has(name)) continue;
      motion.nodes[name] = found.size();
      found.push_back(body);
    }
    const std::unique_ptr<mjData, Free> data(mj_makeData(model_.get()));
    for (std::size_t row = 0; row < table.rows(); ++row) {
      set_joints(table, row, *data);
      mj_kinematics(model_.get(), data.get());
      const Transformd from_root = root_place(table, row) * inverse(place(*data, root_body));
      std::vector<Transformd>& places = motion.places.emplace_back();
      for (const int body : found) places.push_back(from_root * place(*data, body));
    }
    return motion;
  }

 private:
  void set_joints(const Table& table, std::size_t row, mjData& data) const {
    for (int j = 0; j < model_->njnt; ++j) {
      const char* name = mj_id2name(model_.get(), mjOBJ_JOINT, j);
      if (name == nullptr || model_->jnt_type[j] == mjJNT_FREE) continue;
      const bool slides = model_->jnt_type[j] == mjJNT_SLIDE;
      const std::string column = std::string(name) + (slides ? " [m]" : " [rad]");
      if (table.has(column)) data.qpos[model_->jnt_qposadr[j]] = table.at(column, row);
    }
  }

  static Transformd place(const mjData& data, int body) {
    const double* r = data.xmat + 9 * body;
    const double* p = data.xpos + 3 * body;
    return {{{r[0], r[3], r[6]}, {r[1], r[4], r[7]}, {r[2], r[5], r[8]}}, {p[0], p[1], p[2]}};
  }

  std::unique_ptr<mjModel, Free> model_;
};

}  // namespace

std::shared_ptr<const MujocoFile> MujocoFile::read(const std::filesystem::path& path) {
  char error[500] = "";
  std::unique_ptr<mjModel, Free> model(
      mj_loadXML(path.string().c_str(), nullptr, error, sizeof error));
  if (model == nullptr) return nullptr;
  auto file = std::make_shared<ReadFile>(std::move(model));
  if (file->has_balls()) return nullptr;
  return file;
}
#else
std::shared_ptr<const MujocoFile> MujocoFile::read(const std::filesystem::path&) { return nullptr; }
#endif

}  // namespace shigusa::bench
