// SPDX-License-Identifier: MIT
#include "mirror_request.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "body/joint_name.hpp"
#include "problem/request_fields.hpp"

namespace shigusa {
namespace {

// Whether a posture mode changes its sign in the mirror.
bool turns(std::string_view name) { return name.starts_with("twist"); }

Quatd across(const Quatd& q) { return {q.x, -q.y, -q.z, q.w}; }

// The mirrored assignment: "right_elbow.weight=3" for "left_elbow.weight=3", "twist_deg=-20" for
// "twist_deg=20".
std::string mirrored_assignment(const std::string& assignment) {
  std::string text = with_other_side(assignment);
  const std::size_t equals = text.find('=');
  if (!turns(text) || equals == text.npos) return text;
  const bool negative = equals + 1 < text.size() && text[equals + 1] == '-';
  return negative ? text.erase(equals + 1, 1) : text.insert(equals + 1, "-");
}

template <class Holder>
void mirror_fields(Holder& holder);

// Choices have no side.
template <class Value>
void mirror_value(Value&, Mirroring) {}
void mirror_value(double& angle, Mirroring how) {
  if (how == Mirroring::turn) angle = 0.0 - angle;
}
void mirror_value(Vec3d& point, Mirroring) { point = across(point); }
void mirror_value(Quatd& rotation, Mirroring) { rotation = across(rotation); }
void mirror_value(Stance& stance, Mirroring) {
  stance.x = -stance.x;
  mirror_fields(stance);
}
void mirror_value(std::string& text, Mirroring how) {
  text = how == Mirroring::assignments ? mirrored_assignment(text) : with_other_side(text);
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

}  // namespace

void mirror_request(Request& request) { mirror_fields<Request>(request); }

Parameters mirrored_values(const ParameterList& from, const ParameterList& to,
                           const Parameters& values) {
  Parameters image = to.start();
  image.posed = values.posed;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const ParameterInfo& info = from.all[i];
    const auto other = std::find_if(to.all.begin(), to.all.end(), [&](const ParameterInfo& known) {
      return known.kind == info.kind && known.name == with_other_side(info.name) &&
             known.layer == with_other_side(info.layer);
    });
    if (other == to.all.end()) continue;
    const auto k = static_cast<std::size_t>(other - to.all.begin());
    image.values[k] = turns(info.name) ? -values.values[i] : values.values[i];
    image.locked[k] = values.locked[i];
  }
  return image;
}

}  // namespace shigusa
