// SPDX-License-Identifier: MIT
#include "fbx_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <optional>
#include <shigusa/error.hpp>
#include <utility>

#include "core/parse_number.hpp"
#include "core/say.hpp"
#include "core/text.hpp"

namespace shigusa {
namespace {

constexpr std::string_view kMagic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr int kOldest = 6000;
constexpr int kWithIds = 7000;                // since this version models have numbers
constexpr std::size_t kMaxRecordValues = 64;  // of a record that is read
constexpr int kLongHeads = 7500;  // since this version records have heads of 64-bit numbers

// Records that are read, each after its parent.
constexpr std::pair<std::string_view, std::string_view> kRead[] = {
    {"", "FBXHeaderExtension"},
    {"", "GlobalSettings"},
    {"", "Definitions"},
    {"", "Objects"},
    {"", "Connections"},
    {"FBXHeaderExtension", "FBXVersion"},
    {"GlobalSettings", "Properties70"},
    {"GlobalSettings", "Properties60"},
    {"Definitions", "ObjectType"},
    {"ObjectType", "PropertyTemplate"},
    {"PropertyTemplate", "Properties70"},
    {"Objects", "Model"},
    {"Objects", "GlobalSettings"},
    {"Model", "Properties70"},
    {"Model", "Properties60"},
    {"Properties70", "P"},
    {"Properties60", "Property"},
    {"Connections", "C"},
    {"Connections", "Connect"}};
// Properties of a model's transform, or of the file's units and axes.
constexpr std::string_view kProperties[] = {
    "Lcl Translation", "Lcl Rotation",  "Lcl Scaling",     "PreRotation",  "PostRotation",
    "RotationOffset",  "RotationPivot", "ScalingOffset",   "ScalingPivot", "RotationOrder",
    "RotationActive",  "InheritType",   "UnitScaleFactor", "UpAxis",       "UpAxisSign",
    "FrontAxis",       "FrontAxisSign", "CoordAxis",       "CoordAxisSign"};

// Filter for properties and connections, of which a file has many and few are used.
bool is_needed(const FbxRecord& record) {
  if (record.name == "C" || record.name == "Connect") return record.text(0) == "OO";
  const bool property = record.name == "P" || record.name == "Property";
  return !property || contains(kProperties, record.text(0));
}

// State shared by both forms: the first error, and the number of records kept.
class Reader {
 public:
  Reader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 protected:
  bool wrong(Message message, std::string place) {
    if (!error_) error_ = Error{ErrorCode::parse, std::move(message), place + " of " + name_};
    return false;
  }
  // Keeps a complete record if it is needed; false if there are too many.
  bool keep(FbxRecord&& record, FbxRecord& parent) {
    if (!is_needed(record)) return true;
    parent.within.push_back(std::move(record));
    return ++kept_ <= kFbxMaxRecords;
  }
  static std::string too_many() {
    return fmt::format("more than {} records of nodes and connections", kFbxMaxRecords);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;

 private:
  const std::string name_;
  std::size_t kept_ = 0;
  std::optional<Error> error_;
};

class BinaryReader : public Reader {
 public:
  using Reader::Reader;

