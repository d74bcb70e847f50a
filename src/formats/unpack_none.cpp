// SPDX-License-Identifier: MIT
// Used in builds without the libraries that unpack meshes, or with Draco alone.
#include "core/say.hpp"
#include "unpack.hpp"

namespace shigusa {

Result<std::string> unpack_meshopt(const MeshoptView&, std::string_view, const std::string& place) {
  return fail(ErrorCode::parse, say("packed_by", "meshopt"), place);
}

#ifndef SHIGUSA_HAS_DRACO
Result<DracoMesh> unpack_draco(std::string_view, std::span<const DracoAttribute>, std::size_t&,
                               const std::string& place) {
  return fail(ErrorCode::parse, say("packed_by", "Draco"), place);
}
#endif

}  // namespace shigusa
