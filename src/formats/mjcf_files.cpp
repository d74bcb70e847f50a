// SPDX-License-Identifier: MIT
#include "mjcf_files.hpp"

#include <algorithm>

#include "core/say.hpp"
#include "files/file.hpp"
#include "files/path.hpp"

namespace shigusa {
namespace {

bool stands_in(const XmlElement& element, const XmlElement& root) {
  const auto in_child = [&](const XmlElement& child) { return stands_in(element, child); };
  return &element == &root || std::any_of(root.children.begin(), root.children.end(), in_child);
}

}  // namespace

MjcfInclude included_from(std::filesystem::path folder) {
  return [folder = std::move(folder)](const std::string& file) -> Result<std::string> {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::path base = fs::weakly_canonical(folder.empty() ? "." : folder, failed);
    const fs::path named = to_path(file);
    // one of another machine is not even looked for
    const fs::path path =
        named.has_root_path() ? named : fs::weakly_canonical(base / named, failed);
    const fs::path within = path.lexically_relative(base);
    if (failed || within.empty() || *within.begin() == ".." || named.has_root_path()) {
      return fail(ErrorCode::invalid_argument, say("outside_folder"), file);
    }
    return read_text_file(path, kMjcfMaxBytes);
  };
}

Error after_absent(const std::vector<Message>& doubts, Error error) {
  for (const Message& doubt : doubts) {
    if (doubt.key != "file_absent" && doubt.key != "files_absent") continue;
    error.message = say("after_absent", doubt, std::move(error.message));
  }
  return error;
}

MjcfFiles::MjcfFiles(std::string_view text, std::string_view name, const MjcfInclude& include) {
  root_ = parse(text, std::string(name));
  if (root_ == nullptr) return;
  if (root_->name != "mujoco") {
    wrong(*root_, say("no_mjcf", root_->name.substr(0, 60)));
  } else {
    follow(*root_, include, {});
  }
  if (error_) root_ = nullptr;
}

const XmlElement* MjcfFiles::parse(std::string_view text, const std::string& name) {
  Result<XmlElement> root = parse_xml(text, {kMjcfMaxBytes, kMjcfMaxTags, kMjcfMaxNesting}, name);
  tags_ += static_cast<std::size_t>(std::count(text.begin(), text.end(), '<'));
  if (root && tags_ > kMjcfMaxTags) {
    root = fail(ErrorCode::parse, say("model_tags", kMjcfMaxTags), name);
  }
  if (!root) {
    if (!error_) error_ = root.error();
    return nullptr;
  }
  files_.emplace_back(name, std::make_unique<XmlElement>(*std::move(root)));
  return files_.back().second.get();
}

void MjcfFiles::follow(const XmlElement& element, const MjcfInclude& include_file,
                       const std::filesystem::path& folder) {
  for (const XmlElement& e : element.children) {
    if (error_) return;
    if (e.name == "include") {
      include(e, include_file, folder);
    } else {
      follow(e, include_file, folder);
    }
  }
}

void MjcfFiles::include(const XmlElement& element, const MjcfInclude& include_file,
                        const std::filesystem::path& folder) {
  const char* file = element.attribute("file");
  if (file == nullptr || *file == '\0') return wrong(element, say("include_no_file"));
  const XmlElement*& root = included_[&element];
  if (!include_file) return absent_.push_back(file);
  // relative to the including file, then to the main one
  std::filesystem::path path = (folder / to_path(file)).lexically_normal();
  Result<std::string> text = include_file(path.generic_string());
  if (!text && text.error().code == ErrorCode::not_found && !folder.empty()) {
    path = to_path(file).lexically_normal();
    text = include_file(path.generic_string());
  }
  const std::string name = path.generic_string();
  const auto same = [&](const auto& each) { return each.first == name; };
  if (std::any_of(files_.begin(), files_.end(), same)) {
    return wrong(element, say("included_twice", shown(name)));
  }
  if (static_cast<int>(files_.size()) >= kMjcfMaxFiles) {
    return wrong(element, say("files_most", kMjcfMaxFiles));
  }
  if (!text && text.error().code == ErrorCode::not_found) return absent_.push_back(file);
  if (!text) return wrong(element, say("includes", shown(file), text.error().message));
  root = parse(*text, name);
  if (root != nullptr) follow(*root, include_file, path.parent_path());
}

Message MjcfFiles::doubt_of_absent() const {
  constexpr std::size_t kMost = 5;
  std::vector<std::string> names;
  for (const std::string& name : absent_) {
    if (std::find(names.begin(), names.end(), shown(name)) == names.end()) {
      names.push_back(shown(name));
    }
  }
  if (names.size() == 1) return say("file_absent", names[0]);
  const bool more = names.size() > kMost;
  names.resize(std::min(names.size(), kMost));
  return say("files_absent", fmt::format("{}{}", fmt::join(names, ", "), more ? ", …" : ""));
}

std::string MjcfFiles::place_of(const XmlElement& element) const {
  for (const auto& [name, root] : files_) {
    if (stands_in(element, *root)) return shigusa::place_of(element, name);
  }
  return {};
}

}  // namespace shigusa