  bool read(FbxRecords& records) {
    at_ = kMagic.size();
    std::uint32_t version = 0;
    if (!take(version)) return cut();
    records.version = static_cast<int>(std::min(version, 100'000u));
    long_heads_ = records.version >= kLongHeads;
    return records.version < kOldest || read_within(records.root, true, bytes_.size(), 0);
  }

 private:
  [[nodiscard]] std::string here() const { return fmt::format("byte {}", at_); }
  bool cut() { return wrong(say("fbx_cut"), here()); }

  // Little-endian on every machine.
  template <class T>
  bool take(T& value) {
    if (bytes_.size() - at_ < sizeof(T)) return false;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      bits |= std::uint64_t{static_cast<unsigned char>(bytes_[at_ + i])} << (8 * i);
    }
    at_ += sizeof(T);
    if constexpr (sizeof(T) == 8) {
      value = __builtin_bit_cast(T, bits);
    } else if constexpr (sizeof(T) == 4) {
      value = __builtin_bit_cast(T, static_cast<std::uint32_t>(bits));
    } else {
      value = static_cast<T>(bits);
    }
    return true;
  }
  bool take_size(std::uint64_t& value) {
    if (long_heads_) return take(value);
    std::uint32_t small = 0;
    const bool taken = take(small);
    value = small;
    return taken;
  }

  // Reads records up to `end`, or to the empty one that closes them.
  bool read_within(FbxRecord& parent, bool keeps, std::size_t end, int depth) {
    if (depth > kFbxMaxDepth) {
      return wrong(say("records_deep", kFbxMaxDepth), here());
    }
    while (at_ < end) {
      const std::size_t begin = at_;
      std::uint64_t last = 0;
      std::uint64_t values = 0;
      std::uint64_t length = 0;
      std::uint8_t letters = 0;
      if (!take_size(last) || !take_size(values) || !take_size(length) || !take(letters) ||
          bytes_.size() - at_ < letters) {
        return cut();
      }
      if (last == 0) return true;
      FbxRecord record;
      record.name = bytes_.substr(at_, letters);
      at_ += letters;
      if (last > end || last < at_ || length > last - at_) {
        at_ = begin;
        return wrong(say("record_longer"), here());
      }
      const std::size_t after = at_ + length;
      const auto stop = static_cast<std::size_t>(last);
      const bool kept = keeps && contains(kRead, std::pair(parent.name, record.name));
      if (kept) {
        if (!read_values(record, values, after)) return false;
        at_ = after;
        if (!read_within(record, true, stop, depth + 1)) return false;
      }
      at_ = stop;
      if (kept && !keep(std::move(record), parent)) return wrong(too_many(), here());
    }
    return true;
  }

  bool read_values(FbxRecord& record, std::uint64_t count, std::size_t end) {
    if (count > kMaxRecordValues) {
      return wrong(say("record_values", count, kMaxRecordValues), here());
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      if (at_ >= end) return cut();
      if (!read_value(record.values.emplace_back(), bytes_[at_++])) return false;
      if (at_ > end) return wrong(say("value_longer"), here());
    }
    return true;
  }

  template <class T>
  bool whole(FbxValue& value) {
    T read = 0;
    if (!take(read)) return cut();
    value.integer = static_cast<std::int64_t>(read);
    value.number = static_cast<double>(read);
    return true;
  }
  template <class T>
  bool fraction(FbxValue& value) {
    T read = 0;
    if (!take(read)) return cut();
    value.number = static_cast<double>(read);
    return true;
  }

  bool read_value(FbxValue& value, char type) {
    switch (type) {
      case 'C':
      case 'B':
        return whole<std::uint8_t>(value);
      case 'Y':
        return whole<std::int16_t>(value);
      case 'I':
        return whole<std::int32_t>(value);
      case 'L':
        return whole<std::int64_t>(value);
      case 'F':
        return fraction<float>(value);
      case 'D':
        return fraction<double>(value);
      case 'S':
      case 'R': {
        std::uint32_t length = 0;
        if (!take(length) || bytes_.size() - at_ < length) return cut();
        value.text = bytes_.substr(at_, length);
        at_ += length;
        return true;
      }
      default:
        break;
    }
    if (std::string_view("fdilbc").find(type) == std::string_view::npos) {
      return wrong(say("value_type"), here());
    }
    std::uint32_t count = 0;
    std::uint32_t packed = 0;
    std::uint32_t length = 0;
    if (!take(count) || !take(packed) || !take(length)) return cut();
    const std::uint64_t size = type == 'd' || type == 'l' ? 8 : type == 'f' || type == 'i' ? 4 : 1;
    const std::uint64_t bytes = packed != 0 ? length : count * size;
    if (bytes > bytes_.size() - at_) return cut();
    at_ += static_cast<std::size_t>(bytes);
    return true;
  }

  bool long_heads_ = false;
};

class TextReader : public Reader {
 public:
  using Reader::Reader;

  bool read(FbxRecords& records) {
    if (!read_within(records.root, true, 0)) return false;
    if (const FbxRecord* header = records.root.find("FBXHeaderExtension")) {
      const FbxRecord* version = header->find("FBXVersion");
      if (version != nullptr && version->integer(0) < 100'000) {
        records.version = static_cast<int>(version->integer(0));
      }
    }
    return true;
  }

 private:
  [[nodiscard]] std::string here() const {
    const auto end = bytes_.begin() + static_cast<long>(std::min(at_, bytes_.size()));
    return fmt::format("line {}", 1 + std::count(bytes_.begin(), end, '\n'));
  }

  // Next character after blanks and comments, or 0 at the end.
  char peek() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == ';') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else if (is_blank(bytes_[at_])) {
        ++at_;
      } else {
        return bytes_[at_];
      }
    }
    return 0;
  }

