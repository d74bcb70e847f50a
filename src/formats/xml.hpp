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

// Limits of an XML text, checked before memory is taken.
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

  // Value of an attribute, or null.
  [[nodiscard]] const char* attribute(std::string_view name) const;
  // First child of that name, or null.
  [[nodiscard]] const XmlElement* child(std::string_view name) const;
};

// Parses the root element of an XML text in UTF-8. `name` stands for the file in errors, which
// state the line. Only XML's five entities and numeric characters are resolved: a document type
// with definitions is refused, and other entities are kept as written.
[[nodiscard]] Result<XmlElement> parse_xml(std::string_view text, const XmlLimits& limits,
                                           std::string_view name);

// Place of an element for errors: its line in the file that `name` stands for.
[[nodiscard]] std::string place_of(const XmlElement& element, std::string_view name);

// Error about an element of that file.
[[nodiscard]] tl::unexpected<Error> fail_at(const XmlElement& element, std::string_view name,
                                            Message message);

// Text that parse_xml reads as the same element, with one child per line.
[[nodiscard]] std::string write_xml(const XmlElement& element);

// Text escaped for an attribute value in double quotes.
[[nodiscard]] std::string xml_escaped(std::string_view text);

// Numbers of a text, separated by blanks; empty if one is malformed or there are too many.
[[nodiscard]] std::optional<std::vector<double>> xml_numbers(std::string_view text,
                                                             std::size_t most);

}  // namespace shigusa
