// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>
#include <vector>

#include "formats/gltf_write.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// Things, fingers and markers beside the motion of a body.
struct MotionExtras {
  std::span<const ThingMotion> things{};  // in the frames of the clip
  HandPlay hands{};
  std::vector<GltfMarker> markers{};
};

// Writer of a body's motions as animations of one GLB.
class GlbExporter {
 public:
  GlbExporter() = default;
  GlbExporter(const GlbExporter&) = delete;
  GlbExporter& operator=(const GlbExporter&) = delete;
  virtual ~GlbExporter() = default;

  // The animation to pass to glb().
  [[nodiscard]] virtual GltfAnimation animation(const PosedBody& body, const Clip& clip,
                                                const std::string& name,
                                                const MotionExtras& extras) const = 0;
  // The GLB file with these animations.
  [[nodiscard]] virtual Result<std::string> glb(
      std::span<const GltfAnimation> animations) const = 0;
};

}  // namespace shigusa
