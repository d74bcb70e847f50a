// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <shigusa/formats.hpp>
#include <vector>

#include "core/check.hpp"
#include "core/index.hpp"
#include "node_names.hpp"

namespace shigusa {
namespace {

constexpr int kAngleDecimals = 6;               // degrees: 9e-9 rad, 9e-9 m at the end of a metre
constexpr double kLengthResolution = 1.001e-8;  // m; 1e-8 whatever the rounding of 0.01
// Distance (m) below which a node's deviation from its offset needs no position channels.
constexpr double kStillness = 1e-9;
// Cosine of the middle angle below which the outer axes coincide: gimbal lock.
constexpr double kGimbal = 1e-9;

// Axes of three rotations in order, R = Rot(a[0]) Rot(a[1]) Rot(a[2]).
using Order = std::array<int, 3>;
constexpr Order kZxy{2, 0, 1};

// Euler angles in degrees, by axis, of R in that order, for a given first angle.
Vec3d angles_after(const Mat3d& r, const Order& order, double first) {
  const auto [i, j, k] = order;
  const double s = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
  const auto at = [&r](int row, int column) { return r.column(column)[row]; };
  // Rot(first)ᵀ R = Rot(a[1]) Rot(a[2]); in gimbal lock the first angle is arbitrary, and the
  // others compensate
  const SinCos<double> a = sin_cos(first);
  const double jj = a.cos * at(j, j) + s * a.sin * at(k, j);
  const double ji = a.cos * at(j, i) + s * a.sin * at(k, i);
  const double kk = a.cos * at(k, k) - s * a.sin * at(j, k);
  Vec3d angles;
  angles[i] = degrees(first);
  angles[j] = degrees(atan2(s * at(i, k), kk));
  angles[k] = degrees(atan2(s * ji, jj));
  return angles;
}

// Equivalent angle, up to full turns, that is nearest to `near`.
double unwrapped(double angle, double near) {
  constexpr double kTurn = 360.0;
  const double turns = (near - angle) / kTurn;
  return angle +
         kTurn * static_cast<double>(static_cast<long long>(turns < 0 ? turns - 0.5 : turns + 0.5));
}

double distance(const Vec3d& a, const Vec3d& b) {
  return max(abs(a.x - b.x), max(abs(a.y - b.y), abs(a.z - b.z)));
}

// Euler angles in degrees, by axis, in the form nearer to the previous frame.
Vec3d euler_angles(const Quatd& rotation, const Order& order, const Vec3d& before) {
  const Mat3d r = to_matrix(rotation);
  const auto [i, j, k] = order;
  const double s = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
  const double sine = r.column(k)[j];
  const double cosine = r.column(k)[k];
  const bool locked = abs(sine) < kGimbal && abs(cosine) < kGimbal;
  const double first = locked ? radians(before[i]) : atan2(-s * sine, cosine);
  Vec3d best{};
  for (const double half_turn : {0.0, kPi}) {
    Vec3d angles = angles_after(r, order, first + half_turn);
    for (int axis = 0; axis < 3; ++axis) angles[axis] = unwrapped(angles[axis], before[axis]);
    if (half_turn == 0.0 || distance(angles, before) < distance(best, before)) best = angles;
  }
  return best;
}

// Name with blanks replaced: three.js takes only the first word, and Blender joins words in this
// way.
std::string one_word(std::string name) {
  const std::size_t last = name.find_last_not_of(' ');
  for (std::size_t i = name.find_first_not_of(' '); i < last && i < name.size(); ++i) {
    if (name[i] == ' ') name[i] = '_';
  }
  return name;
}

class BvhWriter {
 public:
  BvhWriter(const SkeletonMotion& motion, const BvhFormat& format)
      : motion_(motion), unit_(format.unit) {
    while (decimals_ < 16 && resolution_ * unit_ > kLengthResolution) {
      resolution_ /= 10.0;
      ++decimals_;
    }
    find_order();
    find_moving();
    find_channels(format.channels);
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
  // an end site with children is in fact a joint
  [[nodiscard]] bool is_end(std::size_t i) const { return node(i).end_site && !has_child_[i]; }

  template <class... Args>
  void append(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void find_order() {
    const std::size_t count = motion_.skeleton.nodes.size();
    depth_.resize(count);
    has_child_.resize(count);
    for (const int i : bvh_order(motion_.skeleton)) {
      order_.push_back(index(i));
      const int parent = node(order_.back()).parent;
      if (parent < 0) continue;
      depth_[order_.back()] = depth_[index(parent)] + 1;
      has_child_[index(parent)] = true;
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

  void find_channels(const BvhChannels& given) {
    const std::size_t count = motion_.skeleton.nodes.size();
    std::vector<bool> turns(count);
    for (std::size_t k = 0; k < motion_.clip.local.size(); ++k) {
      const Quatd& q = motion_.clip.local[k].rotation;
      if (q.x != 0.0 || q.y != 0.0 || q.z != 0.0) turns[k % count] = true;
    }
    channels_.resize(count);
    rotations_.resize(count, kZxy);
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<BvhChannel> own = i < given.size() ? given[i] : std::vector<BvhChannel>{};
      const std::optional<Order> order = order_of(own);
      rotations_[i] = order.value_or(kZxy);
      const bool tells_turns = (order || !turns[i]) && i < given.size();
      if (tells_turns && moves_[i] && places_all(own)) {
        channels_[i] = own;
        continue;
      }
      for (int axis = 0; axis < 3 && moves_[i]; ++axis) {
        channels_[i].push_back({false, static_cast<Axis>(axis)});
      }
      if (tells_turns && !moves_[i]) {
        for (const BvhChannel& channel : own) {
          if (channel.rotates) channels_[i].push_back(channel);
        }
        continue;
      }
      for (const int axis : rotations_[i]) channels_[i].push_back({true, static_cast<Axis>(axis)});
    }
  }

  // Rotation order of a node, if its channels determine one: three about different axes.
  static std::optional<Order> order_of(const std::vector<BvhChannel>& channels) {
    std::vector<int> axes;
    for (const auto& [rotates, axis] : channels) {
      if (rotates) axes.push_back(static_cast<int>(axis));
    }
    if (axes.size() != 3 || axes[0] == axes[1] || axes[1] == axes[2] || axes[2] == axes[0]) {
      return std::nullopt;
    }
    return Order{axes[0], axes[1], axes[2]};
  }

  static bool places_all(const std::vector<BvhChannel>& channels) {
    return std::count_if(channels.begin(), channels.end(),
                         [](const BvhChannel& channel) { return !channel.rotates; }) == 3;
  }

  void write_node(std::size_t place) {
    const std::size_t i = order_[place];
    const int depth = depth_[i];
    const bool root = node(i).parent < 0;
    append("{:\t>{}}", "", depth);
    if (is_end(i) && !root) {
      append("End Site\n");
    } else {
      append("{} {}\n", root ? "ROOT" : "JOINT", names_.take(one_word(node(i).name)));
    }
    append("{0:\t>{1}}{{\n{0:\t>{2}}OFFSET", "", depth, depth + 1);
    write_lengths(moves_[i] ? Vec3d{} : node(i).offset);
    append("\n");
    if (is_end(i) && !root) return;
    append("{:\t>{}}CHANNELS {}", "", depth + 1, channels_[i].size());
    for (const auto& [rotates, axis] : channels_[i]) {
      append(" {}{}", "XYZ"[static_cast<int>(axis)], rotates ? "rotation" : "position");
    }
    append("\n");
  }

  void write_frame(int frame, std::vector<Vec3d>& angles) {
    const LocalTransform* local = motion_.clip.frame(motion_.skeleton, frame);
    const std::size_t start = text_.size();
    for (const std::size_t i : order_) {
      if (is_end(i) && node(i).parent >= 0) continue;
      angles[i] = euler_angles(local[i].rotation, rotations_[i], angles[i]);
      for (const auto& [rotates, axis] : channels_[i]) {
        const int k = static_cast<int>(axis);
        if (rotates) {
          write_number(angles[i][k], kAngleDecimals, 5e-7);
        } else {
          write_length(local[i].translation[k]);
        }
      }
    }
    // each number includes its blank; the first needs none
    if (text_.size() > start) text_.erase(start, 1);
    append("\n");
  }

  void write_lengths(const Vec3d& v) {
    for (int i = 0; i < 3; ++i) write_length(v[i]);
  }

  void write_length(double v) { write_number(v / unit_, decimals_, 0.5 * resolution_); }

  // `half`: half of the last decimal; smaller values are 0, never -0
  void write_number(double value, int decimals, double half) {
    append(" {:.{}f}", abs(value) < half ? 0.0 : value, decimals);
  }

  const SkeletonMotion& motion_;
  double unit_;
  int decimals_ = 0;
  double resolution_ = 1.0;  // last decimal of a length, in file units
  NodeNames names_;
  std::vector<std::size_t> order_;  // nodes as they are written
  std::vector<int> depth_;          // (nodes)
  std::vector<bool> has_child_;     // (nodes)
  std::vector<bool> moves_;         // (nodes) leaves its offset
  BvhChannels channels_;            // (nodes)
  std::vector<Order> rotations_;    // (nodes) the axes of its rotations
  std::string text_;
};

}  // namespace

std::vector<int> bvh_order(const Skeleton& skeleton) {
  const int count = static_cast<int>(skeleton.nodes.size());
  std::vector<std::vector<int>> children(skeleton.nodes.size());
  std::vector<int> open;
  std::vector<int> order;
  // in reverse, so that the first pending node is last in the list
  for (int i = count - 1; i >= 0; --i) {
    const int parent = skeleton.nodes[index(i)].parent;
    SHG_CHECK(parent < i, "parents come before their children");
    (parent < 0 ? open : children[index(parent)]).push_back(i);
  }
  while (!open.empty()) {
    order.push_back(open.back());
    open.pop_back();
    const std::vector<int>& next = children[static_cast<std::size_t>(order.back())];
    open.insert(open.end(), next.begin(), next.end());
  }
  return order;
}

std::string format_bvh(const SkeletonMotion& motion, const BvhFormat& format) {
  SHG_CHECK(format.unit > 0.0 && is_finite(format.unit), "the unit is a positive length");
  SHG_CHECK(motion.clip.frames >= 1, "BVH needs at least one frame");
  SHG_CHECK(motion.clip.local.size() ==
                static_cast<std::size_t>(motion.clip.frames) * motion.skeleton.nodes.size(),
            "one transform for each frame and node");
  return BvhWriter(motion, format).write();
}

}  // namespace shigusa
