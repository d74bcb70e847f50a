// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/body/joint_name.hpp>
#include <shigusa/edit/mirror.hpp>
#include <shigusa/generate/layered_problem.hpp>
#include <utility>

namespace shigusa {
namespace {

// The posture mode that is not of one side.
bool turns(std::string_view name) { return name_within_phase(name).starts_with("twist"); }

Vec3d across(const Vec3d& p) { return {-p.x, p.y, p.z}; }
Quatd across(const Quatd& q) { return {q.x, -q.y, -q.z, q.w}; }

// "right_elbow.weight=3" of "left_elbow.weight=3", "twist_deg=-20" of "twist_deg=20".
std::string mirrored_assignment(const std::string& assignment) {
  std::string text = mirrored_name(assignment);
  const std::size_t equals = text.find('=');
  if (!turns(text) || equals == text.npos) return text;
  const bool negative = equals + 1 < text.size() && text[equals + 1] == '-';
  return negative ? text.erase(equals + 1, 1) : text.insert(equals + 1, "-");
}

template <class Holder>
void mirror_fields(Holder& holder);

// Numbers and choices have no side.
template <class Value>
void mirror_value(Value&, Mirroring) {}
void mirror_value(Vec3d& point, Mirroring) { point = across(point); }
void mirror_value(Quatd& rotation, Mirroring) { rotation = across(rotation); }
void mirror_value(std::string& text, Mirroring how) {
  text = how == Mirroring::assignments ? mirrored_assignment(text) : mirrored_name(text);
}
template <Tabled Holder>
void mirror_value(Holder& holder, Mirroring) {
  mirror_fields(holder);
}
template <class Item>
void mirror_value(std::vector<Item>& list, Mirroring how) {
  for (Item& item : list) mirror_value(item, how);
}
template <class Value>
void mirror_value(std::optional<Value>& value, Mirroring how) {
  if (value) mirror_value(*value, how);
}

template <class Holder>
void mirror_fields(Holder& holder) {
  for_each_field<Holder>([&](const auto& field) {
    if (field.traits.mirroring == Mirroring::same) return;
    mirror_value(holder.*field.member, field.traits.mirroring);
  });
}

std::vector<JointWeight> mirrored_joints(const BodyModel& from, const BodyModel& to,
                                         const std::vector<JointWeight>& joints) {
  std::vector<JointWeight> image = joints;
  for (std::size_t d = 0; d < joints.size(); ++d) {
    const auto other = to.find_dof(mirrored_name(from.dofs()[d].name));
    if (other) image[static_cast<std::size_t>(*other)] = joints[d];
  }
  return image;
}

}  // namespace

std::string mirrored_name(std::string_view name) {
  const std::string_view within = name_within_phase(name);
  return std::string(name.substr(0, name.size() - within.size())) + with_other_side(within);
}

Result<TaskFile> mirrored(TaskFile task) {
  if (is_robot(task.character)) {
    return fail(ErrorCode::unsupported,
                task.character.source + " is a robot, whose mirror image is another robot");
  }
  const Result<BodyModel> body = build_character(task.character);
  if (!body) return tl::unexpected(body.error());
  for (const Dof& dof : body->dofs()) {
    if (body->find_dof(mirrored_name(dof.name))) continue;
    return fail(ErrorCode::unsupported,
                fmt::format("{} has one side only: it has {} and no {}", body->name(), dof.name,
                            mirrored_name(dof.name)));
  }
  mirror_fields<Request>(task);
  return task;
}

Parameters mirrored(const BodyModel& from, const BodyModel& to, const Parameters& parameters) {
  Parameters image = parameters;
  image.joints = mirrored_joints(from, to, parameters.joints);
  if (image.later) image.later->joints = mirrored_joints(from, to, parameters.later->joints);
  const bool later_modes = image.later && !image.later->modes.empty();
  if (parameters.posture.modes.empty() && !later_modes) return image;
  Parameters source = parameters;
  const std::vector<PostureMember> of_image = posture_members(to, image);
  for (const PostureMember& member : posture_members(from, source)) {
    for (const PostureMember& other : of_image) {
      if (other.name != mirrored_name(member.name)) continue;
      *other.value = turns(member.name) ? -*member.value : *member.value;
    }
  }
  return image;
}

Result<LayeredParameters> mirrored(const Task& task, const LayeredParameters& parameters) {
  Task source = task;
  for (Goal& goal : source.goals) goal.effector = mirrored_name(goal.effector);
  const auto before = layers_to_goals(source);
  const auto after = layers_to_goals(task);
  if (!before) return tl::unexpected(before.error());
  if (!after) return tl::unexpected(after.error());
  LayeredParameters from = parameters;
  LayeredParameters image;
  const std::vector<LayeredMember> of_image = layered_members(*after, image);
  for (const LayeredMember& member : layered_members(*before, from)) {
    for (const LayeredMember& other : of_image) {
      if (other.layer != mirrored_name(member.layer)) continue;
      if (other.name != mirrored_name(member.name)) continue;
      if (member.joint != nullptr && other.joint != nullptr) *other.joint = *member.joint;
      // outwards and to the front is the same on both sides
      if (member.angle != nullptr && other.angle != nullptr) *other.angle = *member.angle;
      for (std::size_t k = 0; k < std::min(member.contraction.size(), other.contraction.size());
           ++k) {
        *other.contraction[k] = *member.contraction[k];
      }
    }
  }
  return image;
}

}  // namespace shigusa
