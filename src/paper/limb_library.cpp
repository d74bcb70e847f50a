// SPDX-License-Identifier: MIT
#include "paper/limb_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/bytes.hpp"
#include "core/check.hpp"
#include "core/hash.hpp"
#include "core/index.hpp"
#include "plan/layer.hpp"
#include "rollout/detour.hpp"

namespace shigusa {
namespace {

// To be changed whenever the same body and settings would give other cells or another text.
constexpr std::uint32_t kVersion = 1;
constexpr std::string_view kMagic = "shigusa-limbs\n";
// Share by which a path around the shoulder may fall below the least radius.
constexpr double kShoulderSlack = 0.05;
// Increment (m) of the detour until the path is far enough out.
constexpr double kDetourStep = 0.01;

std::uint64_t hash_of(const PosedBody& posed, const LimbLibrarySettings& settings) {
  const BodyModel& arm = posed.body;
  Fnv1a hash;
  const auto add = [&hash](const Vec3d& v) {
    for (int k = 0; k < 3; ++k) hash.add(v[k]);
  };
  hash.add(std::uint64_t{kVersion});
  hash.add(static_cast<std::uint64_t>(settings.search));
  for (const CriterionSetting& setting : settings.criteria.built_in) {
    hash.add(setting.weight);
    hash.add(setting.scale);
  }
  for (int d = 0; d < arm.dof_count(); ++d) {
    const Dof& dof = arm.dof(d);
    add(dof.offset);
    hash.add(static_cast<std::uint64_t>(dof.axis));
    for (const double x : {dof.sign, dof.lower, dof.upper, dof.torque_positive, dof.torque_negative,
                           posed.home.angles[index(d)], arm.link_mass(d).mass}) {
      hash.add(x);
    }
    const MassProperties& mass = arm.link_mass(d);
    for (const Vec3d& v : {mass.com, mass.inertia.cx, mass.inertia.cy, mass.inertia.cz}) {
      add(v);
    }
  }
  add(arm.effectors()[0].point);
  return hash.value();
}

// Packs the genes into four bits each, the first one lowest.
std::uint16_t code_of(const ArmGenes& genes) {
  unsigned code = 0;
  for (std::size_t k = 0; k < genes.size(); ++k) code |= static_cast<unsigned>(genes[k]) << (4 * k);
  return static_cast<std::uint16_t>(code);
}

ArmGenes genes_of(std::uint16_t code) {
  ArmGenes genes{};
  for (std::size_t k = 0; k < genes.size(); ++k) {
    genes[k] = static_cast<std::uint8_t>((code >> (4 * k)) & 0xF);
  }
  return genes;
}

// Removes an integer from the front.
template <class T>
T take_off(std::string_view& from) {
  const T x = integer_at<T>(from, 0);
  from.remove_prefix(sizeof x);
  return x;
}

// Least radius (m) of a path's frames about the shoulder.
double nearest_radius(const EffectorPath& path) {
  double least = norm(path.start);
  for (int f = 1; f <= kMotionSteps; ++f) {
    least = min(least, norm(path.at(static_cast<double>(f) / kMotionSteps)));
  }
  return least;
}

// Time (0..1) at which a minimum-jerk motion has covered that share of its path.
double time_of(double share) {
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < 30; ++k) {
    const double middle = 0.5 * (low + high);
    (minimum_jerk(middle) < share ? low : high) = middle;
  }
  return low;
}

constexpr std::size_t kCellBytes = 2 + 2 + 4;  // number, genes, score
constexpr std::size_t kHeaderBytes = kMagic.size() + 4 + 8 + 4;

}  // namespace

LimbLibrary::LimbLibrary(const PosedBody& arm, const LimbLibrarySettings& settings)
    : arm_(arm.body),
      home_(arm.home),
      settings_(settings),
      hash_(hash_of(arm, settings)),
      cells_(index(kLimbCells)) {
  SHG_CHECK(arm_.dof_count() == kArmDofs, "an arm has four freedoms");
  SHG_CHECK(settings.criteria.user.empty(), "a library is scored by built-in criteria");
  const Effector& hand = arm_.effectors()[0];
  const Dof& elbow = arm_.dof(kArmDofs - 1);
  const HingedLimb segments(elbow.offset, hand.point, elbow.sign);
  const double plane = segments.length(kLeastBend);
  longest_ = sqrt(plane * plane + segments.across() * segments.across());
  const Kinematics<double> placed = shigusa::placed(arm_, home_);
  hanging_ = placed.point(hand.link, hand.point);
}

int LimbLibrary::cell_of(const Vec3d& hand) const {
  const double level = sqrt(hand.x * hand.x + hand.z * hand.z);
  const auto part = [](double x, double step, int count) {
    return std::clamp(static_cast<int>(x / step), 0, count - 1);
  };
  const int azimuth = part(atan2(hand.x, hand.z) + kPi, kLimbAngle, kLimbAzimuths);
  const int elevation = part(atan2(hand.y, level) + 0.5 * kPi, kLimbAngle, kLimbElevations);
  // radii are goals themselves, so the nearest counts
  const double step = (1.0 - kLimbRadiusMin) / (kLimbRadii - 1);
  const int radius = part(norm(hand) / longest_ - kLimbRadiusMin + 0.5 * step, step, kLimbRadii);
  return (radius * kLimbElevations + elevation) * kLimbAzimuths + azimuth;
}

