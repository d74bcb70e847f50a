// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "robot/urdf.hpp"

namespace shigusa {
namespace {

// Elements that are kept, each after the one that it stands in.
constexpr std::pair<std::string_view, std::string_view> kKept[] = {{"", "robot"},
                                                                   {"robot", "link"},
                                                                   {"robot", "joint"},
                                                                   {"link", "inertial"},
                                                                   {"inertial", "origin"},
                                                                   {"inertial", "mass"},
                                                                   {"inertial", "inertia"},
                                                                   {"link", "collision"},
                                                                   {"collision", "origin"},
                                                                   {"collision", "geometry"},
                                                                   {"geometry", "box"},
                                                                   {"geometry", "sphere"},
                                                                   {"geometry", "cylinder"},
                                                                   {"geometry", "capsule"},
                                                                   {"joint", "origin"},
                                                                   {"joint", "parent"},
                                                                   {"joint", "child"},
                                                                   {"joint", "axis"},
                                                                   {"joint", "limit"},
                                                                   {"joint", "mimic"}};

// "inf" and "nan" in any case, and numbers of more than kUrdfMaxValue, by their digits.
bool is_no_limit(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n+-");
  if (begin == text.npos) return false;
  text.remove_prefix(begin);
  const char first = text[0];
  if (first == 'i' || first == 'I' || first == 'n' || first == 'N') return true;
  const std::size_t mantissa = std::min(text.find_first_of("eE"), text.size());
  const std::size_t whole = std::min(text.find('.'), mantissa);
  const std::size_t zeros = std::min(text.find_first_not_of('0'), whole);
  long exponent = 0;
  if (mantissa < text.size()) {
    std::string_view digits = text.substr(mantissa + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (read.ec == std::errc::result_out_of_range) return !digits.starts_with('-');
  }
  constexpr long kDigits = 6;  // of kUrdfMaxValue
  return static_cast<long>(whole - zeros) + exponent > kDigits;
}

// Walks over the tags of an XML text and copies those that are kept, with what they are kept in.
class Scanner {
 public:
  Scanner(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  Result<std::string> reduce() {
    while (at_ < text_.size()) {
      const std::size_t open = text_.find('<', at_);
      if (open == text_.npos) break;
      at_ = open;
      SHG_TRY(take_markup());
    }
    if (!open_.empty()) return wrong("<{}> is never closed", shortened(open_.back().name));
    if (roots_ == 0) return wrong("no element <robot>: this is no URDF file");
    SHG_TRY(check_tree());
    return std::move(out_);
  }

 private:
  struct Element {
    std::string_view name;
    std::string_view written;  // the name in the output
    bool kept = false;
    std::size_t begin = 0;  // in the output
    bool shape = false;     // a collision with a box, sphere or cylinder
  };

  template <class... Args>
  [[nodiscard]] tl::unexpected<Error> wrong(fmt::format_string<Args...> format,
                                            Args&&... args) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<long>(at_), '\n');
    return fail(ErrorCode::parse, fmt::format(format, std::forward<Args>(args)...),
                fmt::format("line {} of {}", line, name_));
  }

  static std::string shortened(std::string_view name) { return std::string(name.substr(0, 60)); }

  Result<void> skip_to(std::string_view end, std::string_view what) {
    const std::size_t found = text_.find(end, at_);
    if (found == text_.npos) return wrong("{} is never closed", what);
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
        return wrong("a document type with definitions; a URDF file has none");
      }
      return skip_to(">", "<!");
    }
    // the tag's end is the first > outside quotes
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
    if (end >= text_.size()) return wrong("a tag is never closed");
    const std::string_view tag = text_.substr(at_ + 1, end - at_ - 1);
    const auto done = tag.starts_with('/') ? close(tag.substr(1)) : open(tag);
    at_ = end + 1;
    return done;
  }

  // The value of a tag's attribute, as it is written; nothing where the tag has none.
  static std::optional<std::string_view> attribute(std::string_view tag, std::string_view name) {
    std::size_t at = name_of(tag).size();
    while (true) {
      while (at < tag.size() && is_blank(tag[at])) ++at;
      const std::size_t equals = tag.find('=', at);
      if (equals == tag.npos) return std::nullopt;
      std::string_view found = tag.substr(at, equals - at);
      while (!found.empty() && is_blank(found.back())) found.remove_suffix(1);
      const std::size_t begin = tag.find_first_not_of(" \t\r\n", equals + 1);
      if (begin == tag.npos || (tag[begin] != '"' && tag[begin] != '\'')) return std::nullopt;
      const std::size_t end = tag.find(tag[begin], begin + 1);
      if (end == tag.npos) return std::nullopt;
      if (found == name) return tag.substr(begin + 1, end - begin - 1);
      at = end + 1;
    }
  }

  // The link that a joint hangs on, or carries. urdfdom is given no other attribute, so that it
  // reads the link that is checked here.
  Result<void> hang(std::string_view name, std::string_view tag) {
    auto& [parent, child] = hung_.back();
    std::string_view& link = name == "parent" ? parent : child;
    if (!link.empty()) return wrong("a joint with a second <{}>", name);
    link = attribute(tag, "link").value_or(std::string_view{});
    if (link.empty()) return wrong("<{}> names no link", name);
    if (link.find('&') != link.npos) {
      return wrong("<{}> names '{}'; a name has no '&'", name, shortened(link));
    }
    const char quote = link.find('"') == link.npos ? '"' : '\'';
    out_ +=
        fmt::format("<{} link={}{}{}{}>", name, quote, link, quote, tag.ends_with('/') ? "/" : "");
    return {};
  }

