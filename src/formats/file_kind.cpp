// SPDX-License-Identifier: MIT
#include "formats/file_kind.hpp"

#include <array>
#include <optional>
#include <shigusa/formats.hpp>

#include "core/say.hpp"
#include "core/text.hpp"

namespace shigusa {
namespace {

using Known = Sentence<>;

constexpr std::string_view kXmlBlanks = " \t\r\n";
constexpr std::size_t kLooked = 65536;  // bytes that are examined for the kind

// A kind of file with its first bytes, its name, and the remedy.
struct ForeignKind {
  std::string_view begin;
  Known called;
  Known advice;
};

// Kinds that are not readable.
const std::array kForeign{
    ForeignKind{"PK\x03\x04", "kind_zip", "advice_unpack"},
    ForeignKind{"7z\xBC\xAF\x27\x1C", "kind_archive", "advice_unpack"},
    ForeignKind{"Rar!\x1A\x07", "kind_archive", "advice_unpack"},
    ForeignKind{"\x1F\x8B", "kind_compressed", "advice_unpack"},
    ForeignKind{"BZh", "kind_compressed", "advice_unpack"},
    ForeignKind{"\xFD"
                "7zXZ",
                "kind_compressed", "advice_unpack"},
    ForeignKind{"\x28\xB5\x2F\xFD", "kind_compressed", "advice_unpack"},
    ForeignKind{"version https://git-lfs", "kind_lfs", "advice_lfs"},
    ForeignKind{"/annex/objects/", "kind_annex", "advice_annex"},
    ForeignKind{"\x89PNG", "kind_picture", "advice_other"},
    ForeignKind{"\xFF\xD8\xFF", "kind_picture", "advice_other"},
    ForeignKind{"GIF8", "kind_picture", "advice_other"},
    ForeignKind{"%PDF-", "kind_pdf", "advice_other"},
    ForeignKind{"BLENDER", "kind_blend", "advice_export"},
    ForeignKind{"PXR-USDC", "kind_usd", "advice_export"},
    ForeignKind{"#usda", "kind_usd", "advice_export"},
    ForeignKind{"PMX ", "kind_mmd", "advice_export"},
    ForeignKind{"Vocaloid Motion Data", "kind_mmd", "advice_export"},
    ForeignKind{"ply\n", "kind_mesh", "advice_other"},
    ForeignKind{"solid ", "kind_mesh", "advice_other"},
    ForeignKind{"\xFF\xFE", "kind_utf_sixteen", "advice_utf_eight"},
    ForeignKind{"\xFE\xFF", "kind_utf_sixteen", "advice_utf_eight"},
};

std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(kXmlBlanks);
  return begin == text.npos ? std::string_view{} : text.substr(begin);
}

// Name of a text's first element; "" if it is no XML.
std::string root_of_xml(std::string_view text) {
  for (;;) {
    if (!text.starts_with('<')) return {};
    const bool comment = text.starts_with("<!--");
    if (!comment && !text.starts_with("<?") && !text.starts_with("<!")) break;
    const std::size_t end = text.find(comment ? "-->" : ">");
    if (end == text.npos) return {};
    text = without_mark(text.substr(end + (comment ? 3 : 1)));
  }
  return std::string(text.substr(1, text.find_first_of(" \t\r\n/>", 1) - 1));
}

// Kind by the root element of a format with another ending.
struct XmlKind {
  std::string_view root;
  Known called;
  Known advice;
  std::optional<FileFormat> format;
};
const std::array kXml{
    XmlKind{"robot", "kind_urdf", "advice_urdf", FileFormat::urdf},
    XmlKind{"mujoco", "kind_mjcf", "advice_mjcf", FileFormat::mjcf},
    XmlKind{"mujocoinclude", "kind_mjcf", "advice_mjcf", FileFormat::mjcf},
    XmlKind{"sdf", "kind_sdf", "advice_other", std::nullopt},
    XmlKind{"COLLADA", "kind_collada", "advice_export", std::nullopt},
};

bool is_gltf(FileFormat format) { return format == FileFormat::glb || format == FileFormat::vrm; }

struct FoundKind {
  Message called;
  Message advice;
};

// Kind of a readable format whose ending is another's.
std::optional<FoundKind> other_format(std::string_view bytes, std::string_view text,
                                      FileFormat format) {
  if (bytes.starts_with("glTF") && !is_gltf(format)) {
    return FoundKind{say("kind_glb"), say("advice_glb")};
  }
  const bool fbx = bytes.starts_with("Kaydara FBX Binary") || text.starts_with("; FBX");
  if (fbx && format != FileFormat::fbx) return FoundKind{say("kind_fbx"), say("advice_fbx")};
  if (text.starts_with("HIERARCHY") && format != FileFormat::bvh) {
    return FoundKind{say("kind_bvh"), say("advice_bvh")};
  }
  if (text.starts_with('{') && !is_gltf(format)) {
    const bool gltf = text.find("\"asset\"") != text.npos;
    return gltf ? FoundKind{say("kind_gltf"), say("advice_gltf")}
                : FoundKind{say("kind_json"), say("advice_other")};
  }
  const std::string root = root_of_xml(text);
  if (root.empty()) return std::nullopt;
  for (const XmlKind& kind : kXml) {
    if (kind.root != root) continue;
    if (kind.format == format) return std::nullopt;
    return FoundKind{say(kind.called), say(kind.advice)};
  }
  const bool xml = format == FileFormat::urdf || format == FileFormat::mjcf;
  if (xml) return std::nullopt;
  return FoundKind{say("kind_xml"), say("advice_other")};
}

std::optional<FoundKind> other_kind(std::string_view bytes, FileFormat format) {
  for (const ForeignKind& kind : kForeign) {
    if (bytes.starts_with(kind.begin)) return FoundKind{say(kind.called), say(kind.advice)};
  }
  const std::string_view text = without_mark(bytes);
  const std::string start = lower(std::string(text.substr(0, 15)));
  const bool page = start.starts_with("<!doctype html") || start.starts_with("<html") ||
                    lower(root_of_xml(text)) == "html";
  if (page) return FoundKind{say("kind_html"), say("advice_download")};
  return other_format(bytes, text, format);
}

}  // namespace

Result<void> check_file_kind(std::string_view bytes, const std::string& name) {
  const std::optional<FileFormat> format = format_of_file(name);
  if (!format) return {};
  const std::optional<FoundKind> found = other_kind(bytes.substr(0, kLooked), *format);
  if (!found) return {};
  return fail(ErrorCode::parse, say("other_kind", found->called, file_ending(name), found->advice),
              name);
}

}  // namespace shigusa
