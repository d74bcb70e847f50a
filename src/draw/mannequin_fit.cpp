// SPDX-License-Identifier: MIT
#include "mannequin_fit.hpp"

#include <algorithm>
#include <utility>

#include "core/check.hpp"
#include "core/index.hpp"
#include "math/axes.hpp"

namespace shigusa {
namespace {

const std::map<std::string, std::string> kAbove{
    {"spine", "hips"},         {"chest", "spine"},         {"upper_chest", "chest"},
    {"neck", "upper_chest"},   {"head", "neck"},           {"shoulder", "upper_chest"},
    {"upper_arm", "shoulder"}, {"lower_arm", "upper_arm"}, {"hand", "lower_arm"},
    {"upper_leg", "hips"},     {"lower_leg", "upper_leg"}, {"foot", "lower_leg"},
    {"toes", "foot"}};
const std::map<std::string, std::string> kNext{{"upper_arm", "lower_arm"},
                                               {"lower_arm", "hand"},
                                               {"upper_leg", "lower_leg"},
                                               {"lower_leg", "foot"}};

// Splits "left_hand" into "left_" and "hand".
std::pair<std::string, std::string> parts(const std::string& name) {
  for (const std::string side : {"left_", "right_"}) {
    if (name.starts_with(side)) return {side, name.substr(side.size())};
  }
  return {"", name};
}

// The bone above; for the hips themselves.
std::string above(const std::string& name) {
  const auto [side, bone] = parts(name);
  const auto found = kAbove.find(bone);
  const std::string next = found == kAbove.end() ? "hips" : found->second;
  const bool central = next == "hips" || next == "spine" || next == "chest" ||
                       next == "upper_chest" || next == "neck";
  return central ? next : side + next;
}

std::optional<double> length_of(const std::optional<Vec3d>& way) {
  return way ? std::optional(norm(*way)) : std::nullopt;
}

// Shortest rotation from one unit vector to another.
Quatd turn_between(const Vec3d& from, const Vec3d& to) {
  const double cosine = dot(from, to);
  // opposite directions: about any perpendicular axis
  const bool opposite = cosine < -1.0 + 1e-9;
  const Vec3d across = main_axis(from) == 0 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
  const Vec3d axis = cross(from, opposite ? across : to);
  const double w = opposite ? 0.0 : 1.0 + cosine;
  const double over = 1.0 / sqrt(dot(axis, axis) + w * w);
  return {axis.x * over, axis.y * over, axis.z * over, w * over};
}

}  // namespace

RestBones::RestBones(const Skeleton& body) : body_(body), places_(rest_origins(body)) {
  const Vec3d left =
      normalized(way("right_upper_leg", "left_upper_leg").value_or(Vec3d{1, 0, 0}), {1, 0, 0});
  Vec3d up =
      normalized(way("hips", way("hips", "neck") ? "neck" : "head").value_or(Vec3d{0, 1, 0}));
  up = normalized(up - left * dot(up, left));
  axes_ = {left, up, cross(left, up)};
}

int RestBones::node(const std::string& bone) const { return body_.find(bone); }

std::optional<Vec3d> RestBones::at(const std::string& bone) const {
  const int i = node(bone);
  return i < 0 ? std::nullopt : std::optional(places_[index(i)]);
}

std::optional<Vec3d> RestBones::way(const std::string& from, const std::string& to) const {
  const auto a = at(from);
  const auto b = at(to);
  return a && b ? std::optional(*b - *a) : std::nullopt;
}

Vec3d RestBones::way_to_tip(const std::string& bone) const {
  const int root = node(bone);
  std::vector<bool> below(places_.size(), false);
  below[index(root)] = true;
  Vec3d farthest{};
  for (std::size_t i = index(root) + 1; i < places_.size(); ++i) {
    const int parent = body_.nodes[i].parent;
    below[i] = parent >= 0 && below[index(parent)];
    const Vec3d way = places_[i] - places_[index(root)];
    if (below[i] && norm(way) > norm(farthest)) farthest = way;
  }
  return farthest;
}

SkinFitter::SkinFitter(const RestBones& body, const MannequinMesh& mesh, double stature)
    : body_(body), mesh_(mesh), scale_(stature / mesh.stature) {
  const double wide = ratio(length_of(body.way("right_upper_leg", "left_upper_leg")),
                            2.0 * made("left_upper_leg").place.x);
  const double tall = ratio(length_of(body.way("hips", "neck")), mesh.measures.at("trunk"));
  trunk_ = lay(body.at("hips").value(), {}, {wide, tall, scale_}, made("hips").place, 0.0);
}

const SkinBone& SkinFitter::made(const std::string& bone) const {
  const auto found = std::find_if(mesh_.bones.begin(), mesh_.bones.end(),
                                  [&](const SkinBone& each) { return each.name == bone; });
  SHG_CHECK(found != mesh_.bones.end(), "a bone of the mannequin");
  return *found;
}

std::string SkinFitter::carrier(const std::string& bone) const {
  return body_.has(bone) || bone == "hips" ? bone : carrier(above(bone));
}

// Ratio of a body's length to the mesh's; the overall scale if it is unknown.
double SkinFitter::ratio(std::optional<double> length, double made) const {
  if (!length || *length < 0.01 * scale_) return scale_;
  return clamp(*length / made, 0.4 * scale_, 2.5 * scale_);
}

// Transform from mesh space to `at`, scaled along the hanging limb's axes.
Transformd SkinFitter::lay(const Vec3d& at, const Quatd& turn, const Vec3d& scale,
                           const Vec3d& from, double angle) const {
  const Mat3d hanging = to_matrix(axis_rotation(Axis::z, -angle));
  const Mat3d scaled = scaled_columns(to_matrix(turn) * body_.axes(), scale) * hanging;
  return {scaled, at - scaled * from};
}

Transformd SkinFitter::hanging(const SkinBone& follower, const Quatd& turn) const {
  const auto [side, bone] = parts(follower.of);
  const Vec3d scale = follower.kind == SkinBone::Kind::half ? Vec3d{scale_, scale_, scale_}
                                                            : measure(side, bone).scale;
  return lay(body_.at(follower.of).value(), turn, scale, follower.place, follower.angle);
}

SkinFit SkinFitter::of(const std::string& name) const {
  const auto [side, bone] = parts(name);
  if (auto gone = missing(side, bone)) return *gone;
  if (side.empty() && bone != "neck" && bone != "head") return {carrier(name), {}, trunk_};
  if (bone == "shoulder") return shoulder(side);
  const auto at = body_.at(name);
  if (!at) return of(carrier(name));
  const auto [scale, turn] = measure(side, bone);
  return {name, turn, lay(*at, turn, scale, made(name).place, made(name).angle)};
}

// Placement of a limb that the body lacks: it shrinks into its joint.
std::optional<SkinFit> SkinFitter::missing(const std::string& side, const std::string& bone) const {
  const bool arm = bone.ends_with("arm") || bone == "hand";
  const bool leg = bone.ends_with("leg") || bone == "foot" || bone == "toes";
  const std::string limb = arm ? "arm" : "leg";
  if ((!arm && !leg) || body_.has(side + "lower_" + limb)) return std::nullopt;
  const std::string root = side + "upper_" + limb;
  const double tiny = 1e-3 * scale_;
  return SkinFit{carrier(arm ? side + "shoulder" : "hips"),
                 {},
                 lay(body_.at(root).value_or(trunk_ * made(root).place), {}, {tiny, tiny, tiny},
                     made(root).place, 0.0)};
}

// Placement of a shoulder girdle; its end at the arm's joint is exact.
SkinFit SkinFitter::shoulder(const std::string& side) const {
  const std::string arm = side + "upper_arm";
  const Vec3d place = made(arm).place;
  const double wide =
      ratio(length_of(body_.way("right_upper_arm", "left_upper_arm")), 2.0 * abs(place.x));
  return {carrier(side + "shoulder"),
          {},
          lay(body_.at(arm).value_or(trunk_ * place), {}, {wide, scale_, scale_}, place, 0.0)};
}

SkinFitter::Measure SkinFitter::measure(const std::string& side, const std::string& bone) const {
  const double s = scale_;
  if (bone == "neck") {
    const double high = made("head").place.y - made("neck").place.y;
    return {{s, ratio(length_of(body_.way("neck", "head")), high), s}};
  }
  if (bone == "head") {
    // few bodies have a node at the top of the head
    const double top = ratio(norm(body_.way_to_tip("head")), mesh_.measures.at("head"));
    const double size = clamp(top, 0.9 * s, 1.15 * s);
    return {{size, size, size}};
  }
  if (bone == "toes") return {{s, s, s}, of(side + "foot").turn};
  if (bone == "foot") return foot(side);
  const bool hand = bone == "hand";
  const std::optional<Vec3d> way =
      hand ? body_.way_to_tip(side + bone) : body_.way(side + bone, side + kNext.at(bone));
  if (!way || norm(*way) < 0.04 * s) return {{s, s, s}, of(carrier(above(side + bone))).turn};
  const bool guessed = hand && norm(*way) < 0.12 * s;
  const double size = guessed ? s : ratio(norm(*way), mesh_.measures.at(bone));
  return {{hand ? size : s, size, hand ? size : s}, turn_of({0, -1, 0}, *way)};
}

SkinFitter::Measure SkinFitter::foot(const std::string& side) const {
  const auto way = body_.way(side + "foot", side + "toes");
  if (!way) return {{scale_, scale_, scale_}};
  const SkinBone& ankle = made(side + "foot");
  const Vec3d as_made =
      to_matrix(axis_rotation(Axis::z, -ankle.angle)) * (made(side + "toes").place - ankle.place);
  const double size = ratio(norm(*way), norm(as_made));
  return {{scale_, size, size}, turn_of(as_made, *way)};
}

// Shortest rotation from a direction in the body's axes to one in the world.
Quatd SkinFitter::turn_of(const Vec3d& made, const Vec3d& way) const {
  return turn_between(normalized(body_.axes() * made), normalized(way));
}

}  // namespace shigusa