  std::string_view bare() {
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !is_blank(bytes_[at_]) &&
           std::string_view(",:{};\"").find(bytes_[at_]) == std::string_view::npos) {
      ++at_;
    }
    return bytes_.substr(begin, at_ - begin);
  }

  // Reads records up to the closing brace, or to the end of the file.
  bool read_within(FbxRecord& parent, bool keeps, int depth) {
    if (depth > kFbxMaxDepth) {
      return wrong(say("records_deep", kFbxMaxDepth), here());
    }
    for (char next = peek(); next != 0; next = peek()) {
      if (next == '}') {
        if (depth == 0) return wrong(say("closes_nothing"), here());
        ++at_;
        return true;
      }
      FbxRecord record;
      record.name = bare();
      if (record.name.empty() || peek() != ':') {
        return wrong(say("no_record"), here());
      }
      ++at_;
      const bool kept = keeps && contains(kRead, std::pair(parent.name, record.name));
      if (!read_values(record, kept)) return false;
      if (peek() == '{') {
        ++at_;
        if (!read_within(record, kept, depth + 1)) return false;
      }
      if (kept && !keep(std::move(record), parent)) return wrong(too_many(), here());
    }
    return depth == 0 || wrong(say("fbx_cut"), here());
  }

  // Reads values separated by commas, possibly over several lines.
  bool read_values(FbxRecord& record, bool kept) {
    for (;;) {
      const char next = peek();
      if (next == 0 || next == '{' || next == '}') return true;
      FbxValue value;
      if (next == '"') {
        const std::size_t end = bytes_.find('"', at_ + 1);
        if (end == bytes_.npos) return wrong(say("text_never_closed"), here());
        value.text = bytes_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
      } else if (next != ',') {
        const std::size_t begin = at_;
        const std::string_view word = bare();
        if (peek() == ':') {
          // a record without values, and the name of the next one
          at_ = begin;
          return true;
        }
        if (word.empty()) return wrong(say("no_value"), here());
        if (kept) read_word(word, value);
      }
      if (kept && record.values.size() < kMaxRecordValues) record.values.push_back(value);
      if (peek() != ',') return true;
      ++at_;
    }
  }

  static void read_word(std::string_view word, FbxValue& value) {
    const char* end = word.data() + word.size();
    const auto [stop, status] = std::from_chars(word.data(), end, value.integer);
    if (status == std::errc{} && stop == end) {
      value.number = static_cast<double>(value.integer);
    } else if (const std::optional<double> number = parse_number(word)) {
      value.integer = 0;
      value.number = *number;
    } else {
      value.text = word;
    }
  }
};

template <class Form>
Result<FbxRecords> read_form(std::string_view bytes, std::string_view name) {
  FbxRecords records;
  Form form(bytes, name);
  if (!form.read(records)) return tl::unexpected(*form.error());
  return records;
}

}  // namespace

const FbxRecord* FbxRecord::find(std::string_view wanted) const {
  const auto found = std::find_if(within.begin(), within.end(),
                                  [&](const FbxRecord& each) { return each.name == wanted; });
  return found == within.end() ? nullptr : &*found;
}

std::string_view FbxRecord::text(std::size_t i) const {
  return i < values.size() ? values[i].text : std::string_view{};
}

std::int64_t FbxRecord::integer(std::size_t i) const {
  return i < values.size() ? values[i].integer : 0;
}

double FbxRecord::number(std::size_t i) const { return i < values.size() ? values[i].number : 0.0; }

Result<FbxRecords> read_fbx_records(std::string_view bytes, std::string_view name) {
  const std::string place(name);
  if (bytes.size() > kFbxMaxBytes) {
    return fail(ErrorCode::parse, say("bytes_allowed", bytes.size(), kFbxMaxBytes), place);
  }
  Result<FbxRecords> records = bytes.starts_with(kMagic) ? read_form<BinaryReader>(bytes, name)
                                                         : read_form<TextReader>(bytes, name);
  if (!records) return records;
  if (records->version < kOldest) {
    return fail(ErrorCode::unsupported,
                records->version == 0
                    ? say("no_fbx")
                    : say("old_fbx", records->version / 1000, records->version / 100 % 10),
                place);
  }
  if (records->version < kWithIds) take_as_version_7(records->root);
  return records;
}

}  // namespace shigusa
