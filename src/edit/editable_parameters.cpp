// SPDX-License-Identifier: MIT
#include <shigusa/body/joint_name.hpp>
#include <shigusa/body/posture_modes.hpp>
#include <shigusa/edit/editable_parameters.hpp>
#include <shigusa/generate/layered_problem.hpp>

#include "io/json_text.hpp"

namespace shigusa {
namespace {

// Whose slider it is, by the joint's name: "right_knee.flexion".
std::string limb_group(std::string_view name) {
  const JointName joint = parse_joint_name(name);
  const LimbKind limb = joint.limb();
  if (limb == LimbKind::trunk) return "trunk";
  if (!joint.side) return limb == LimbKind::leg ? "legs" : "arms";
  const std::string side = joint.side == Side::left ? "left_" : "right_";
  return side + (limb == LimbKind::leg ? "leg" : "arm");
}

std::string posture_group(std::string_view name) {
  const std::string_view mode = name_within_phase(name);
  if (parse_joint_name(mode).side) return limb_group(mode);
  for (const TimingNumber& number : kTimingNumbers) {
    if (mode == number.name) return "path";
  }
  return "posture";
}

EditableParameter weight(const std::string& name, const std::string& group,
                         const JointWeight& joint) {
  return {name + ".weight", group,      EditableKind::weight, joint.weight,
          kWeightMin,       kWeightMax, joint.locked};
}

void add_weights(const BodyModel& body, const std::string& prefix,
                 const std::vector<JointWeight>& joints, std::vector<EditableParameter>& list) {
  for (std::size_t d = 0; d < joints.size(); ++d) {
    const std::string& name = body.dofs()[d].name;
    list.push_back(weight(prefix + name, limb_group(name), joints[d]));
  }
}

std::vector<EditableParameter> flat_parameters(const BodyModel& body, Parameters parameters) {
  std::vector<EditableParameter> list;
  const std::vector<PostureMode> modes = posture_modes(body);
  // what moves a motion most comes first
  for (const PostureMember& member : posture_members(body, parameters)) {
    if (member.angle) {
      // of what is allowed, what makes sense
      double low = member.low;
      double high = member.high;
      for (const PostureMode& mode : modes) {
        if (mode.name != name_within_phase(member.name)) continue;
        low = min(mode.lower, *member.value);
        high = max(mode.upper, *member.value);
      }
      list.push_back({member.name + "_deg", posture_group(member.name), EditableKind::angle,
                      degrees(*member.value), degrees(low), degrees(high), false});
    } else {
      list.push_back({member.name, posture_group(member.name), EditableKind::share, *member.value,
                      member.low, member.high, false});
    }
  }
  add_weights(body, "", parameters.joints, list);
  if (parameters.later) {
    add_weights(body, std::string(kLaterPrefix), parameters.later->joints, list);
  }
  return list;
}

Result<std::vector<EditableParameter>> layered_list(const Task& task,
                                                    LayeredParameters parameters) {
  const auto layers = layers_to_goals(task);
  if (!layers) return tl::unexpected(layers.error());
  std::vector<EditableParameter> list;
  for (const LayeredMember& member : layered_members(*layers, parameters)) {
    const std::string prefix = member.layer.empty() ? "" : member.layer + ".";
    if (member.joint != nullptr) {
      const std::string group =
          member.layer.empty() ? limb_group(member.name) : limb_group(member.layer);
      list.push_back(weight(prefix + member.name, group, *member.joint));
    } else if (member.angle != nullptr) {
      const bool swivel = member.kind == LayerGeneKind::swivel;
      const std::string name = swivel ? prefix + "swivel_deg" : member.name + ".final_deg";
      list.push_back({name, limb_group(swivel ? member.layer : member.name), EditableKind::angle,
                      degrees(*member.angle), degrees(member.low), degrees(member.high), false});
    } else if (!member.contraction.empty()) {
      list.push_back({prefix + member.name + ".contraction", limb_group(member.name),
                      EditableKind::share, *member.contraction.front(), 0.0, kLayerGeneMax, false});
    }
  }
  return list;
}

}  // namespace

Result<std::vector<EditableParameter>> editable_parameters(const Task& task,
                                                           const Candidate& candidate) {
  if (candidate.layered) return layered_list(task, *candidate.layered);
  return flat_parameters(task.body, candidate.parameters);
}

std::string format_parameters(const std::vector<EditableParameter>& parameters) {
  constexpr const char* kKinds[] = {"weight", "angle", "share"};
  Json list = Json::array();
  for (const EditableParameter& p : parameters) {
    list.push_back({{"name", p.name},
                    {"group", p.group},
                    {"kind", kKinds[static_cast<std::size_t>(p.kind)]},
                    {"value", p.value},
                    {"low", p.low},
                    {"high", p.high},
                    {"scale", p.kind == EditableKind::weight ? "log" : "linear"},
                    {"unit", p.kind == EditableKind::angle ? "deg" : ""},
                    {"locked", p.locked}});
  }
  return list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shigusa
