// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rig/stick_figure.hpp"

namespace shigusa::testing_support {

// Names and hierarchy of a person's bones in one tool or studio: a file of tests/conventions.
//
//   title: its name in docs/characters.md
//   doubt: a part of an expected doubt; without such a line there is none
//   name | parent | place | bone
//
// A nameless tip, as in BVH, has the name (end); the parent of a root is -. // {l|r} in a name
// makes two rows, for the left and for the right. A place is a point of the person below (*hip is
// the left or the right one), a point between two (*hip *knee 0.4), or three coordinates in metres,
// the first of which is mirrored for the right; + x y z after it moves it. `axes: blender` states
// that coordinates have z up and face -y. The bone is the expected one of HumanoidBone's words,
// with * for the side.
struct ConventionCase {
  std::string file;
  std::string title;
  StickFigure figure;
  std::vector<std::string> doubts;
  std::map<std::string, std::string> bones;  // bone, node
};

namespace convention_detail {

// The left side of a person of 1.75 m in a T-pose, with usual proportions, in shigusa's world.
inline const std::map<std::string, Vec3d>& places() {
  static const std::map<std::string, Vec3d> kPlaces{{"floor", {0, 0, 0}},
                                                    {"pelvis", {0, 0.98, 0}},
                                                    {"lumbar", {0, 1.05, 0}},
                                                    {"waist", {0, 1.12, 0}},
                                                    {"spine", {0, 1.2, -0.01}},
                                                    {"thorax", {0, 1.3, -0.02}},
                                                    {"chest", {0, 1.38, -0.02}},
                                                    {"neck", {0, 1.48, -0.02}},
                                                    {"neck2", {0, 1.53, 0}},
                                                    {"head", {0, 1.57, 0.01}},
                                                    {"top", {0, 1.75, 0.02}},
                                                    {"jaw", {0, 1.56, 0.03}},
                                                    {"chin", {0, 1.53, 0.1}},
                                                    {"nose", {0, 1.62, 0.12}},
                                                    {"eye", {0.032, 1.65, 0.08}},
                                                    {"ear", {0.075, 1.63, 0.02}},
                                                    {"breast", {0.09, 1.3, 0.12}},
                                                    {"hip", {0.09, 0.93, 0}},
                                                    {"knee", {0.09, 0.5, 0.01}},
                                                    {"ankle", {0.09, 0.085, -0.02}},
                                                    {"heel", {0.09, 0.01, -0.06}},
                                                    {"ball", {0.09, 0.025, 0.11}},
                                                    {"toe", {0.09, 0.015, 0.19}},
                                                    {"collar", {0.02, 1.43, 0}},
                                                    {"shoulder", {0.18, 1.43, 0}},
                                                    {"elbow", {0.46, 1.43, -0.01}},
                                                    {"wrist", {0.71, 1.43, 0}},
                                                    {"palm", {0.75, 1.43, 0.0}},
                                                    {"knuckle", {0.8, 1.43, 0}},
                                                    {"finger", {0.84, 1.43, 0}},
                                                    {"fingertip", {0.89, 1.43, 0}},
                                                    {"thumb", {0.74, 1.42, 0.04}},
                                                    {"thumbtip", {0.78, 1.41, 0.09}}};
  return kPlaces;
}

inline std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

inline std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> list;
  for (std::string word; in >> word;) list.push_back(word);
  return list;
}

// The row of one side (0 left, 1 right), with {l|r} replaced.
inline std::string of_side(std::string text, int side) {
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{')) {
    const std::size_t bar = text.find('|', open);
    const std::size_t close = text.find('}', open);
    const std::string word =
        side == 0 ? text.substr(open + 1, bar - open - 1) : text.substr(bar + 1, close - bar - 1);
    text.replace(open, close - open + 1, word);
  }
  return text;
}

inline Vec3d place(const std::string& text, int side, bool blender) {
  const std::vector<std::string> list = words(text);
  const Vec3d flip{side == 1 ? -1.0 : 1.0, 1.0, 1.0};
  const auto point = [&](std::string name) {
    if (name.starts_with("*")) name = name.substr(1);
    return places().at(name);
  };
  const auto triple = [&](std::size_t at) {
    const Vec3d p{std::stod(list.at(at)), std::stod(list.at(at + 1)), std::stod(list.at(at + 2))};
    return blender ? Vec3d{p.x, p.z, -p.y} : p;
  };
  std::size_t next = 1;
  Vec3d at;
  if (list.at(0).find_first_of("0123456789") != std::string::npos && list.at(0) != "neck2") {
    at = triple(0);
    next = 3;
  } else if (list.size() > 2 && list[1] != "+") {
    at = point(list[0]) + (point(list[1]) - point(list[0])) * std::stod(list[2]);
    next = 3;
  } else {
    at = point(list[0]);
  }
  if (next < list.size() && list[next] == "+") at += triple(next + 1);
  return {at.x * flip.x, at.y, at.z};
}

// Splits a row at its bars, except those in braces.
inline std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> list(1);
  int depth = 0;
  for (const char c : line) {
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (c == '|' && depth == 0) {
      list.emplace_back();
    } else {
      list.back() += c;
    }
  }
  for (std::string& cell : list) cell = trimmed(cell);
  return list;
}

}  // namespace convention_detail

inline ConventionCase read_convention(const std::filesystem::path& path) {
  namespace detail = convention_detail;
  ConventionCase result;
  result.file = path.stem().string();
  std::ifstream in(path);
  bool blender = false;
  for (std::string line; std::getline(in, line);) {
    line = detail::trimmed(line);
    if (line.empty() || line.starts_with("#")) continue;
    const auto told = [&](const std::string& key) {
      return line.starts_with(key + ":") ? detail::trimmed(line.substr(key.size() + 1)) : "";
    };
    if (const std::string title = told("title"); !title.empty()) {
      result.title = title;
    } else if (const std::string doubt = told("doubt"); !doubt.empty()) {
      result.doubts.push_back(doubt);
    } else if (told("axes") == "blender") {
      blender = true;
    } else {
      const std::vector<std::string> row = detail::cells(line);
      if (row.size() < 3) throw std::runtime_error(path.string() + ": " + line);
      const bool sided = line.find('{') != std::string::npos || row[2].starts_with("*");
      for (int side = 0; side < (sided ? 2 : 1); ++side) {
        const std::string name = row[0] == "(end)" ? "" : detail::of_side(row[0], side);
        const std::string parent = row[1] == "-" ? "" : detail::of_side(row[1], side);
        if (!parent.empty() && result.figure.find(parent) < 0) {
          throw std::runtime_error(path.string() + ": no parent '" + parent + "'");
        }
        result.figure.points.push_back({name, parent.empty() ? -1 : result.figure.find(parent),
                                        detail::place(row[2], side, blender)});
        if (row.size() < 4 || row[3].empty()) continue;
        std::string bone = row[3];
        if (bone.starts_with("*")) bone = (side == 0 ? "left_" : "right_") + bone.substr(1);
        result.bones[bone] = name;
      }
    }
  }
  return result;
}

inline std::vector<std::filesystem::path> convention_files(
    const std::string& below = "tests/conventions") {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = std::filesystem::path(SHIGUSA_SOURCE_DIR) / below;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace shigusa::testing_support
