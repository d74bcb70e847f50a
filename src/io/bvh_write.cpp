// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <iterator>
#include <shigusa/core/check.hpp>
#include <shigusa/io/bvh.hpp>
#include <vector>

#include "node_names.hpp"

namespace shigusa {
namespace {

constexpr int kAngleDecimals = 6;               // degrees: 9e-9 rad, 9e-9 m at the end of a metre
constexpr double kLengthResolution = 1.001e-8;  // m; 1e-8 whatever the rounding of 0.01
// A node that never leaves its offset by more (m) needs no position channels.
constexpr double kStillness = 1e-9;
// Below this cosine of the middle angle the outer two turn about one axis: gimbal lock.
constexpr double kGimbal = 1e-9;

// Angles in degrees with R = Rot(z, .z) Rot(x, .x) Rot(y, .y), given the first of them.
Vec3d angles_after_z(const Mat3d& r, double z) {
  // Rot(z)ᵀ R = Rot(x) Rot(y); here z may be any angle in gimbal lock, and x and y make up for it
  const SinCos<double> a = sin_cos(z);
  const double xx = a.cos * r.cx.x + a.sin * r.cx.y;
  const double xz = a.cos * r.cz.x + a.sin * r.cz.y;
  const double yy = a.cos * r.cy.y - a.sin * r.cy.x;
  return {degrees(atan2(r.cy.z, yy)), degrees(atan2(xz, xx)), degrees(z)};
}

// The angle equal to `angle` up to whole turns that is nearest to `near`.
double unwrapped(double angle, double near) {
  constexpr double kTurn = 360.0;
  const double turns = (near - angle) / kTurn;
  return angle +
         kTurn * static_cast<double>(static_cast<long long>(turns < 0 ? turns - 0.5 : turns + 0.5));
}

double distance(const Vec3d& a, const Vec3d& b) {
  return max(abs(a.x - b.x), max(abs(a.y - b.y), abs(a.z - b.z)));
}

// Euler angles in degrees (.z first, then .x, then .y), of their two forms the one nearer to the
// frame before.
Vec3d euler_zxy(const Quatd& rotation, const Vec3d& before) {
  const Mat3d r = to_matrix(rotation);
  const bool locked = abs(r.cy.x) < kGimbal && abs(r.cy.y) < kGimbal;
  const double z = locked ? radians(before.z) : atan2(-r.cy.x, r.cy.y);
  Vec3d best{};
  for (const double half_turn : {0.0, kPi}) {
    Vec3d angles = angles_after_z(r, z + half_turn);
    for (int i = 0; i < 3; ++i) angles[i] = unwrapped(angles[i], before[i]);
    if (half_turn == 0.0 || distance(angles, before) < distance(best, before)) best = angles;
  }
  return best;
}

class BvhWriter {
 public:
  BvhWriter(const SkeletonMotion& motion, double unit) : motion_(motion), unit_(unit) {
    while (decimals_ < 16 && resolution_ * unit > kLengthResolution) {
      resolution_ /= 10.0;
      ++decimals_;
    }
    find_order();
    find_moving();
  }

  std::string write() {
    append("HIERARCHY\n");
    for (std::size_t i = 0; i < order_.size(); ++i) {
      write_node(i);
      const int next_depth = i + 1 < order_.size() ? depth_[order_[i + 1]] : 0;
      for (int d = depth_[order_[i]]; d >= next_depth; --d) append("{:\t>{}}}}\n", "", d);
    }
    append("MOTION\nFrames: {}\nFrame Time: {}\n", motion_.clip.frames, motion_.clip.frame_time);
    std::vector<Vec3d> angles(order_.size());
    for (int frame = 0; frame < motion_.clip.frames; ++frame) write_frame(frame, angles);
    return std::move(text_);
  }

 private:
  [[nodiscard]] const SkeletonNode& node(std::size_t i) const { return motion_.skeleton.nodes[i]; }
  // an end site that carries children is a joint by mistake
  [[nodiscard]] bool is_end(std::size_t i) const { return node(i).end_site && !has_child_[i]; }

