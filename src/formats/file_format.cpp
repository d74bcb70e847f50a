// SPDX-License-Identifier: MIT
#include <filesystem>
#include <shigusa/formats.hpp>
#include <vector>

#include "core/text.hpp"
#include "files/path.hpp"

namespace shigusa {
namespace {

// "a, b and c".
std::string listed(const std::vector<std::string_view>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : " " + std::string(last) + " ";
    text += words[i];
  }
  return text;
}

}  // namespace

bool has_mannequin() {
#ifdef SHIGUSA_HAS_MANNEQUIN
  return true;
#else
  return false;
#endif
}

std::string file_ending(const std::string& name) {
  return lower(to_path(name).extension().string());
}

std::optional<FileFormat> format_of_file(const std::string& name) {
  const std::string ending = file_ending(name);
  for (const FormatInfo& info : kFileFormats) {
    if (!info.person && !info.robot && !info.clip) continue;
    for (const std::string_view known : info.endings) {
      if (!known.empty() && ending == known) return info.format;
    }
  }
  return std::nullopt;
}

std::string format_words(bool (*is_so)(const FormatInfo&), std::string_view last) {
  std::vector<std::string_view> words;
  for (const FormatInfo& info : kFileFormats) {
    if (is_so(info)) words.push_back(info.word);
  }
  return listed(words, last);
}

std::string format_endings(bool (*is_so)(const FormatInfo&), std::string_view last) {
  std::vector<std::string_view> endings;
  for (const FormatInfo& info : kFileFormats) {
    for (const std::string_view ending : info.endings) {
      if (is_so(info) && !ending.empty()) endings.push_back(ending);
    }
  }
  return listed(endings, last);
}

}  // namespace shigusa
