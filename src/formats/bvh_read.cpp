// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <vector>

#include "bvh_positions.hpp"
#include "core/index.hpp"
#include "core/parse_number.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "files/file.hpp"
#include "node_names.hpp"

namespace shigusa {
namespace {

// Blanks as in the C locale.
bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// Tokeniser that counts lines. Tokens end at blanks; braces and colons are tokens.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  // Next token; empty at the end of the text.
  std::string_view token() {
    skip_blanks();
    const char* start = at_;
    if (at_ != end_ && is_mark(*at_)) return {start, static_cast<std::size_t>(++at_ - start)};
    while (at_ != end_ && !is_space(*at_) && !is_mark(*at_)) ++at_;
    return {start, static_cast<std::size_t>(at_ - start)};
  }

  // Rest of the same line, up to a brace, without surrounding blanks.
  std::string_view rest_of_line() {
    const auto stops = [](char c) { return c == '\n' || c == '\r' || c == '{' || c == '}'; };
    while (at_ != end_ && is_space(*at_) && !stops(*at_)) ++at_;
    const char* start = at_;
    while (at_ != end_ && !stops(*at_)) ++at_;
    const char* stop = at_;
    while (stop != start && is_space(stop[-1])) --stop;
    return {start, static_cast<std::size_t>(stop - start)};
  }

  // Line of the last token, from 1.
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

 private:
  static bool is_mark(char c) { return c == '{' || c == '}' || c == ':'; }

  void skip_blanks() {
    while (at_ != end_ && is_space(*at_)) {
      const char c = *at_++;
      // CR LF is one line end, a CR alone (old Macintosh files) one too
      if (c == '\n' || (c == '\r' && (at_ == end_ || *at_ != '\n'))) ++line_;
    }
  }

  const char* at_;
  const char* end_;
  int line_ = 1;
};

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

// A token for a message: short, and without control bytes.
std::string shown_token(std::string_view token) {
  constexpr std::size_t kLongest = 40;
  std::string text;
  for (const char c : token.substr(0, kLongest)) text += c > ' ' && c < 0x7F ? c : '?';
  return token.size() > kLongest ? "'" + text + "…'" : "'" + text + "'";
}

// Whether a token is a notation of NaN or infinity: nan(ind), -1.#IND.
bool tells_no_number(std::string_view token) {
  if (token.starts_with('-') || token.starts_with('+')) token.remove_prefix(1);
  return token.find('#') != token.npos || same_word(token.substr(0, 3), "nan") ||
         same_word(token.substr(0, 3), "inf");
}

std::optional<int> parse_integer(std::string_view token) {
  int value = 0;
  const char* end = token.data() + token.size();
  const auto [stop, status] = std::from_chars(token.data(), end, value);
  if (stop != end || status != std::errc{}) return std::nullopt;
  return value;
}

// One column of the motion: its effect on its node.
struct Channel {
  int node;
  bool rotates;
  Axis axis;
};

constexpr std::array<std::string_view, 6> kChannelNames{"Xposition", "Yposition", "Zposition",
                                                        "Xrotation", "Yrotation", "Zrotation"};
constexpr int kMaxChannelsPerNode = 9;
constexpr std::size_t kMaxNameBytes = 256;
constexpr double kMinFrameTime = 1e-6;          // s
constexpr double kMaxFrameTime = 1e3;           // s
constexpr double kUsualFrameTime = 1.0 / 30.0;  // s

// Parser of one text. Each step returns false after it has recorded an error.
class BvhReader {
 public:
  BvhReader(std::string_view text, std::string_view name, BvhFaults faults)
      : cursor_(text), name_(name), lenient_(faults == BvhFaults::told) {}

  Result<BvhFile> read() {
    if (!hierarchy() || !motion()) return tl::unexpected<Error>(error_);
    BvhFile file{std::move(motion_), {}, std::move(doubts_), std::move(unread_)};
    file.channels.resize(file.motion.skeleton.nodes.size());
    for (const Channel& channel : channels_) {
      file.channels[index(channel.node)].push_back({channel.rotates, channel.axis});
    }
    add_offsets(file);
    return file;
  }

