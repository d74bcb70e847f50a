// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "formats/mjcf.hpp"
#include "formats/xml.hpp"

namespace shigusa {

// XML files of a model, including included ones, and the first error in them.
class MjcfFiles {
 public:
  // Parses the file and all files that it includes.
  MjcfFiles(std::string_view text, std::string_view name, const MjcfInclude& include);

  // The <mujoco> element, or null after an error.
  [[nodiscard]] const XmlElement* root() const { return root_; }

  // Calls visit(element) for each child element, with included files in place; stops at an error.
  template <class Visit>
  void each(const XmlElement& parent, const Visit& visit) {
    for (const XmlElement& e : parent.children) {
      if (error_) return;
      const auto included = included_.find(&e);
      if (included != included_.end()) {
        if (included->second != nullptr) each(*included->second, visit);
      } else {
        visit(e);
      }
    }
  }

  // Records an error, unless there is one; its place is the element's line.
  void wrong(const XmlElement& at, Message message) {
    if (!error_) error_ = Error{ErrorCode::parse, std::move(message), place_of(at)};
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  // Included files that were absent.
  [[nodiscard]] const std::vector<std::string>& absent() const { return absent_; }
  // Doubt about absent files; there must be one.
  [[nodiscard]] Message doubt_of_absent() const;

 private:
  const XmlElement* parse(std::string_view text, const std::string& name);
  // `folder`: folder of the file that contains the element, relative to the main file's.
  void follow(const XmlElement& element, const MjcfInclude& include,
              const std::filesystem::path& folder);
  void include(const XmlElement& element, const MjcfInclude& include,
               const std::filesystem::path& folder);
  [[nodiscard]] std::string place_of(const XmlElement& element) const;

  std::vector<std::pair<std::string, std::unique_ptr<XmlElement>>> files_;
  const XmlElement* root_ = nullptr;
  std::map<const XmlElement*, const XmlElement*> included_;  // <include>, the other file's root
  std::vector<std::string> absent_;
  std::size_t tags_ = 0;
  std::optional<Error> error_;
};

}  // namespace shigusa
