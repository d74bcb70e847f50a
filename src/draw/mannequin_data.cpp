// SPDX-License-Identifier: MIT
#include "mannequin_data.hpp"

#include <zlib.h>

#include "core/check.hpp"

namespace shigusa {

std::string mannequin_data() {
  constexpr int kNoHeader = -MAX_WBITS;
  constexpr std::size_t kMostBytes = std::size_t{1} << 20;
  std::string data(kMostBytes, '\0');
  z_stream stream{};
  // zlib does not write there, but its interface lacks const
  stream.next_in = const_cast<unsigned char*>(kMannequinFile.data());
  stream.avail_in = static_cast<unsigned>(kMannequinFile.size());
  stream.next_out = reinterpret_cast<unsigned char*>(data.data());
  stream.avail_out = static_cast<unsigned>(data.size());
  SHG_CHECK(inflateInit2(&stream, kNoHeader) == Z_OK, "zlib starts");
  const int end = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  SHG_CHECK(end == Z_STREAM_END, "the mannequin is whole");
  data.resize(stream.total_out);
  return data;
}

}  // namespace shigusa