  // urdfdom has no capsules; without its round ends one is a cylinder.
  static std::string_view written_as(std::string_view name) {
    return name == "capsule" ? "cylinder" : name;
  }

  // A joint's limits. A word for none, "inf" or a number beyond all others, is no limit, and
  // urdfdom reads neither infinity nor a joint without effort.
  void limit(std::string_view tag) {
    out_ += "<limit";
    for (const std::string_view name : {"lower", "upper", "effort", "velocity"}) {
      const bool angle = name == "lower" || name == "upper";
      const std::string_view value = attribute(tag, name).value_or(angle ? "" : "0");
      if (value.empty()) continue;
      const std::string_view none = !angle ? "0" : value.find('-') != value.npos ? "-1000" : "1000";
      const std::string_view written = is_no_limit(value) ? none : value;
      const char quote = written.find('"') == written.npos ? '"' : '\'';
      (((((out_ += ' ') += name) += '=') += quote) += written) += quote;
    }
    out_ += tag.ends_with('/') ? "/>" : ">";
  }

  // Links that hang in a circle would never leave urdfdom's memory.
  [[nodiscard]] Result<void> check_tree() const {
    std::map<std::string_view, std::string_view> above;
    for (const auto& [parent, child] : hung_) {
      if (!above.emplace(child, parent).second) {
        return fail(ErrorCode::parse,
                    fmt::format("link '{}' hangs on two joints; one is allowed", shortened(child)),
                    std::string(name_));
      }
    }
    for (const auto& [child, parent] : above) {
      std::size_t steps = 0;
      for (auto at = above.find(parent); at != above.end(); at = above.find(at->second)) {
        if (++steps <= above.size()) continue;
        return fail(ErrorCode::parse,
                    fmt::format("link '{}' hangs in a circle of joints", shortened(child)),
                    std::string(name_));
      }
    }
    return {};
  }

  static std::string_view name_of(std::string_view tag) {
    std::size_t length = 0;
    while (length < tag.size() && !is_blank(tag[length]) && tag[length] != '/') ++length;
    return tag.substr(0, length);
  }

  Result<void> open(std::string_view tag) {
    const std::string_view name = name_of(tag);
    const bool empty = tag.ends_with('/');
    if (name.empty()) return wrong("a tag without a name");
    if (name.starts_with("xacro:")) {
      return wrong("<{}> is xacro's: expand the file first, as in `xacro FILE > robot.urdf`",
                   shortened(name));
    }
    if (open_.empty()) {
      if (name != "robot") return wrong("<{}> in place of <robot>", shortened(name));
      if (++roots_ > 1) return wrong("a second <robot>");
    }
    if (static_cast<int>(open_.size()) >= kUrdfMaxDepth) {
      return wrong("<{}> is nested deeper than {} elements", shortened(name), kUrdfMaxDepth);
    }
    const bool parent_kept = open_.empty() || open_.back().kept;
    const std::string_view parent = open_.empty() ? std::string_view{} : open_.back().name;
    Element element{name, written_as(name), parent_kept && contains(kKept, std::pair(parent, name)),
                    out_.size()};
    if (element.kept && name == "link" && ++links_ > kUrdfMaxLinks) {
      return wrong("more than {} links", kUrdfMaxLinks);
    }
    if (element.kept && name == "joint" && ++joints_ > kUrdfMaxLinks) {
      return wrong("more than {} joints", kUrdfMaxLinks);
    }
    const bool hangs = element.kept && (name == "parent" || name == "child");
    if (element.kept && name == "joint") hung_.emplace_back();
    if (hangs) {
      SHG_TRY(hang(name, tag));
    } else if (element.kept && name == "limit") {
      limit(tag);
    } else if (element.kept) {
      (((out_ += '<') += element.written) += tag.substr(name.size())) += '>';
      const bool shape =
          element.written == "box" || element.written == "sphere" || element.written == "cylinder";
      if (shape) open_[open_.size() - 2].shape = true;
    }
    open_.push_back(element);
    return empty ? finish(false) : Result<void>{};
  }

  Result<void> close(std::string_view tag) {
    const std::string_view name = name_of(tag);
    if (open_.empty() || open_.back().name != name) {
      return wrong("</{}> closes {}", shortened(name),
                   open_.empty() ? "nothing" : "<" + shortened(open_.back().name) + ">");
    }
    return finish(true);
  }

  Result<void> finish(bool tag) {
    const Element& element = open_.back();
    if (element.kept && tag) ((out_ += "</") += element.written) += '>';
    // a mesh is not read, and urdfdom wants a shape
    if (element.kept && element.name == "collision" && !element.shape) out_.resize(element.begin);
    if (element.kept && (element.name == "link" || element.name == "joint")) out_ += '\n';
    open_.pop_back();
    return {};
  }

  std::string_view text_;
  std::string_view name_;
  std::size_t at_ = 0;
  std::vector<Element> open_;
  std::string out_;
  std::vector<std::pair<std::string_view, std::string_view>> hung_;  // parent and child of joints
  int roots_ = 0;
  int links_ = 0;
  int joints_ = 0;
};

}  // namespace

Result<std::string> reduced_urdf(std::string_view text, std::string_view name) {
  SHG_TRY(check_text(text, kUrdfMaxBytes, name));
  return Scanner(text, name).reduce();
}

}  // namespace shigusa
