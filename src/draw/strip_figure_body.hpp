// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/draw.hpp>
#include <vector>

namespace shigusa::strip {

enum class Tone { left, right, middle, accent, bone };

struct Ball {
  Vec3d centre;
  double radius = 0.0;
};

// A piece of the figure: the convex hull of its balls, in the skeleton's world and unit.
struct Part {
  std::vector<Ball> balls;
  Tone tone = Tone::bone;
  int joints = 0;  // number of leading balls that mark joints
  bool foot = false;
  double setback = 0.0;  // distance by which it is painted further away than it lies
};

// Directions of an upright figure; orthogonal unit vectors.
struct Upright {
  Vec3d up;
  Vec3d forward;
};

// Shapes of a skeleton's nodes: rounded pieces.
class FigureBody {
 public:
  // `upright` is used if the skeleton's rest posture does not determine its directions.
  FigureBody(const Skeleton& skeleton, const StripSettings& settings, const Upright& upright);

  // Vector from the right hip to the left one (or the shoulders); zero if they are unknown.
  [[nodiscard]] Vec3d leftwards(const std::vector<Transformd>& world) const;

  // Position of the figure: its hips, or the mean of all nodes.
  [[nodiscard]] Vec3d place(const std::vector<Transformd>& world) const;

  // Standing point: the midpoint of the ankles, or its position.
  [[nodiscard]] Vec3d stance(const std::vector<Transformd>& world) const;

  // Standing height from the lengths of the limbs, independent of the posture; 0 if they are
  // unknown.
  [[nodiscard]] double stature() const { return stature_; }

  // Pieces in one posture. `size` is the stature, or a substitute length.
  [[nodiscard]] std::vector<Part> parts(const std::vector<Transformd>& world, double size) const;

 private:
  // Three nodes from the trunk outwards, and the toes of a leg; -1 if absent.
  struct Chain {
    std::array<int, 3> joint{-1, -1, -1};
    int toes = -1;
    std::vector<int> tips;  // nodes without children below the last joint
    Tone tone = Tone::middle;
  };
  struct Bone {
    int from = -1;
    int to = -1;
    double thickness = 0.0;  // share of the size
  };

  void find_bones(const StripSettings& settings);
  void find_trunk();
  void measure_rest(const Upright& upright);
  void measure_stature();
  void find_plain_bones();
  [[nodiscard]] std::vector<char> hidden_nodes() const;
  [[nodiscard]] std::vector<int> tips_below(int node) const;
  [[nodiscard]] bool below(int node, int ancestor) const;
  [[nodiscard]] bool has_trunk() const;
  [[nodiscard]] double chain_length(const Chain& chain) const;

  void add_trunk(const std::vector<Transformd>& world, double size, std::vector<Part>& parts) const;
  void add_head(const std::vector<Transformd>& world, double size, std::vector<Part>& parts) const;
  void add_limb(const Chain& limb, bool leg, const std::vector<Transformd>& world, double size,
                std::vector<Part>& parts) const;
  [[nodiscard]] Part hand(const Chain& arm, const std::vector<Transformd>& world,
                          double size) const;
  [[nodiscard]] Part foot(const Chain& leg, const std::vector<Transformd>& world,
                          double size) const;

  const Skeleton& skeleton_;
  std::array<Chain, 2> arms_;  // left, right
  std::array<Chain, 2> legs_;
  // Corners of the trunk, left and right. A body with one half only has the neck and the hips in
  // place of the missing ones.
  std::array<int, 2> shoulders_{-1, -1};
  std::array<int, 2> pelvis_{-1, -1};
  int hips_ = -1;
  int neck_ = -1;
  int head_ = -1;
  std::vector<int> spine_;   // nodes between the hips and the shoulders
  std::vector<Vec3d> rest_;  // (nodes) origins with all joints at rest
  Upright upright_;          // of the rest posture
  double stature_ = 0.0;
  std::optional<double> floor_;  // height along `up`, where it is told
  std::vector<Bone> bones_;      // bones outside the anatomical pieces
};

}  // namespace shigusa::strip
