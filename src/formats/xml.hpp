// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa {

// Limits of an XML text; more is refused before memory is taken.
struct XmlLimits {
  std::size_t bytes = 0;
  std::size_t tags = 0;
  int depth = 0;  // of elements in one another
};
inline constexpr std::size_t kXmlMaxAttributes = 100;  // of one element

// An element of an XML text. Text between its children, comments and processing instructions are
// left out.
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;  // names and values, unescaped
  std::vector<XmlElement> children;
  int line = 0;  // of the text, from 1

  // Its value, or null where there is none.
  [[nodiscard]] const char* attribute(std::string_view name) const;
  // The first of that name, or null.
  [[nodiscard]] const XmlElement* child(std::string_view name) const;
};

// Parses the one element of an XML text, in UTF-8. `name` stands for the file in errors, which name
// the line. Only the five entities that XML has and characters by number are resolved: a document
// type with definitions is refused, and any other entity stays as it is written.
[[nodiscard]] Result<XmlElement> parse_xml(std::string_view text, const XmlLimits& limits,
                                           std::string_view name);

// The place of an element for errors: its line of the file that `name` stands for.
[[nodiscard]] std::string place_of(const XmlElement& element, std::string_view name);

// An error of what is wrong with an element of that file.
[[nodiscard]] tl::unexpected<Error> fail_at(const XmlElement& element, std::string_view name,
                                            Message message);

// The element as a text that parse_xml reads as the same element, each of its children on a line.
[[nodiscard]] std::string write_xml(const XmlElement& element);

// A text as an attribute's value within double quotes.
[[nodiscard]] std::string xml_escaped(std::string_view text);

// The numbers that stand in a text between blanks; nothing where one is none, or too many are
// there.
[[nodiscard]] std::optional<std::vector<double>> xml_numbers(std::string_view text,
                                                             std::size_t most);

}  // namespace shigusa
