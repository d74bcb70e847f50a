// SPDX-License-Identifier: MIT
#include <cstdio>
#include <shigusa/draw.hpp>
#include <shigusa/formats.hpp>

// Reads a motion and draws it: the drawing library must have come along with the static library.
int main() {
  const auto motion = shigusa::parse_bvh(R"(HIERARCHY
ROOT hips
{
  OFFSET 0 0 0
  CHANNELS 3 Zrotation Xrotation Yrotation
  End Site
  {
    OFFSET 0 1 0
  }
}
MOTION
Frames: 2
Frame Time: 0.1
0 0 0
0 0 90
)",
                                         "consumer.bvh");
  if (!motion) {
    std::fprintf(stderr, "%s\n", motion.error().to_string().c_str());
    return 1;
  }
  const auto figure = shigusa::draw_strip(*motion, {}, {});
  if (!figure || figure->find("<svg") == std::string::npos) {
    std::fprintf(stderr, "no figure was drawn\n");
    return 1;
  }
  std::printf("drew %zu bytes of SVG\n", figure->size());
  return 0;
}
