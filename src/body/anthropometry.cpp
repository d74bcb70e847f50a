// SPDX-License-Identifier: MIT
#include "body/anthropometry.hpp"

namespace shigusa {
namespace {

constexpr SegmentTable kMale{
    .head = {.0694, .5002, .303, .315, .261},
    .trunk = {.4346, .4310, .384, .358, .197},
    .upper_arm = {.0271, .5772, .285, .269, .158},
    .forearm = {.0162, .4574, .276, .265, .121},
    .hand = {.0061, .3624, .288, .235, .184},
    .thigh = {.1416, .4095, .329, .329, .149},
    .shank = {.0433, .4395, .251, .246, .102},
    .foot = {.0137, .4415, .257, .245, .124},
    .trunk_parts = {{{.1117, 145.7 / 603.3, .615, .551, .587},
                     {.1633, 215.5 / 603.3, .482, .383, .468},
                     {.1596, 242.1 / 603.3, .505, .320, .465}}},
    .mean_stature = 1.741,
    .mean_mass = 73.0,
};

constexpr SegmentTable kFemale{
    .head = {.0668, .4841, .271, .295, .261},
    .trunk = {.4257, .3782, .379, .361, .182},
    .upper_arm = {.0255, .5754, .278, .260, .148},
    .forearm = {.0138, .4559, .261, .257, .094},
    .hand = {.0056, .3427, .244, .208, .154},
    .thigh = {.1478, .3612, .369, .364, .162},
    .shank = {.0481, .4352, .267, .263, .092},
    .foot = {.0129, .4014, .299, .279, .139},
    .trunk_parts = {{{.1247, 181.5 / 614.8, .433, .402, .444},
                     {.1465, 205.3 / 614.8, .433, .354, .415},
                     {.1545, 228.0 / 614.8, .466, .314, .449}}},
    .mean_stature = 1.735,
    .mean_mass = 61.9,
};

}  // namespace

const SegmentTable& segment_table(Sex sex) { return sex == Sex::male ? kMale : kFemale; }

double mean_stature(Sex sex) { return segment_table(sex).mean_stature; }

double default_mass(double stature, Sex sex) {
  const SegmentTable& table = segment_table(sex);
  const double ratio = stature / table.mean_stature;
  return table.mean_mass * ratio * ratio;
}

std::optional<double> stature_percentile(std::string_view name, Sex sex) {
  const bool male = sex == Sex::male;
  if (name == "p5") return male ? 1.647 : 1.528;
  if (name == "p50") return male ? 1.755 : 1.627;
  if (name == "p95") return male ? 1.867 : 1.737;
  return std::nullopt;
}

}  // namespace shigusa
