// SPDX-License-Identifier: MIT
// Judges of the torques and masses of every frame: heels, torques, pressure.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "body_pieces.hpp"
#include "judged.hpp"

namespace shigusa::bench {
namespace {

constexpr double kStrained = 1.02;    // of a joint's strength
constexpr double kBeyondMotor = 1.0;  // of a robot's, which its file states exactly
constexpr double kNobodys = 1.5;      // of a person's
constexpr double kTipping = 0.01;     // m, outside the feet
constexpr double kFalling = 0.05;     // m
constexpr double kOfSwing = 0.2;      // share of the uncertain changes between frames
constexpr double kInJolts = 0.4;      // of a difference, in motions that jolt
constexpr double kHeelFlat = 0.002;   // m: less is no lifted heel

// Torque columns of a motion by joint, with the body's strengths.
struct Column {
  std::string name;
  const Dof* dof;
  double sign;
};
std::vector<Column> torque_columns(const Judged& judged) {
  std::vector<Column> columns;
  const BodyModel& body = judged.task.body;
  if (!judged.task.robot) {
    for (const Dof& dof : body.dofs()) columns.push_back({dof.name, &dof, 1.0});
    return columns;
  }
  for (const RobotJoint& joint : judged.task.robot->joints) {
    if (joint.dof >= 0) columns.push_back({joint.name, &body.dof(joint.dof), joint.sign});
  }
  return columns;
}

double share_of(const Column& column, double torque) {
  const double own = column.sign * torque;
  return own > 0.0 ? own / column.dof->torque_positive : -own / column.dof->torque_negative;
}

void require_verdict(const Judged& judged, double share, const char* of, Audit& audit) {
  const Verdict verdict = judged.candidate.judgement.verdict;
  const bool motor = judged.robot != nullptr;
  const double nobodys = motor ? kBeyondMotor : kNobodys;
  const double strained = motor ? kBeyondMotor : kStrained;
  audit.require(
      share <= nobodys || verdict == Verdict::impossible,
      fmt::format("{} times a joint's strength, {}, is not told as impossible", nobodys, of));
  audit.require(share <= strained || verdict != Verdict::possible,
                fmt::format("{} times a joint's strength, {}, is told as possible", strained, of));
}

MovingBody moving_body(const Judged& judged, const PlacedLinks* links) {
  if (judged.robot == nullptr) {
    return pieces_of(judged.task.body, *links, judged.task, judged.candidate);
  }
  std::vector<std::string> feet;
  for (const ContactResult& foot : judged.candidate.contacts) feet.push_back(foot.node);
  return judged.robot->pieces(judged.task.robot->root, judged.links, feet,
                              judged.candidate.motion.clip.frame_time);
}

bool has_load(const Task& task) {
  return std::any_of(task.goals.begin(), task.goals.end(),
                     [](const Goal& goal) { return goal.load > 0.0; });
}

// Minimum and maximum over a frame and its two neighbours.
std::pair<double, double> range_about(const std::vector<double>& values, std::size_t frame) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(frame > 0 ? frame - 1 : 0);
  const auto last =
      values.begin() + static_cast<std::ptrdiff_t>(std::min(frame + 2, values.size()));
  const auto [least, most] = std::minmax_element(first, last);
  return {*least, *most};
}
double swing_about(const std::vector<double>& values, std::size_t frame) {
  const auto [least, most] = range_about(values, frame);
  return most - least;
}

// Deviation of a torque from those of the frame and its neighbours, as a share of the joint's
// strength and of twice their range: at a jolt, two methods of differentiation differ by as much.
double torque_off(const std::vector<double>& own, std::size_t frame, double told, double strength) {
  const auto [least, most] = range_about(own, frame);
  return std::fmax(least - told, told - most) / (strength + 2.0 * (most - least));
}

void judge_torques(const Judged& judged, const MovingBody& moving,
                   const std::vector<Wrench>& wrenches, Audit& audit) {
  ++audit.torques;
  const bool jolts = judged.candidate.measures.sudden.jolts();
  double share = 0.0;
  for (const Column& column : torque_columns(judged)) {
    const auto hinge = std::find_if(moving.hinges.begin(), moving.hinges.end(),
                                    [&](const MovingHinge& h) { return h.name == column.name; });
    if (hinge == moving.hinges.end()) continue;
    const std::vector<double> own = hinge_torque(moving, wrenches, *hinge);
    const std::vector<double>& told = judged.table.column(column.name + " torque [N m]");
    for (std::size_t f = 0; f < own.size(); ++f) {
      const double strength = std::fmin(column.dof->torque_positive, column.dof->torque_negative);
      double off = torque_off(own, f, told[f], strength);
      // angles and torques of a joint that passes gimbal lock oscillate, while its limb does not
      if (jolts) off = kInJolts * std::fmin(off, torque_off(told, f, own[f], strength));
      audit.most(Promise::torque, off, column.name);
      share =
          std::fmax(share, share_of(column, own[f]) - kOfSwing * swing_about(own, f) / strength);
    }
  }
  require_verdict(judged, share / (1.0 + kTorqueDiffers), "by mass and motion", audit);
}

// Convex hull of points on the floor (x, z as x, y), counter-clockwise.
std::vector<Vec3d> hull_of(std::vector<Vec3d> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.z < b.z; });
  std::vector<Vec3d> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const Vec3d& p : points) {
      while (hull.size() >= first + 2) {
        const Vec3d a = hull[hull.size() - 1] - hull[hull.size() - 2];
        const Vec3d b = p - hull[hull.size() - 1];
        if (a.x * b.z - a.z * b.x > 0.0) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// m, signed distance of a point on the floor outside the hull, negative inside
double outside_of(const std::vector<Vec3d>& hull, const Vec3d& point) {
  double most = -1e9;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec3d edge = hull[(k + 1) % hull.size()] - hull[k];
    const Vec3d out{edge.z, 0.0, -edge.x};
    const double length = std::sqrt(out.x * out.x + out.z * out.z);
    if (length < 1e-9) continue;
    most =
        std::fmax(most, (out.x * (point.x - hull[k].x) + out.z * (point.z - hull[k].z)) / length);
  }
  return most;
}

// Required centre of pressure, from the moments of all pieces, against the soles of the first
// frame.
void judge_pressure(const Judged& judged, const PlacedLinks& links, const MovingBody& moving,
                    const std::vector<Wrench>& wrenches, Audit& audit) {
  std::vector<Vec3d> soles;
  for (const Foot& foot : judged.task.body.feet()) {
    for (const Vec3d& corner : foot.outline) soles.push_back(links.at(foot.link, 0) * corner);
  }
  if (soles.size() < 3) return;
  const std::vector<Vec3d> hull = hull_of(soles);
  double weight = 0.0;
  for (const MovingPiece& piece : moving.pieces) weight += 9.80665 * piece.mass;
  std::vector<double> outside;
  for (const Wrench& floor : floor_wrenches(moving, wrenches)) {
    const double up = std::fmax(floor.force.y, 0.5 * weight);
    const Vec3d at{floor.moment.z / up, 0.0, -floor.moment.x / up};
    outside.push_back(outside_of(hull, at) * up / weight);
  }
  double most = -1e9;
  for (std::size_t f = 0; f < outside.size(); ++f) {
    most = std::fmax(most, outside[f] - kOfSwing * swing_about(outside, f));
  }
  const Verdict verdict = judged.candidate.judgement.verdict;
  audit.require(most <= kFalling + kPressureDiffers || verdict == Verdict::impossible,
                fmt::format("the floor presses {:.0f} mm outside the feet, not told as impossible",
                            1e3 * most));
  audit.require(
      most <= kTipping + kPressureDiffers || verdict != Verdict::possible,
      fmt::format("the floor presses {:.0f} mm outside the feet, told as possible", 1e3 * most));
}

// Link behind the toes' joint, with the rear end of the sole in its frame: the foot's own link is
// the forefoot, whose frame is parallel to it with the heel down.
std::pair<int, Vec3d> heel_in_its_link(const BodyModel& body, const Foot& foot) {
  const Dof& toes = body.dof(foot.heel->toes);
  if (foot.link == kBaseLink) return {foot.heel->toes, foot.heel->back - toes.offset};
  return {toes.parent, foot.heel->back + toes.offset};
}

// Compares lifted heels with the reported heights.
bool judge_heels(const Judged& judged, const PlacedLinks& links, Audit& audit) {
  bool lifted = false;
  const auto& feet = judged.task.body.feet();
  for (const ContactResult& told : judged.candidate.contacts) {
    const auto foot = std::find_if(feet.begin(), feet.end(),
                                   [&](const Foot& f) { return f.name == told.effector; });
    if (!told.heel || foot == feet.end() || !foot->heel) continue;
    const auto [link, back] = heel_in_its_link(judged.task.body, *foot);
    double most = 0.0;
    const double stood = (links.at(link, 0) * back).y;
    for (int f = 0; f < links.frames(); ++f) {
      most = std::fmax(most, (links.at(link, f) * back).y - stood);
    }
    audit.most(Promise::heel, std::fabs(most - told.heel->height), told.effector);
    lifted = lifted || most > kHeelFlat;
  }
  return lifted;
}

}  // namespace