 private:
  struct Seen {
    bool offset = false;
    bool channels = false;
  };

  bool fail_here(Message message) {
    error_ = {ErrorCode::parse, std::move(message),
              fmt::format("line {} of {}", cursor_.line(), name_)};
    return false;
  }

  bool unexpected(std::string_view token, std::string_view expected) {
    if (token.empty()) return fail_here(say("bvh_ends", expected));
    return fail_here(say("bvh_found", shown_token(token), expected));
  }

  // Whether the text ends here, for a file that is read as far as it goes.
  [[nodiscard]] bool may_end() const { return lenient_ && Cursor(cursor_).token().empty(); }

  bool expect(std::string_view word) {
    const std::string_view token = cursor_.token();
    return same_word(token, word) || unexpected(token, word);
  }

  bool number(double& value, std::string_view what) {
    const std::string_view token = cursor_.token();
    const std::optional<double> parsed = parse_number(token);
    if (!parsed) return unexpected(token, what);
    value = *parsed;
    if (value >= -kBvhMaxValue && value <= kBvhMaxValue) return true;
    return fail_here(say("not_between", shown_token(token), -kBvhMaxValue, kBvhMaxValue));
  }

  SkeletonNode& node(int index) { return motion_.skeleton.nodes[static_cast<std::size_t>(index)]; }

  bool hierarchy() {
    std::string_view token = cursor_.token();
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (token.starts_with(kByteOrderMark)) token.remove_prefix(kByteOrderMark.size());
    if (token.empty()) return fail_here(say("empty_bvh"));
    if (!same_word(token, "HIERARCHY")) return unexpected(token, "HIERARCHY");
    for (;;) {
      if (open_.empty() && !motion_.skeleton.nodes.empty() && may_end()) return true;
      token = cursor_.token();
      if (open_.empty() && !motion_.skeleton.nodes.empty() && same_word(token, "MOTION")) {
        return true;
      }
      if (!(open_.empty() ? outside(token) : inside(token))) return false;
    }
  }

  bool outside(std::string_view token) {
    if (same_word(token, "ROOT")) return open_node(-1, false);
    return unexpected(token, motion_.skeleton.nodes.empty() ? "ROOT" : "ROOT or MOTION");
  }

  bool inside(std::string_view token) {
    const int current = open_.back();
    const bool end_site = node(current).end_site;
    if (token == "}") return close_node();
    if (same_word(token, "OFFSET")) return offset(current);
    if (end_site) return unexpected(token, "the OFFSET or the } of an End Site");
    if (same_word(token, "CHANNELS")) return channels(current);
    if (same_word(token, "JOINT")) return open_node(current, false);
    if (same_word(token, "End")) return expect("Site") && open_node(current, true);
    return unexpected(token, "OFFSET, CHANNELS, JOINT, End Site or }");
  }

  bool open_node(int parent, bool end_site) {
    const int index = static_cast<int>(motion_.skeleton.nodes.size());
    if (index == kBvhMaxNodes) {
      return fail_here(say("bvh_joints_most", kBvhMaxNodes));
    }
    const std::string_view name = cursor_.rest_of_line();
    if (name.size() > kMaxNameBytes) {
      return fail_here(say("bvh_name", name.size(), shown_token(name), kMaxNameBytes));
    }
    motion_.skeleton.nodes.push_back(
        {end_site ? std::string() : names_.take(name), parent, {}, end_site});
    seen_.emplace_back();
    open_.push_back(index);
    return expect("{");
  }

  bool close_node() {
    const int index = open_.back();
    if (!seen_[static_cast<std::size_t>(index)].offset) {
      return fail_here(say("no_offset", described(index)));
    }
    open_.pop_back();
    return true;
  }

  std::string described(int index) {
    return node(index).end_site ? "the End Site" : "joint " + shown_token(node(index).name);
  }

  bool once(bool& seen, int index, std::string_view what) {
    if (seen) return fail_here(say("has_second", described(index), what));
    seen = true;
    return true;
  }

