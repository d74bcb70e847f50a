// SPDX-License-Identifier: MIT
#include "side_view.hpp"

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

#include "core/check.hpp"

namespace shigusa::bench {
namespace {

constexpr strip::Colour kInk{0x222222};
constexpr double kRim = 0.8;  // points, around each part

// Bones of one frame, by name.
class Bones {
 public:
  Bones(const SkeletonMotion& motion, int frame)
      : skeleton_(motion.skeleton),
        transforms_(world_transforms(motion.skeleton, motion.clip, frame)) {}

  [[nodiscard]] const Transformd& of(std::string_view name) const {
    const int node = skeleton_.find(name);
    SHG_CHECK(node >= 0, "no node " + std::string(name));
    return transforms_[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] Vec3d at(std::string_view name) const { return of(name).translation; }
  [[nodiscard]] Vec3d at(std::string_view side, std::string_view name) const {
    return at(std::string(side) + std::string(name));
  }
  // Midpoint of the left and the right one.
  [[nodiscard]] Vec3d middle(std::string_view name) const {
    return 0.5 * (at("left_", name) + at("right_", name));
  }

 private:
  const Skeleton& skeleton_;
  std::vector<Transformd> transforms_;
};

// A place on the body and the half width there (m).
struct Round {
  Vec3d centre;
  double radius;
};

}  // namespace

void SideView::person(const SkeletonMotion& motion, int frame, const FigureColours& colours) {
  const Bones bones(motion, frame);
  const auto part = [&](std::initializer_list<Round> rounds, strip::Colour colour) {
    std::vector<strip::Disc> discs;
    for (const Round& round : rounds) {
      discs.push_back({at(from_the_side(round.centre)), scale_ * round.radius});
    }
    canvas_->hull(discs, colour, kRim);
  };
  const auto leg = [&](std::string_view side, strip::Colour colour) {
    const Vec3d ankle = bones.at(side, "foot");
    const Vec3d toes = bones.at(side, "toes");
    const Vec3d heel = ankle + 0.35 * (ankle - toes);
    part({{{heel.x, toes.y, heel.z}, 0.02}, {ankle, 0.04}, {toes, 0.02}}, colour);
    part({{bones.at(side, "lower_leg"), 0.055}, {ankle, 0.035}}, colour);
    part({{bones.at(side, "upper_leg"), 0.085}, {bones.at(side, "lower_leg"), 0.055}}, colour);
  };
  const auto arm = [&](std::string_view side, strip::Colour colour) {
    const Vec3d wrist = bones.at(side, "hand");
    part({{wrist, 0.03}, {bones.at(side, "hand_grip"), 0.03}}, colour);
    part({{bones.at(side, "lower_arm"), 0.04}, {wrist, 0.028}}, colour);
    part({{bones.at(side, "upper_arm"), 0.05}, {bones.at(side, "lower_arm"), 0.04}}, colour);
  };
  const Vec3d neck = bones.at("neck");
  const Transformd& head = bones.of("head");
  arm("left_", colours.far_limbs);
  leg("left_", colours.far_limbs);
  part({{neck, 0.05}, {head.translation, 0.05}}, colours.body);
  part({{head * Vec3d{0.0, 0.09, 0.02}, 0.095}, {head * Vec3d{0.0, 0.03, 0.06}, 0.05}},
       colours.body);
  part({{bones.middle("upper_leg"), 0.105}, {bones.at("spine"), 0.105}}, colours.body);
  part({{bones.at("spine"), 0.105}, {bones.at("chest"), 0.115}}, colours.body);
  part({{bones.at("chest"), 0.115}, {bones.middle("upper_arm"), 0.075}, {neck, 0.055}},
       colours.body);
  leg("right_", colours.near_leg);
  arm("right_", colours.near_arm);
}

void SideView::line(const std::vector<SidePoint>& points, strip::Colour colour, double width,
                    double dash) {
  std::vector<strip::Point> drawn;
  for (const SidePoint& point : points) drawn.push_back(at(point));
  canvas_->line(drawn, colour, width, dash);
}

void SideView::goal(SidePoint where) {
  constexpr double kRadius = 0.035;  // m
  const strip::Point centre = at(where);
  const double arm = 1.5 * scale_ * kRadius;
  canvas_->ring({centre, scale_ * kRadius}, kInk, 0.8);
  for (const strip::Point& off : {strip::Point{arm, 0.0}, strip::Point{0.0, arm}}) {
    const std::array<strip::Point, 2> ends{
        {{centre.x - off.x, centre.y - off.y}, {centre.x + off.x, centre.y + off.y}}};
    canvas_->line(ends, kInk, 0.8);
  }
}

void SideView::floor(double from, double to) { line({{from, 0.0}, {to, 0.0}}, {0x888888}, 0.8); }

}  // namespace shigusa::bench
