// SPDX-License-Identifier: MIT
#include "figures.hpp"

#include <array>
#include <shigusa/criteria.hpp>

#include "core/check.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa::bench {
namespace {

constexpr double kFoot = 0.26;        // m, of a body of kUsualStature
constexpr double kJoltsSeen = 20.0;   // greater ones count as this
constexpr double kSpeedShare = 0.05;  // of its peak: a slower hand counts as still
constexpr std::size_t kSegments = 6;

constexpr std::array kNodes{"upper_leg", "lower_leg", "foot", "upper_arm", "lower_arm", "hand"};
enum Node { leg, knee, ankle, shoulder, elbow, wrist, kNodeCount };

// Joint positions of a body in one frame (m, world).
struct Places {
  std::array<std::array<Vec3d, kNodeCount>, 2> sides;  // left, right
  Vec3d neck{};
  Vec3d head{};

  [[nodiscard]] Vec3d middle(Node node) const { return 0.5 * (sides[0][node] + sides[1][node]); }
};

const BodyNode& node_of(const BodyModel& body, const std::string& name) {
  for (const BodyNode& node : body.nodes()) {
    if (node.name == name) return node;
  }
  SHG_CHECK(false, "the body has all of human's joints");
  return body.nodes().front();
}

std::vector<Places> places_of(const BodyModel& body, const Clip& clip) {
  std::vector<Places> all(static_cast<std::size_t>(clip.frames));
  Kinematics<double> placed(body);
  const auto at = [&](const std::string& name) {
    const BodyNode& node = node_of(body, name);
    return placed.point(node.link, node.point);
  };
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), placed);
    Places& places = all[static_cast<std::size_t>(f)];
    for (std::size_t n = 0; n < kNodeCount; ++n) {
      places.sides[0][n] = at(std::string("left_") + kNodes[n]);
      places.sides[1][n] = at(std::string("right_") + kNodes[n]);
    }
    places.neck = at("neck");
    places.head = at("head");
  }
  return all;
}

double between(const Vec3d& a, const Vec3d& b) {
  return degrees(acos(clamp(dot(a, b) / max(norm(a) * norm(b), 1e-12), -1.0, 1.0)));
}
// Forward lean (deg) of an upward line.
double lean(const Vec3d& line) { return degrees(atan2(line.z, line.y)); }

double trunk_of(const Places& p) { return lean(p.middle(shoulder) - p.middle(leg)); }
double shank_of(const Places& p) { return lean(p.middle(knee) - p.middle(ankle)); }
double thigh_of(const Places& p) { return -lean(p.middle(leg) - p.middle(knee)); }
double bend_of(const Places& p, std::size_t side, Node upper, Node middle, Node lower) {
  const auto& s = p.sides[side];
  return between(s[middle] - s[upper], s[lower] - s[middle]);
}
double knee_of(const Places& p) {
  return 0.5 * (bend_of(p, 0, leg, knee, ankle) + bend_of(p, 1, leg, knee, ankle));
}

// Largest forward deviation of the wrist from the straight line, relative to the line's length.
double bow_of(const std::vector<Places>& all, std::size_t side) {
  const Vec3d from = all.front().sides[side][wrist];
  const Vec3d way = all.back().sides[side][wrist] - from;
  const double square = max(dot(way, way), 1e-12);
  Vec3d farthest{};
  for (const Places& p : all) {
    const Vec3d gone = p.sides[side][wrist] - from;
    const Vec3d off = gone - way * (dot(gone, way) / square);
    if (norm(off) > norm(farthest)) farthest = off;
  }
  return farthest.z / sqrt(square);
}

double peak_of(const std::vector<Places>& all, std::size_t side) {
  std::vector<double> speeds;
  for (std::size_t f = 0; f + 1 < all.size(); ++f) {
    speeds.push_back(norm(all[f + 1].sides[side][wrist] - all[f].sides[side][wrist]));
  }
  std::size_t top = 0;
  for (std::size_t f = 0; f < speeds.size(); ++f) {
    if (speeds[f] > speeds[top]) top = f;
  }
  std::size_t first = 0;
  std::size_t last = speeds.size() - 1;
  while (first < top && speeds[first] < kSpeedShare * speeds[top]) ++first;
  while (last > top && speeds[last] < kSpeedShare * speeds[top]) --last;
  return static_cast<double>(top - first) / static_cast<double>(max(1.0, double(last - first)));
}

using Row = std::array<double, kSegments>;

// Share of the first principal component in the variance of rows.
double first_share(std::vector<Row> rows) {
  Row mean{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < kSegments; ++i) mean[i] += row[i] / double(rows.size());
  }
  std::array<Row, kSegments> cov{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < kSegments; ++i) {
      for (std::size_t j = 0; j < kSegments; ++j)
        cov[i][j] += (row[i] - mean[i]) * (row[j] - mean[j]);
    }
  }
  Row v{1.0, 1.1, 1.2, 1.3, 1.4, 1.5};
  double value = 0.0;
  for (int round = 0; round < 100; ++round) {
    Row next{};
    for (std::size_t i = 0; i < kSegments; ++i) {
      for (std::size_t j = 0; j < kSegments; ++j) next[i] += cov[i][j] * v[j];
    }
    double square = 0.0;
    for (const double x : next) square += x * x;
    value = sqrt(square);
    for (std::size_t i = 0; i < kSegments; ++i) v[i] = next[i] / max(value, 1e-12);
  }
  double total = 0.0;
  for (std::size_t i = 0; i < kSegments; ++i) total += cov[i][i];
  return value / max(total, 1e-12);
}