  bool offset(int index) {
    if (!once(seen_[static_cast<std::size_t>(index)].offset, index, "OFFSET")) return false;
    Vec3d& offset = node(index).offset;
    return number(offset.x, "the first number of an OFFSET") &&
           number(offset.y, "the second number of an OFFSET") &&
           number(offset.z, "the third number of an OFFSET");
  }

  bool channels(int index) {
    if (!once(seen_[static_cast<std::size_t>(index)].channels, index, "CHANNELS")) return false;
    const std::string_view token = cursor_.token();
    const std::optional<int> count = parse_integer(token);
    if (!count || *count < 0 || *count > kMaxChannelsPerNode) {
      return unexpected(token, fmt::format("a number of channels, 0 to {},", kMaxChannelsPerNode));
    }
    bool placed[3] = {false, false, false};
    for (int i = 0; i < *count; ++i) {
      if (!channel(index, placed)) return false;
    }
    return true;
  }

  // `placed`: axes with their position channel.
  bool channel(int index, bool (&placed)[3]) {
    const std::string_view token = cursor_.token();
    std::size_t kind = 0;
    while (kind < kChannelNames.size() && !same_word(token, kChannelNames[kind])) ++kind;
    if (kind == kChannelNames.size()) {
      return unexpected(token, "a channel, Xposition to Zposition or Xrotation to Zrotation,");
    }
    const bool rotates = kind >= 3;
    if (!rotates && !once(placed[kind], index, kChannelNames[kind])) return false;
    channels_.push_back({index, rotates, static_cast<Axis>(kind % 3)});
    return true;
  }

  bool motion() {
    if (may_end()) return true;
    if (!frame_count()) return false;
    return motion_.clip.frames == 0 || (frame_time() && values_fit() && values());
  }

  bool frame_count() {
    if (!expect("Frames") || !expect(":")) return false;
    const std::string_view token = cursor_.token();
    const std::optional<int> frames = parse_integer(token);
    if (!frames || *frames < (lenient_ ? 0 : 1) || *frames > kBvhMaxFrames) {
      return unexpected(token, fmt::format("a number of frames, 1 to {},", kBvhMaxFrames));
    }
    motion_.clip.frames = *frames;
    return true;
  }

  bool frame_time() {
    double& time = motion_.clip.frame_time;
    if (!expect("Frame") || !expect("Time") || !expect(":")) return false;
    if (!number(time, "the frame time in seconds")) return false;
    if (time >= kMinFrameTime && time <= kMaxFrameTime) return true;
    if (lenient_) {
      doubts_.push_back(say("frame_time_guessed", time, kUsualFrameTime));
      time = kUsualFrameTime;
      return true;
    }
    return fail_here(say("frame_time", time, kMinFrameTime, kMaxFrameTime));
  }

  [[nodiscard]] std::size_t value_count() const {
    return static_cast<std::size_t>(motion_.clip.frames) * channels_.size();
  }

  bool too_few(std::size_t found) {
    cut_ = true;
    return fail_here(say("bvh_cut", found, value_count(), motion_.clip.frames, channels_.size()));
  }

  // checked before memory is taken: whether the text can hold the values, and memory the result
  bool values_fit() {
    if (channels_.empty() && motion_.clip.frames > 1) {
      return fail_here(say("no_channels", motion_.clip.frames));
    }
    promised_ = motion_.clip.frames;
    // a value takes a digit and, except for the last, a blank
    const std::size_t values = (cursor_.bytes_left() + 1) / 2;
    if (lenient_ && values < value_count()) {
      motion_.clip.frames = static_cast<int>(values / channels_.size());
    }
    const std::size_t transforms =
        static_cast<std::size_t>(motion_.clip.frames) * motion_.skeleton.nodes.size();
    if (transforms > kBvhMaxTransforms) {
      return fail_here(say("frames_of_joints", motion_.clip.frames, motion_.skeleton.nodes.size(),
                           kBvhMaxTransforms));
    }
    if (values >= value_count()) return true;
    std::size_t found = 0;
    while (!cursor_.token().empty()) ++found;
    return too_few(found);
  }

