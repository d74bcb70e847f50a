// SPDX-License-Identifier: MIT
#include "formats/xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <shigusa/error.hpp>

#include "core/parse_number.hpp"
#include "core/say.hpp"
#include "core/text.hpp"

namespace shigusa {
namespace {

std::string shortened(std::string_view name) { return std::string(name.substr(0, 60)); }

struct Entity {
  std::string_view name;
  char character;
};
constexpr Entity kEntities[] = {
    {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};

// Character of a code point in UTF-8; empty if invalid.
std::string utf8(std::uint32_t code) {
  if (code == 0 || (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF) return {};
  const auto tail = [&](int shift) { return static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  const auto head = [&](std::uint32_t marks, int shift) {
    return static_cast<char>(marks | (code >> shift));
  };
  if (code < 0x80) return {head(0, 0)};
  if (code < 0x800) return {head(0xC0, 6), tail(0)};
  if (code < 0x10000) return {head(0xE0, 12), tail(6), tail(0)};
  return {head(0xF0, 18), tail(12), tail(6), tail(0)};
}

// Character of an entity from the text between & and ;, or empty if unknown.
std::string resolved(std::string_view entity) {
  for (const auto& [name, character] : kEntities) {
    if (entity == name) return std::string(1, character);
  }
  if (!entity.starts_with('#')) return {};
  entity.remove_prefix(1);
  const bool hexadecimal = entity.starts_with('x');
  if (hexadecimal) entity.remove_prefix(1);
  std::uint32_t code = 0;
  const char* end = entity.data() + entity.size();
  const auto read = std::from_chars(entity.data(), end, code, hexadecimal ? 16 : 10);
  return read.ec == std::errc{} && read.ptr == end ? utf8(code) : std::string{};
}

std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find('&', at), text.size());
    out += text.substr(at, open - at);
    at = open;
    if (at == text.size()) break;
    constexpr std::size_t kLongest = 12;  // of an entity
    const std::size_t length = text.substr(at, kLongest).find(';');
    const std::string one =
        length == text.npos ? std::string{} : resolved(text.substr(at + 1, length - 1));
    out += one.empty() ? "&" : one;
    at += one.empty() ? 1 : length + 1;
  }
  return out;
}

// Parser of tags that attaches each element to the open one.
class XmlReader {
 public:
  XmlReader(std::string_view text, const XmlLimits& limits, std::string_view name)
      : text_(text), limits_(limits), name_(name) {}

  Result<XmlElement> read() {
    for (at_ = text_.find('<'); at_ < text_.size(); at_ = text_.find('<', at_)) {
      line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                                           text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
      counted_ = at_;
      SHG_TRY(take_markup());
    }
    if (!open_.empty()) return wrong(say("xml_never_closed", shortened(open_.back()->name)));
    if (top_.children.empty()) return wrong(say("no_xml"));
    return std::move(top_.children[0]);
  }

 private:
  [[nodiscard]] tl::unexpected<Error> wrong(Message message) const {
    return fail(ErrorCode::parse, std::move(message), fmt::format("line {} of {}", line_, name_));
  }

  Result<void> skip_to(std::string_view end, std::string_view what) {
    const std::size_t found = text_.find(end, at_);
    if (found == text_.npos) return wrong(say("never_closed", what));
    at_ = found + end.size();
    return {};
  }

  Result<void> take_markup() {
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("<!--")) return skip_to("-->", "a comment");
    if (rest.starts_with("<![CDATA[")) return skip_to("]]>", "a CDATA section");
    if (rest.starts_with("<?")) return skip_to("?>", "<?");
    if (rest.starts_with("<!")) {
      if (rest.substr(0, rest.find('>')).find('[') != rest.npos) {
        return wrong(say("xml_definitions"));
      }
      return skip_to(">", "<!");
    }
    // the end of a tag is the first > outside quotes
    std::size_t end = at_ + 1;
    char quote = 0;
    for (; end < text_.size() && (quote != 0 || text_[end] != '>'); ++end) {
      const char c = text_[end];
      if (quote == 0 && (c == '"' || c == '\'')) {
        quote = c;
      } else if (c == quote) {
        quote = 0;
      }
    }
    if (end >= text_.size()) return wrong(say("xml_tag_open"));
    const std::string_view tag = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return tag.starts_with('/') ? close(tag.substr(1)) : open(tag);
  }

  static std::string_view name_of(std::string_view tag) {
    const std::size_t end = tag.find_first_of(" \t\r\n/=\"'<");
    return tag.substr(0, end);
  }

  Result<void> open(std::string_view tag) {
    const bool empty = tag.ends_with('/');
    if (empty) tag.remove_suffix(1);
    const std::string_view name = name_of(tag);
    if (name.empty()) return wrong(say("tag_no_name"));
    if (open_.empty() && !top_.children.empty()) {
      return wrong(say("second_element", shortened(name), shortened(top_.children[0].name)));
    }
    if (static_cast<int>(open_.size()) >= limits_.depth) {
      return wrong(say("xml_deep", shortened(name), limits_.depth));
    }
    // open elements have no later siblings, so adding one moves none
    XmlElement& above = open_.empty() ? top_ : *open_.back();
    XmlElement& element = above.children.emplace_back();
    element.name = name;
    element.line = line_;
    SHG_TRY(take_attributes(tag.substr(name.size()), element));
    if (!empty) open_.push_back(&element);
    return {};
  }

