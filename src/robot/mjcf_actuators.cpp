// SPDX-License-Identifier: MIT
#include "mjcf_actuators.hpp"

namespace shigusa {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double farther(const std::array<double, 2>& ends) { return max(abs(ends[0]), abs(ends[1])); }

}  // namespace

MjcfActuators::MjcfActuators(MjcfFiles& files, MjcfValues& values) : values_(values) {
  if (files.root() == nullptr) return;
  files.each(*files.root(), [&](const XmlElement& section) {
    if (std::string_view(section.Name()) != "actuator") return;
    files.each(section, [&](const XmlElement& e) { read({e, {}}); });
  });
}

void MjcfActuators::read(const MjcfPart& part) {
  std::string_view joint = values_.word(part, "joint");
  if (joint.empty()) joint = values_.word(part, "jointinparent");
  if (joint.empty()) return;
  std::array<double, 6> gear{1.0};
  values_.numbers(part, "gear", gear, 1);
  double force = kInfinity;
  if (const auto ends = values_.range(part, "forcerange", "forcelimited")) force = farther(*ends);
  const std::string_view tag = part.element.Name();
  const std::string_view bias = values_.word(part, "biastype");
  const std::string_view gain_type = values_.word(part, "gaintype");
  const bool plain =
      (bias.empty() || bias == "none") && (gain_type.empty() || gain_type == "fixed");
  if (tag == "motor" || (tag == "general" && plain)) {
    std::array<double, 10> gain{1.0};
    if (tag == "general") values_.numbers(part, "gainprm", gain, 1);
    if (const auto ends = values_.range(part, "ctrlrange", "ctrllimited")) {
      force = min(force, abs(gain[0]) * farther(*ends));
    }
  }
  std::array<double, 3>& sum = sums_[std::string(joint)];
  for (std::size_t k = 0; k < 3; ++k) {
    if (gear[k] != 0.0) sum[k] += abs(gear[k]) * force;
  }
}

double MjcfActuators::effort(const std::string& joint, const MjcfPart& part, std::size_t axis) {
  const auto found = sums_.find(joint);
  double effort = found == sums_.end() ? 0.0 : found->second[axis];
  if (const auto ends = values_.range(part, "actuatorfrcrange", "actuatorfrclimited")) {
    effort = effort > 0.0 ? min(effort, farther(*ends)) : farther(*ends);
  }
  return effort <= kMjcfMaxValue ? effort : 0.0;
}

}  // namespace shigusa
