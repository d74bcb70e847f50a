// SPDX-License-Identifier: MIT
// How the clavicles of a reduced body go with their arms.
#include "core/index.hpp"
#include "layers/reduced_motion.hpp"

namespace shigusa {
void ReducedRollout::add_clavicle(const ReducedLimb& limb) {
  const bool by_law = problem_->posture_law && problem_->body->find_dof("neck.flexion");
  if (!by_law || limb.elevation < 0 || limb.protraction < 0) return;
  const auto shrug = shrugged(limb.slide, limb.elevation);
  clavicles_.push_back(
      {.slide = limb.slide,
       .elevation = limb.elevation,
       .protraction = limb.protraction,
       .elevation_start = body_->dofs[index(limb.elevation)].start - shrug.elevation,
       .protraction_start = body_->dofs[index(limb.protraction)].start - shrug.protraction});
}

// what the clavicle is drawn to by the line of its arm
PostureLaw<double>::Shrug<double> ReducedRollout::shrugged(int slide, int elevation) const {
  const int chest = body_->dofs[index(elevation)].parent;
  const Mat3d& carrier = chest < 0 ? body_->base.rotation : placed_.rotation[index(chest)];
  return PostureLaw<double>::shrugged(transpose_times(carrier, placed_.axis[index(slide)]));
}

void ReducedRollout::draw_clavicles() {
  for (const Clavicle& clavicle : clavicles_) {
    const auto shrug = shrugged(clavicle.slide, clavicle.elevation);
    const auto draw = [&](int dof, double wanted) {
      const ReducedDof& of = body_->dofs[index(dof)];
      reference_[index(dof)] = clamp(wanted, of.lower, of.upper) - q_[index(dof)];
    };
    draw(clavicle.elevation, clavicle.elevation_start + shrug.elevation);
    draw(clavicle.protraction, clavicle.protraction_start + shrug.protraction);
  }
}

}  // namespace shigusa