  bool values() {
    std::vector<LocalTransform>& local = motion_.clip.local;
    const std::size_t nodes = motion_.skeleton.nodes.size();
    local.resize(static_cast<std::size_t>(motion_.clip.frames) * nodes);
    for (std::size_t i = 0; i < local.size(); ++i) {
      local[i].translation = motion_.skeleton.nodes[i % nodes].offset;
    }
    for (int frame = 0; frame < motion_.clip.frames; ++frame) {
      if (frame_values(frame, local.data() + index(frame) * nodes)) continue;
      if (!cut_ || !lenient_) return false;
      motion_.clip.frames = frame;
      if (!unread_.empty() && unread_.back() == frame) unread_.pop_back();
    }
    local.resize(index(motion_.clip.frames) * nodes);
    if (!unread_.empty()) doubts_.push_back(say("bvh_unread", unread_.size(), unread_.front()));
    if (motion_.clip.frames == promised_) return nothing_follows();
    doubts_.push_back(say("bvh_stops", motion_.clip.frames, promised_));
    return true;
  }

  // Tolerates one missing frame: some writers count frames from 0.
  bool nothing_follows() {
    std::string_view token = cursor_.token();
    if (token.empty()) return true;
    const std::size_t columns = channels_.size();
    fail_here(say("found_after", shown_token(token), value_count(), motion_.clip.frames));
    std::size_t extra = 0;
    const auto is_value = [&] {
      return parse_number(token) || (lenient_ && tells_no_number(token));
    };
    while (!token.empty() && is_value() && (lenient_ || extra <= columns)) {
      ++extra;
      token = cursor_.token();
    }
    if (!token.empty() || extra == columns) return token.empty();
    if (!lenient_ || columns == 0 || extra % columns != 0) return false;
    doubts_.push_back(say("bvh_goes_on", motion_.clip.frames, extra / columns));
    return true;
  }

  bool frame_values(int frame, LocalTransform* local) {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const std::string_view token = cursor_.token();
      if (token.empty()) return too_few(index(frame) * channels_.size() + i);
      const std::optional<double> value = parse_number(token);
      // the comparison is false for NaN
      if (!value || !(*value >= -kBvhMaxValue && *value <= kBvhMaxValue)) {
        if (lenient_ && (value || tells_no_number(token))) {
          if (unread_.empty() || unread_.back() != frame) unread_.push_back(frame);
          continue;
        }
        return fail_here(say("value_no_number", shown_token(token), i + 1, frame + 1, -kBvhMaxValue,
                             kBvhMaxValue));
      }
      apply(channels_[i], *value, local[channels_[i].node]);
    }
    return true;
  }

  static void apply(const Channel& channel, double value, LocalTransform& local) {
    if (!channel.rotates) {
      local.translation[static_cast<int>(channel.axis)] = value;
      return;
    }
    // full turns are removed first, exactly: sin_cos is for moderate angles
    constexpr double kTurn = 360.0;
    if (abs(value) > kTurn) value -= kTurn * static_cast<double>(static_cast<int>(value / kTurn));
    local.rotation = local.rotation * axis_rotation(channel.axis, radians(value));
  }

  Cursor cursor_;
  std::string_view name_;
  bool lenient_;      // damaged files are read as far as possible
  bool cut_ = false;  // the text ended among the values
  int promised_ = 0;  // frames
  std::vector<Message> doubts_;
  std::vector<int> unread_;
  SkeletonMotion motion_;
  NodeNames names_;
  std::vector<Seen> seen_;         // (nodes)
  std::vector<int> open_;          // nodes with a pending }, outermost first
  std::vector<Channel> channels_;  // columns of the motion
  Error error_;
};

}  // namespace

Result<BvhFile> parse_bvh_file(std::string_view text, std::string_view name, BvhFaults faults) {
  if (text.size() > kBvhMaxBytes) {
    return fail(ErrorCode::parse, say("bytes_most", text.size(), kBvhMaxBytes), std::string(name));
  }
  return BvhReader(text, name, faults).read();
}

Result<SkeletonMotion> parse_bvh(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(BvhFile file, parse_bvh_file(text, name));
  return std::move(file.motion);
}

Result<SkeletonMotion> read_bvh(const std::filesystem::path& path) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(path, kBvhMaxBytes));
  return parse_bvh(text, path.filename().string());
}

}  // namespace shigusa
