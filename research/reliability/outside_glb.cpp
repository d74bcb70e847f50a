// SPDX-License-Identifier: MIT
// An exported GLB as shown by a player: tracks sampled in time, nodes composed with their parents.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "character/character_rig.hpp"
#include "outside.hpp"
#include "support/exported_glb.hpp"

namespace shigusa::bench {
namespace {

using testing_support::ExportedGlb;

// Values of one channel with their times.
struct Track {
  std::vector<double> times;                // s
  std::vector<std::vector<double>> values;  // as many

  [[nodiscard]] std::vector<double> at(double time) const {
    const auto after = std::upper_bound(times.begin(), times.end(), time + 1e-9);
    if (after == times.begin()) return values.front();
    const auto k = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end()) return values.back();
    const double share = (time - times[k]) / (times[k + 1] - times[k]);
    std::vector<double> mixed = values[k];
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      mixed[i] += share * (values[k + 1][i] - mixed[i]);
    }
    return mixed;
  }
};

class GlbPlayer {
 public:
  GlbPlayer(const ExportedGlb& file, const std::string& clip) : json_(file.json()) {
    parents_.assign(json_.at("nodes").size(), -1);
    for (std::size_t i = 0; i < parents_.size(); ++i) {
      for (const int child : json_["nodes"][i].value("children", std::vector<int>())) {
        parents_[static_cast<std::size_t>(child)] = static_cast<int>(i);
      }
    }
    for (const auto& animation : json_.at("animations")) {
      if (animation.value("name", "") == clip) read(file, animation);
    }
  }

  // s, key times of the track with the most keys
  [[nodiscard]] const std::vector<double>& times() const { return times_; }

  [[nodiscard]] Transformd place(int node, double time) const {
    Transformd x = local(node, time);
    for (int p = parents_[static_cast<std::size_t>(node)]; p >= 0;
         p = parents_[static_cast<std::size_t>(p)]) {
      x = local(p, time) * x;
    }
    return x;
  }

 private:
  template <class Json>
  void read(const ExportedGlb& file, const Json& animation) {
    const auto values_of = [&](std::size_t accessor) {
      std::vector<std::vector<double>> values;
      const int count = json_.at("accessors").at(accessor).at("count");
      for (int k = 0; k < count; ++k) values.push_back(file.element(accessor, k));
      return values;
    };
    for (const auto& channel : animation.at("channels")) {
      const auto& target = channel.at("target");
      const auto& sampler =
          animation.at("samplers").at(channel.at("sampler").template get<std::size_t>());
      Track track;
      for (const std::vector<double>& time : values_of(sampler.at("input"))) {
        track.times.push_back(time[0]);
      }
      track.values = values_of(sampler.at("output"));
      if (track.times.size() > times_.size()) times_ = track.times;
      tracks_[{target.at("node").template get<int>(),
               target.at("path").template get<std::string>()}] = std::move(track);
    }
  }

  [[nodiscard]] std::vector<double> value(int node, const char* path, double time,
                                          std::vector<double> usual) const {
    const auto track = tracks_.find({node, path});
    if (track != tracks_.end()) return track->second.at(time);
    return json_["nodes"][static_cast<std::size_t>(node)].value(path, std::move(usual));
  }

  // with its scale
  [[nodiscard]] Transformd local(int node, double time) const {
    const auto& json = json_["nodes"][static_cast<std::size_t>(node)];
    if (json.contains("matrix")) {
      const std::vector<double> m = json["matrix"];
      return {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}, {m[12], m[13], m[14]}};
    }
    const std::vector<double> t = value(node, "translation", time, {0, 0, 0});
    const std::vector<double> r = value(node, "rotation", time, {0, 0, 0, 1});
    const std::vector<double> s = value(node, "scale", time, {1, 1, 1});
    const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    const Mat3d turn = to_matrix(Quatd{r[0] / length, r[1] / length, r[2] / length, r[3] / length});
    return {{turn.cx * s[0], turn.cy * s[1], turn.cz * s[2]}, {t[0], t[1], t[2]}};
  }

  const nlohmann::ordered_json& json_;
  std::vector<int> parents_;
  std::map<std::pair<int, std::string>, Track> tracks_;
  std::vector<double> times_;
};

// Rotation of a frame with scale.
Mat3d unscaled(const Mat3d& m) {
  const Vec3d x = normalized(m.cx);
  const Vec3d y = normalized(m.cy - x * dot(x, m.cy));
  const double hand = dot(cross(m.cx, m.cy), m.cz) < 0.0 ? -1.0 : 1.0;
  return {x, y, cross(x, y) * hand};
}

}  // namespace

OutsideMotion motion_of_glb(std::string_view glb, const CharacterSpec& character,
                            const std::vector<std::string>& nodes) {
  const ExportedGlb file(glb);
  const GlbPlayer player(file, "shigusa");
  OutsideMotion motion;
  std::vector<int> in_file;
  for (const std::string& name : nodes) {
    const int index = rig_node(character, name);
    if (index < 0) continue;
    motion.nodes[name] = in_file.size();
    in_file.push_back(character.rig->file_node[static_cast<std::size_t>(index)]);
  }
  for (const double time : player.times()) {
    std::vector<Transformd>& places = motion.places.emplace_back();
    for (const int node : in_file) {
      Transformd place = player.place(node, time);
      place.rotation = unscaled(place.rotation);
      places.push_back(in_our_world(place, character, node_unit(character)));
    }
  }
  return motion;
}

}  // namespace shigusa::bench
