// SPDX-License-Identifier: MIT
#include "criteria.hpp"

#include <algorithm>
#include <memory>
#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace shigusa::door {
namespace {

constexpr std::size_t kMostCriteria = 64;

// The tables of motions as the host gets them; their memory is kept from step to step.
class Tables {
 public:
  shigusa_motions of(std::span<const Motion> motions) {
    const Motion& first = motions.front();
    for (auto* table : {&angles_, &torques_, &centre_, &effectors_}) table->clear();
    for (const Motion& motion : motions) {
      angles_.insert(angles_.end(), motion.clip.angles.begin(), motion.clip.angles.end());
      torques_.insert(torques_.end(), motion.torques.begin(), motion.torques.end());
      for (const Vec3d& place : motion.centre_of_mass) add(place, centre_);
      for (std::size_t k = 0; k < static_cast<std::size_t>(motion.clip.frames); ++k) {
        for (const std::vector<Vec3d>& effector : motion.effectors) add(effector[k], effectors_);
      }
    }
    return {.motions = motions.size(),
            .frames = static_cast<std::size_t>(first.clip.frames),
            .dofs = static_cast<std::size_t>(first.clip.dofs),
            .effectors = first.effectors.size(),
            .frame_time = first.clip.frame_time,
            .angles = angles_.data(),
            .torques = torques_.data(),
            .centre_of_mass = centre_.data(),
            .effector_places = effectors_.data()};
  }

 private:
  static void add(const Vec3d& place, std::vector<double>& table) {
    table.insert(table.end(), {place.x, place.y, place.z});
  }

  std::vector<double> angles_;
  std::vector<double> torques_;
  std::vector<double> centre_;
  std::vector<double> effectors_;
};

Result<void> check(const shigusa_criterion& criterion, const CriteriaSettings& settings) {
  const auto wrong = [](const std::string& what) {
    return fail(ErrorCode::invalid_argument, what, "criteria");
  };
  if (criterion.name == nullptr || *criterion.name == '\0') return wrong("a criterion has no name");
  const std::string name = criterion.name;
  const std::vector<std::string> built_in = criterion_names();
  const auto same = [&name](const UserCriterion& own) { return own.name == name; };
  if (std::find(built_in.begin(), built_in.end(), name) != built_in.end() ||
      std::any_of(settings.user.begin(), settings.user.end(), same)) {
    return wrong("there is a criterion " + name + " already");
  }
  if (criterion.values == nullptr) return wrong("values of " + name + " is null");
  // NaN is refused with the weights and scales of all criteria
  return {};
}

}  // namespace

Result<void> add_criteria(const shigusa_criterion* criteria, std::size_t count, Watched& watched,
                          CriteriaSettings& settings) {
  if (count > kMostCriteria) {
    return fail(ErrorCode::invalid_argument,
                std::to_string(count) + " criteria; allowed are " + std::to_string(kMostCriteria));
  }
  const auto tables = std::make_shared<Tables>();
  for (std::size_t i = 0; i < count; ++i) {
    const shigusa_criterion& given = criteria[i];
    if (const auto checked = check(given, settings); !checked) return checked;
    UserCriterion own{.name = given.name, .weight = given.weight, .scale = given.scale};
    own.values = [given, name = own.name, &watched, tables](
                     const BodyModel&, std::span<const Motion> motions, std::span<double> values) {
      const shigusa_motions shown = tables->of(motions);
      watched.ask([&] {
        const int32_t answer = given.values(given.user, &shown, values.data());
        if (answer == 0) return true;
        throw std::runtime_error("the criterion " + name + " returned " + std::to_string(answer));
      });
    };
    settings.user.push_back(std::move(own));
  }
  return {};
}

}  // namespace shigusa::door