double first_component(const std::vector<Places>& all, std::size_t side) {
  const auto hanging = [](const Vec3d& line) { return degrees(atan2(line.z, -line.y)); };
  std::vector<Row> rows;
  for (const Places& p : all) {
    const auto& s = p.sides[side];
    rows.push_back({shank_of(p), thigh_of(p), trunk_of(p), hanging(s[elbow] - s[shoulder]),
                    hanging(s[wrist] - s[elbow]), lean(p.head - p.neck)});
  }
  return first_share(std::move(rows));
}

// Total change (deg) of these degrees of freedom from the first frame to another.
double turned(const BodyModel& body, const Clip& clip, std::initializer_list<const char*> names,
              int frame) {
  double sum = 0.0;
  for (const char* name : names) {
    const auto found = body.find_dof(name);
    if (!found) continue;
    const auto d = static_cast<std::size_t>(*found);
    sum += degrees(clip.frame(frame)[d] - clip.frame(0)[d]);
  }
  return sum;
}

void read_back(const BodyModel& body, const Clip& clip, Figures& figures) {
  const auto lumbar = [&](int f) {
    return turned(body, clip, {"spine.flexion", "chest.flexion"}, f);
  };
  const auto hip = [&](int f) {
    return 0.5 * turned(body, clip, {"right_hip.flexion", "left_hip.flexion"}, f);
  };
  const int end = clip.frames - 1;
  const int third = clip.frames / 3;
  figures.lumbar = lumbar(end);
  figures.hip = hip(end);
  figures.lumbar_share = lumbar(end) / max(lumbar(end) + hip(end), 1.0);
  figures.lumbar_lead = lumbar(third) / max(hip(third), 0.5) - lumbar(end) / max(hip(end), 1.0);
}

// Greatest change of a torque or of the floor's pressure between frames, in jolts.
double jolt_of(const BodyModel& body, const Motion& motion) {
  CriteriaSettings settings{{CriterionKind::jolts, 1.0}};
  settings[CriterionKind::jolts].scale = kJoltsSeen;
  return kJoltsSeen * sqrt(sqrt(score_motion(body, motion, settings).total));
}

void read_posture(const Places& a, const Places& b, double scale, Figures& figures) {
  figures.trunk = trunk_of(b);
  figures.knee = knee_of(b);
  figures.knee_change = knee_of(b) - knee_of(a);
  figures.shank = shank_of(b);
  const Vec3d hips = (b.middle(leg) - a.middle(leg)) * scale;
  figures.drop = -hips.y;
  figures.back = -hips.z;
  figures.travel = norm(hips);
  const double down = (a.middle(shoulder).y - b.middle(shoulder).y) * scale;
  figures.style = down > 0.05 ? 100.0 * (1.0 - figures.drop / down) : 50.0;
  const double others =
      shank_of(b) - shank_of(a) + trunk_of(b) + thigh_of(b) - trunk_of(a) - thigh_of(a);
  figures.index = figures.knee_change / max(others, 1.0);
  figures.head = (b.head.y - b.middle(leg).y) * scale;
}

}  // namespace

Figures figures_of(const BodyModel& body, const Motion& motion, Side side) {
  const std::size_t s = side == Side::left ? 0 : 1;
  const std::vector<Places> all = places_of(body, motion.clip);
  const double scale = kUsualStature / body.stature();
  const Places& a = all.front();
  const Places& b = all.back();
  Figures figures;
  read_posture(a, b, scale, figures);
  figures.bow = bow_of(all, s);
  figures.peak = peak_of(all, s);
  const double ahead = b.sides[s][wrist].z - a.sides[s][wrist].z;
  figures.shoulder = (b.sides[s][shoulder].z - a.sides[s][shoulder].z) / max(ahead, 0.05);
  figures.first = first_component(all, s);
  figures.free_elbow = bend_of(b, 1 - s, shoulder, elbow, wrist);
  const Vec3d trunk = b.middle(leg) - b.middle(shoulder);
  const double raised = between(b.sides[s][elbow] - b.sides[s][shoulder], trunk);
  const char* clavicle = s == 0 ? "left_clavicle.elevation" : "right_clavicle.elevation";
  figures.clavicle =
      turned(body, motion.clip, {clavicle}, motion.clip.frames - 1) / max(raised, 1.0);
  read_back(body, motion.clip, figures);
  if (motion.torques.empty()) return figures;
  figures.mass = (motion.centre_of_mass.back().z - motion.centre_of_mass.front().z) * scale / kFoot;
  figures.jolt = jolt_of(body, motion);
  return figures;
}

}  // namespace shigusa::bench