  template <class... Args>
  void append(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  // Nodes depth first, each one's children in their order.
  void find_order() {
    const std::size_t count = motion_.skeleton.nodes.size();
    std::vector<std::vector<std::size_t>> children(count);
    depth_.resize(count);
    has_child_.resize(count);
    std::vector<std::size_t> open;
    for (std::size_t i = count; i-- > 0;) {
      const int parent = node(i).parent;
      SHG_CHECK(parent < static_cast<int>(i), "parents come before their children");
      if (parent < 0) {
        open.push_back(i);
      } else {
        children[static_cast<std::size_t>(parent)].push_back(i);
        has_child_[static_cast<std::size_t>(parent)] = true;
      }
    }
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      order_.push_back(i);
      for (const std::size_t child : children[i]) {
        depth_[child] = depth_[i] + 1;
        open.push_back(child);
      }
    }
  }

  void find_moving() {
    const std::size_t count = motion_.skeleton.nodes.size();
    moves_.resize(count);
    for (std::size_t i = 0; i < count; ++i) moves_[i] = node(i).parent < 0;
    for (std::size_t k = 0; k < motion_.clip.local.size(); ++k) {
      const std::size_t i = k % count;
      const auto& [t, q] = motion_.clip.local[k];
      SHG_CHECK(is_finite(t.x + t.y + t.z + q.x + q.y + q.z + q.w),
                "finite transforms, also of node '" + node(i).name + "'");
      const Vec3d off = t - node(i).offset;
      if (max(abs(off.x), max(abs(off.y), abs(off.z))) > kStillness && !is_end(i)) moves_[i] = true;
    }
  }

  void write_node(std::size_t place) {
    const std::size_t i = order_[place];
    const int depth = depth_[i];
    const bool root = node(i).parent < 0;
    append("{:\t>{}}", "", depth);
    if (is_end(i) && !root) {
      append("End Site\n");
    } else {
      append("{} {}\n", root ? "ROOT" : "JOINT", names_.take(node(i).name));
    }
    append("{0:\t>{1}}{{\n{0:\t>{2}}OFFSET", "", depth, depth + 1);
    write_lengths(root ? Vec3d{} : node(i).offset);
    append("\n");
    if (is_end(i) && !root) return;
    append("{:\t>{}}CHANNELS {}Zrotation Xrotation Yrotation\n", "", depth + 1,
           moves_[i] ? "6 Xposition Yposition Zposition " : "3 ");
  }

  void write_frame(int frame, std::vector<Vec3d>& angles) {
    const LocalTransform* local = motion_.clip.frame(motion_.skeleton, frame);
    const std::size_t start = text_.size();
    for (const std::size_t i : order_) {
      if (is_end(i) && node(i).parent >= 0) continue;
      if (moves_[i]) write_lengths(local[i].translation);
      Vec3d& a = angles[i];
      a = euler_zxy(local[i].rotation, a);
      for (const double angle : {a.z, a.x, a.y}) write_number(angle, kAngleDecimals, 5e-7);
    }
    // each number brings its blank; the first needs none
    if (text_.size() > start) text_.erase(start, 1);
    append("\n");
  }

  void write_lengths(const Vec3d& v) {
    for (int i = 0; i < 3; ++i) write_number(v[i] / unit_, decimals_, 0.5 * resolution_);
  }

  // `half`: half of the last decimal; what lies below it is 0, never -0
  void write_number(double value, int decimals, double half) {
    append(" {:.{}f}", abs(value) < half ? 0.0 : value, decimals);
  }

  const SkeletonMotion& motion_;
  double unit_;
  int decimals_ = 0;
  double resolution_ = 1.0;  // last decimal of a length, in file units
  NodeNames names_{false};
  std::vector<std::size_t> order_;  // nodes as they are written
  std::vector<int> depth_;          // (nodes)
  std::vector<bool> has_child_;     // (nodes)
  std::vector<bool> moves_;         // (nodes) has position channels
  std::string text_;
};

}  // namespace

std::string format_bvh(const SkeletonMotion& motion, const BvhFormat& format) {
  SHG_CHECK(format.unit > 0.0 && is_finite(format.unit), "the unit is a positive length");
  SHG_CHECK(motion.clip.frames >= 1, "BVH needs at least one frame");
  SHG_CHECK(motion.clip.local.size() ==
                static_cast<std::size_t>(motion.clip.frames) * motion.skeleton.nodes.size(),
            "one transform for each frame and node");
  return BvhWriter(motion, format.unit).write();
}

}  // namespace shigusa
