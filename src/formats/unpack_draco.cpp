// SPDX-License-Identifier: MIT
#include <draco/compression/decode.h>

#include <cstring>

#include "core/say.hpp"
#include "unpack.hpp"

namespace shigusa {
namespace {

struct Counts {
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

// Declared size of a mesh, read before memory is taken for it. For Draco 2.2, the version of glTF.
class DracoHeader {
 public:
  explicit DracoHeader(std::string_view bytes) : bytes_(bytes) {}

  std::optional<Counts> read() {
    constexpr std::string_view kStart{"DRACO\x02\x02\x01", 8};  // a mesh
    if (!bytes_.starts_with(kStart)) return std::nullopt;
    at_ = kStart.size();
    const bool sequential = byte() == 0;
    const std::size_t low = byte();
    constexpr std::size_t kMetadata = 0x8000;
    if (((low | byte() << 8) & kMetadata) != 0) skip_metadata();
    if (!sequential) byte();  // the edge decoder
    const std::size_t first = number();
    const std::size_t second = number();
    if (!whole_) return std::nullopt;
    return sequential ? Counts{second, first} : Counts{first, second};
  }

 private:
  std::size_t byte() {
    whole_ = whole_ && at_ < bytes_.size();
    return whole_ ? static_cast<unsigned char>(bytes_[at_++]) : 0;
  }

  // Variable-length integer in groups of seven bits.
  std::size_t number() {
    std::size_t value = 0;
    for (int shift = 0; shift < 63; shift += 7) {
      const std::size_t piece = byte();
      value |= (piece & 127) << shift;
      if (piece < 128) return value;
    }
    whole_ = false;
    return 0;
  }

  void skip(std::size_t count) {
    whole_ = whole_ && count <= bytes_.size() - at_;
    if (whole_) at_ += count;
  }

  void skip_metadata() {
    for (std::size_t left = number(); left > 0 && whole_; --left) {
      number();
      skip_element(0);
    }
    skip_element(0);
  }

  void skip_element(int depth) {
    constexpr int kMaxDepth = 16;
    whole_ = whole_ && depth < kMaxDepth;
    for (std::size_t left = whole_ ? number() : 0; left > 0 && whole_; --left) {
      skip(byte());
      skip(number());
    }
    for (std::size_t left = whole_ ? number() : 0; left > 0 && whole_; --left) {
      skip(byte());
      skip_element(depth + 1);
    }
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  bool whole_ = true;  // so far
};

// Mesh that checks declared attribute sizes before the decoder allocates them: a few bytes can
// declare gigabytes.
class CountedMesh : public draco::Mesh {
 public:
  explicit CountedMesh(std::size_t& room) : room_(room) {}

  void SetAttribute(int id, std::unique_ptr<draco::PointAttribute> attribute) override {
    const auto each = static_cast<std::size_t>(std::max<std::int64_t>(attribute->byte_stride(), 4));
    const std::size_t points = num_points();
    // encoded values, decoded values, and the map from points to values
    constexpr std::size_t kCopies = 3;
    if (points > room_ / (kCopies * each)) throw say("unpacked_bytes", kUnpackedMaxBytes);
    room_ -= points * kCopies * each;
    Mesh::SetAttribute(id, std::move(attribute));
  }

 private:
  std::size_t& room_;
};

template <class Number>
bool put(const draco::PointAttribute& attribute, int components, std::size_t points,
         std::string& into) {
  std::vector<Number> values(static_cast<std::size_t>(components));
  const std::size_t size = values.size() * sizeof(Number);
  into.resize(points * size);
  for (std::size_t i = 0; i < points; ++i) {
    const auto value = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
    if (value.value() >= attribute.size() ||
        !attribute.ConvertValue(value, static_cast<std::int8_t>(components), values.data())) {
      return false;
    }
    std::memcpy(into.data() + i * size, values.data(), size);
  }
  return true;
}

bool put_kind(const draco::PointAttribute& attribute, const DracoAttribute& as, std::size_t points,
              std::string& into) {
  const auto& [bytes, largest, has_sign] = as.kind;
  if (largest == 0.0) return put<float>(attribute, as.components, points, into);
  if (bytes == 4) return put<std::uint32_t>(attribute, as.components, points, into);
  if (bytes == 2) {
    return has_sign ? put<std::int16_t>(attribute, as.components, points, into)
                    : put<std::uint16_t>(attribute, as.components, points, into);
  }
  return has_sign ? put<std::int8_t>(attribute, as.components, points, into)
                  : put<std::uint8_t>(attribute, as.components, points, into);
}

void put_corners(const draco::Mesh& mesh, std::string& into) {
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
    for (const draco::PointIndex& corner : mesh.face(face)) {
      const std::uint32_t index = corner.value();
      into.append(reinterpret_cast<const char*>(&index), sizeof index);
    }
  }
}

Result<DracoMesh> values_of(const draco::Mesh& mesh, std::span<const DracoAttribute> attributes,
                            const std::string& place) {
  DracoMesh found;
  found.points = mesh.num_points();
  for (const DracoAttribute& wanted : attributes) {
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(wanted.id);
    std::string& column = found.columns.emplace_back();
    if (attribute == nullptr || attribute->num_components() != wanted.components ||
        !put_kind(*attribute, wanted, found.points, column)) {
      return fail(ErrorCode::parse, say("draco_attribute", wanted.id, wanted.components), place);
    }
  }
  put_corners(mesh, found.corners);
  return found;
}

}  // namespace

Result<DracoMesh> unpack_draco(std::string_view packed, std::span<const DracoAttribute> attributes,
                               std::size_t& room, const std::string& place) {
  const auto wrong = [&](const Message& why) { return fail(ErrorCode::parse, why, place); };
  const std::optional<Counts> counts = DracoHeader(packed).read();
  if (!counts) return wrong(say("draco_version"));
  // the decoder's state per corner and vertex during decoding of triangles
  constexpr std::size_t kOfFace = 96;
  constexpr std::size_t kOfVertex = 32;
  const auto costs = [&](std::size_t count, std::size_t each) {
    if (count > room / each) return false;
    room -= count * each;
    return true;
  };
  if (!costs(counts->faces, kOfFace) || !costs(counts->vertices, kOfVertex)) {
    return wrong(say("unpacked_bytes", kUnpackedMaxBytes));
  }
  draco::DecoderBuffer buffer;
  buffer.Init(packed.data(), packed.size());
  CountedMesh mesh(room);
  draco::Decoder decoder;
  try {
    if (!decoder.DecodeBufferToGeometry(&buffer, &mesh).ok()) {
      return wrong(say("packed_damaged"));
    }
  } catch (const Message& too_much) {
    return wrong(too_much);
  }
  return values_of(mesh, attributes, place);
}

}  // namespace shigusa
