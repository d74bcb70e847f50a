// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstring>
#include <shigusa/shigusa.hpp>

// Reads a motion and draws it, so the library's dependencies must have been found. The argument is
// the version that the package states.
int main(int count, char** arguments) {
  if (count > 1 && std::strcmp(arguments[1], SHIGUSA_VERSION) != 0) {
    std::fprintf(stderr, "the package is %s, its headers are " SHIGUSA_VERSION "\n", arguments[1]);
    return 1;
  }
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