  Result<void> take_attributes(std::string_view tag, XmlElement& element) const {
    const auto skip_blanks = [&] {
      while (!tag.empty() && is_blank(tag[0])) tag.remove_prefix(1);
    };
    for (skip_blanks(); !tag.empty(); skip_blanks()) {
      const std::string_view name = name_of(tag);
      tag.remove_prefix(name.size());
      skip_blanks();
      const bool equals = !name.empty() && tag.starts_with('=');
      if (equals) tag.remove_prefix(1);
      skip_blanks();
      const bool quoted = tag.starts_with('"') || tag.starts_with('\'');
      const std::size_t end = equals && quoted ? tag.find(tag[0], 1) : tag.npos;
      if (end == tag.npos) {
        return wrong(
            say("xml_attribute", shortened(element.name), shortened(name.empty() ? tag : name)));
      }
      if (element.attribute(name) != nullptr) {
        return wrong(say("attribute_twice", shortened(element.name), shortened(name)));
      }
      if (element.attributes.size() >= kXmlMaxAttributes) {
        return wrong(say("attributes_most", shortened(element.name), kXmlMaxAttributes));
      }
      element.attributes.emplace_back(name, unescaped(tag.substr(1, end - 1)));
      tag.remove_prefix(end + 1);
    }
    return {};
  }

  Result<void> close(std::string_view tag) {
    while (!tag.empty() && is_blank(tag.back())) tag.remove_suffix(1);
    if (open_.empty() || open_.back()->name != tag) {
      return wrong(say("xml_closes", shortened(tag),
                       open_.empty() ? "nothing" : "<" + shortened(open_.back()->name) + ">"));
    }
    open_.pop_back();
    return {};
  }

  std::string_view text_;
  XmlLimits limits_;
  std::string_view name_;
  std::size_t at_ = 0;
  std::size_t counted_ = 0;  // position up to which lines are counted
  int line_ = 1;
  XmlElement top_;  // parent of the root element
  std::vector<XmlElement*> open_;
};

void write(const XmlElement& element, std::string& out) {
  (out += '<') += element.name;
  for (const auto& [name, value] : element.attributes) {
    (((((out += ' ') += name) += "=\"") += xml_escaped(value)) += '"');
  }
  if (element.children.empty()) {
    out += "/>";
    return;
  }
  out += '>';
  for (const XmlElement& child : element.children) write(child, out);
  ((out += "</") += element.name) += '>';
}

}  // namespace

const char* XmlElement::attribute(std::string_view named) const {
  for (const auto& [key, value] : attributes) {
    if (key == named) return value.c_str();
  }
  return nullptr;
}

const XmlElement* XmlElement::child(std::string_view named) const {
  for (const XmlElement& each : children) {
    if (each.name == named) return &each;
  }
  return nullptr;
}

Result<XmlElement> parse_xml(std::string_view text, const XmlLimits& limits,
                             std::string_view name) {
  const std::string place(name);
  if (text.size() > limits.bytes) {
    return fail(ErrorCode::parse, say("bytes_allowed", text.size(), limits.bytes), place);
  }
  if (text.find('\0') != text.npos) {
    return fail(ErrorCode::parse, say("zero_byte"), place);
  }
  if (static_cast<std::size_t>(std::count(text.begin(), text.end(), '<')) > limits.tags) {
    return fail(ErrorCode::parse, say("xml_tags", limits.tags), place);
  }
  return XmlReader(text, limits, name).read();
}

std::string place_of(const XmlElement& element, std::string_view name) {
  return fmt::format("line {} of {}", element.line, name);
}

tl::unexpected<Error> fail_at(const XmlElement& element, std::string_view name, Message message) {
  return fail(ErrorCode::parse, std::move(message), place_of(element, name));
}

std::string write_xml(const XmlElement& element) {
  XmlElement outer{element.name, element.attributes, {}, 0};
  std::string out;
  write(outer, out);
  if (element.children.empty()) return out + '\n';
  out.replace(out.size() - 2, 2, ">\n");
  for (const XmlElement& child : element.children) {
    write(child, out);
    out += '\n';
  }
  return out + "</" + element.name + ">\n";
}

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += c;
    }
  }
  return out;
}

std::optional<std::vector<double>> xml_numbers(std::string_view text, std::size_t most) {
  std::vector<double> numbers;
  for (std::size_t at = 0;;) {
    while (at < text.size() && is_blank(text[at])) ++at;
    if (at == text.size()) return numbers;
    const std::size_t begin = at;
    while (at < text.size() && !is_blank(text[at])) ++at;
    const std::optional<double> number = parse_number(text.substr(begin, at - begin));
    if (!number || numbers.size() == most) return std::nullopt;
    numbers.push_back(*number);
  }
}

}  // namespace shigusa
