// SPDX-License-Identifier: MIT
#include "limb_fit.hpp"

#include <algorithm>
#include <utility>

#include "person_measurer.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kFewestSectors = 4;
constexpr double kEnds = 0.1;       // share of a limb at either end that is deformed by its
                                    // neighbours
constexpr std::size_t kSlices = 4;  // number of slices of a limb between its ends
constexpr double kSlice = (1.0 - 2.0 * kEnds) / static_cast<double>(kSlices);
constexpr double kThickest = 0.75;     // a limb's radius, as a share of its length
constexpr double kThickestFist = 1.2;  // a fist's radius, as a share of the hand's length
constexpr double kRises = 0.95;        // share of a limb's vertices within its end
constexpr double kRisesMost = 1.0;     // most extension before the joint, of a limb's length
constexpr double kShortest = 0.3;      // least length of a hand's shape (a fist), of the hand's
                                       // length
constexpr double kLongest = 1.3;       // greatest length of a hand's shape, of the hand's length
constexpr double kBroader = 1.3;       // least ratio of breadth to thickness of a flat limb

// Least-squares line through some points.
class Line {
 public:
  explicit Line(const std::vector<std::pair<double, double>>& points) {
    for (const auto& [x, y] : points) {
      middle_ += x / static_cast<double>(points.size());
      mean_ += y / static_cast<double>(points.size());
    }
    double squares = 0.0;
    for (const auto& [x, y] : points) {
      slope_ += (x - middle_) * (y - mean_);
      squares += (x - middle_) * (x - middle_);
    }
    slope_ /= max(squares, 1e-12);
  }
  [[nodiscard]] double at(double x) const { return mean_ + slope_ * (x - middle_); }

 private:
  double middle_ = 0.0;
  double mean_ = 0.0;
  double slope_ = 0.0;
};

// Tapers a limb's shape, if slices show that one end is thicker.
void taper(const std::vector<Vec3d>& points, double thickest, double length, PartShape& shape) {
  std::vector<std::pair<double, double>> radii;  // height of a slice's middle, radius
  for (std::size_t k = 0; k < kSlices; ++k) {
    const double top = -length * (kEnds + static_cast<double>(k) * kSlice);
    const auto column = round_column(between(points, top - kSlice * length, top), thickest);
    if (column) radii.emplace_back(top - 0.5 * kSlice * length, column->radius);
  }
  if (radii.size() < 2) return;
  const Line line(radii);
  const auto [thin, thick] = std::minmax_element(
      radii.begin(), radii.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  shape.radius = clamp(line.at(0.0), thin->second, thick->second);
  shape.to_radius = clamp(line.at(-length), thin->second, thick->second);
}

// Length of a hand's axis, whose end is round.
double length_of(const std::vector<Vec3d>& points, double length, double radius) {
  std::vector<double> depths;
  for (const Vec3d& p : points) depths.push_back(-p.y);
  return clamp(quantile(std::move(depths), kRises) - radius, kShortest * length, kLongest * length);
}

// Splits a flat limb's axis in two, side by side along the broadest of four directions.
void flatten(const std::vector<Vec3d>& points, PartShape& shape) {
  const Sectors about(points, shape.from.x, shape.from.z, kInLimb);
  if (about.filled() < kSectors) return;
  const auto half = [&](std::size_t k) {
    return 0.5 * (*about.at(k) + *about.at((k + kSectors / 2) % kSectors));
  };
  std::size_t broadest = 0;
  for (std::size_t k = 1; k < kSectors / 2; ++k) {
    if (half(k) > half(broadest)) broadest = k;
  }
  const double thin = half((broadest + kSectors / 4) % (kSectors / 2));
  const double share = thin / (0.5 * (shape.radius + shape.to_radius));
  if (!(thin > 0.0) || half(broadest) < kBroader * thin) return;
  shape.radius *= share;
  shape.to_radius *= share;
  const SinCos<double> towards = sin_cos(static_cast<double>(broadest) * (kTwoPi / kSectors));
  shape.aside = Vec3d{towards.cos, 0.0, towards.sin} * (half(broadest) - thin);
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

std::vector<Vec3d> between(const std::vector<Vec3d>& points, double low, double high) {
  std::vector<Vec3d> within;
  for (const Vec3d& p : points) {
    if (p.y >= low && p.y <= high) within.push_back(p);
  }
  return within;
}

Sectors::Sectors(const std::vector<Vec3d>& points, double x, double z, double share) {
  std::array<std::vector<double>, kSectors> values;
  for (const Vec3d& p : points) {
    const double turn = atan2(p.z - z, p.x - x) * (kSectors / kTwoPi) + kSectors + 0.5;
    const auto sector = static_cast<std::size_t>(turn) % kSectors;
    values[sector].push_back(sqrt((p.x - x) * (p.x - x) + (p.z - z) * (p.z - z)));
  }
  for (std::size_t s = 0; s < kSectors; ++s) {
    if (values[s].empty()) continue;
    distance_[s] = quantile(std::move(values[s]), share);
    ++filled_;
  }
}

double Sectors::middle() const {
  std::vector<double> known;
  for (const auto& distance : distance_) {
    if (distance) known.push_back(*distance);
  }
  return quantile(std::move(known), 0.5);
}

Vec3d Sectors::off() const {
  Vec3d sum{};
  if (filled_ < kSectors) return sum;
  for (std::size_t s = 0; s < kSectors; ++s) {
    const SinCos<double> towards = sin_cos(static_cast<double>(s) * (kTwoPi / kSectors));
    sum += Vec3d{towards.cos, 0.0, towards.sin} * (*distance_[s] * (2.0 / kSectors));
  }
  return sum;
}

std::optional<PartShape> round_column(const std::vector<Vec3d>& points, double thickest) {
  if (points.size() < kFewestVertices) return std::nullopt;
  Sectors about(points, 0.0, 0.0, kInLimb);
  if (about.filled() < kFewestSectors) return std::nullopt;
  const double rough = min(about.middle(), thickest);
  Vec3d centre = about.off();
  // the bone lies within its limb
  centre = centre * min(1.0, 0.5 * rough / max(norm(centre), 1e-9));
  about = Sectors(points, centre.x, centre.z, kInLimb);
  if (about.filled() < kFewestSectors) return std::nullopt;
  const double radius = clamp(about.middle(), kThinnest, max(thickest, kThinnest));
  return PartShape{centre, centre, radius};
}

std::optional<PartShape> fit_limb(const LimbPoints& limb, double room) {
  const double length = limb.length;
  std::vector<Vec3d> points = between(limb.points, (kEnds - 1.0) * length, -kEnds * length);
  // a coarse limb has vertices only at its ends
  if (points.size() < kFewestVertices)
    points = between(limb.points, -(1.0 + kEnds) * length, kEnds * length);
  const double thickest = min((limb.hand ? kThickestFist : kThickest) * length, room);
  const auto column = round_column(points, thickest);
  if (!column) return std::nullopt;
  PartShape shape{{column->from.x, 0.0, column->from.z},
                  {column->from.x, -length, column->from.z},
                  column->radius};
  taper(points, thickest, length, shape);
  if (limb.hand) {
    flatten(points, shape);
    shape.to.y = -length_of(limb.points, length, shape.to_radius);
  }
  if (limb.rises) {
    std::vector<double> heights;
    for (const Vec3d& p : limb.points) heights.push_back(p.y);
    shape.from.y =
        clamp(quantile(std::move(heights), kRises) - shape.radius, 0.0, kRisesMost * length);
  }
  return shape;
}

}  // namespace shigusa