void judge_verdict(const Judged& judged, Audit& audit) {
  double share = 0.0;
  for (const Column& column : torque_columns(judged)) {
    for (const double torque : judged.table.column(column.name + " torque [N m]")) {
      share = std::fmax(share, share_of(column, torque));
    }
  }
  require_verdict(judged, share * (1.0 - 1e-9), "by the table", audit);
  const Judgement& judgement = judged.candidate.judgement;
  audit.require(judgement.reasons.empty() == (judgement.verdict == Verdict::possible),
                "a verdict without a reason, or a reason without a verdict");
  for (const Reason& reason : judgement.reasons) {
    audit.require(reason.verdict >= judgement.reasons.back().verdict,
                  "reasons are not the worst first");
    audit.require(!reason_words(reason).empty(), "a reason without words");
  }
}

void judge_masses(const Judged& judged, Audit& audit) {
  if (judged.robot != nullptr) {
    // a load is in a hand that the file may not have
    if (has_load(judged.task)) return;
    const MovingBody moving = moving_body(judged, nullptr);
    judge_torques(judged, moving, piece_wrenches(moving), audit);
    return;
  }
  const PlacedLinks links(judged.task.body, judged.table);
  const bool on_toes = judge_heels(judged, links, audit);
  const MovingBody moving = moving_body(judged, &links);
  const std::vector<Wrench> wrenches = piece_wrenches(moving);
  judge_torques(judged, moving, wrenches, audit);
  if (!on_toes && !judged.character.seat) {
    judge_pressure(judged, links, moving, wrenches, audit);
  }
}

}  // namespace shigusa::bench