Vec3d LimbLibrary::goal_of(int cell) const {
  SHG_CHECK(cell >= 0 && cell < kLimbCells, "a cell of the grid");
  const int azimuth = cell % kLimbAzimuths;
  const int elevation = cell / kLimbAzimuths % kLimbElevations;
  const int radius = cell / (kLimbAzimuths * kLimbElevations);
  const double step = (1.0 - kLimbRadiusMin) / (kLimbRadii - 1);
  const SinCos<double> a = sin_cos((azimuth + 0.5) * kLimbAngle - kPi);
  const SinCos<double> e = sin_cos((elevation + 0.5) * kLimbAngle - 0.5 * kPi);
  return Vec3d{e.cos * a.sin, e.sin, e.cos * a.cos} * (longest_ * (kLimbRadiusMin + step * radius));
}

EffectorPath LimbLibrary::path_to(int cell) const {
  EffectorPath path{.start = hanging_, .goal = goal_of(cell)};
  const double least = kLimbRadiusMin * longest_ * (1.0 - kShoulderSlack);
  if (nearest_radius(path) >= least) return path;
  const Vec3d line = path.goal - path.start;
  const double share = clamp(-dot(path.start, line) / max(dot(line, line), 1e-12), 0.0, 1.0);
  const Vec3d nearest = path.start + line * share;
  path.detour_peak = clamp(time_of(share), kDetourMargin, 1.0 - kDetourMargin);
  // from the shoulder's own centre a path leaves forwards
  const Vec3d out = normalized(nearest, {0, 0, 1});
  // a detour decreases away from its peak, so it must exceed the gap
  for (double more = 0.0; more < longest_ && nearest_radius(path) < least; more += kDetourStep) {
    path.detour = out * (least - norm(nearest) + more);
  }
  return path;
}

ArmGenes LimbLibrary::genes(int cell) {
  build(cell);
  return cells_[index(cell)].genes;
}

double LimbLibrary::score(int cell) {
  build(cell);
  return static_cast<double>(cells_[index(cell)].score);
}

void LimbLibrary::build_all() {
  for (int cell = 0; cell < kLimbCells; ++cell) build(cell);
}

void LimbLibrary::build(int cell) {
  SHG_CHECK(cell >= 0 && cell < kLimbCells, "a cell of the grid");
  Cell& entry = cells_[index(cell)];
  if (entry.built) return;
  ReachProblem problem;
  problem.body = &arm_;
  problem.context.start = home_;
  problem.goals = {{0, path_to(cell)}};
  problem.duration = reach_duration(norm(goal_of(cell) - hanging_), false);
  BatchRollout batch(problem, settings_.criteria, settings_.batch);
  const double worst = worst_score(settings_.criteria);
  const std::optional<FoundArm> found = search_arm(
      settings_.search, worst, [&](std::span<const ArmGenes> genomes, std::span<double> scores) {
        std::vector<float> inverse;
        for (const ArmGenes& genes : genomes) {
          for (const std::uint8_t gene : genes) {
            inverse.push_back(gene == 0 ? 0.0F : 1.0F / static_cast<float>(gene));
          }
        }
        batch.score(inverse, scores);
      });
  entry.built = true;
  entry.score = static_cast<float>(found ? found->score : worst);
  if (found) entry.genes = found->genes;
  ++built_;
}

// "shigusa-limbs
// ", version, hash, count of cells; cells; check sum: all numbers little-endian.
std::string LimbLibrary::bytes() const {
  std::string text(kMagic);
  append_bytes(text, kVersion);
  append_bytes(text, hash_);
  append_bytes(text, static_cast<std::uint32_t>(built_));
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    if (!cells_[c].built) continue;
    append_bytes(text, static_cast<std::uint16_t>(c));
    append_bytes(text, code_of(cells_[c].genes));
    append_bytes(text, __builtin_bit_cast(std::uint32_t, cells_[c].score));
  }
  Fnv1a sum;
  sum.add(text);
  append_bytes(text, sum.value());
  return text;
}

bool LimbLibrary::take(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes + 8 || bytes.substr(0, kMagic.size()) != kMagic) return false;
  std::string_view rest = bytes.substr(kMagic.size());
  if (take_off<std::uint32_t>(rest) != kVersion || take_off<std::uint64_t>(rest) != hash_)
    return false;
  const auto count = take_off<std::uint32_t>(rest);
  if (count > kLimbCells || rest.size() != count * kCellBytes + 8) return false;
  Fnv1a sum;
  sum.add(bytes.substr(0, bytes.size() - 8));
  std::string_view stored = bytes.substr(bytes.size() - 8);
  if (take_off<std::uint64_t>(stored) != sum.value()) return false;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto number = take_off<std::uint16_t>(rest);
    const auto code = take_off<std::uint16_t>(rest);
    const auto score = __builtin_bit_cast(float, take_off<std::uint32_t>(rest));
    if (number >= kLimbCells || cells_[number].built) continue;
    cells_[number] = {true, genes_of(code), score};
    ++built_;
  }
  return true;
}

std::string limb_file_name(const std::string& arm, std::uint64_t hash) {
  return fmt::format("{}-{:016x}.limb", arm, hash);
}

}  // namespace shigusa
