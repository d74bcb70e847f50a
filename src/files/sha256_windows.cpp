// SPDX-License-Identifier: MIT
#include <windows.h>
// after windows.h
#include <bcrypt.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sha256.hpp"

namespace shigusa {
namespace {

// SHA-256 of blocks, by the system's cryptography.
class Sum {
 public:
  Sum() {
    if (BCryptOpenAlgorithmProvider(&provider_, BCRYPT_SHA256_ALGORITHM, nullptr, 0) != 0) return;
    works_ = BCryptCreateHash(provider_, &hash_, nullptr, 0, nullptr, 0, 0) == 0;
  }
  ~Sum() {
    if (hash_ != nullptr) (void)BCryptDestroyHash(hash_);
    if (provider_ != nullptr) (void)BCryptCloseAlgorithmProvider(provider_, 0);
  }
  Sum(const Sum&) = delete;
  Sum& operator=(const Sum&) = delete;

  void add(const char* bytes, std::size_t size) {
    auto* const first = reinterpret_cast<UCHAR*>(const_cast<char*>(bytes));
    works_ = works_ && BCryptHashData(hash_, first, static_cast<ULONG>(size), 0) == 0;
  }

  // Empty if the system cannot.
  std::string digits() {
    std::array<UCHAR, 32> sum{};
    const auto size = static_cast<ULONG>(sum.size());
    if (!works_ || BCryptFinishHash(hash_, sum.data(), size, 0) != 0) return {};
    return fmt::format("{:02x}", fmt::join(sum, ""));
  }

 private:
  BCRYPT_ALG_HANDLE provider_ = nullptr;
  BCRYPT_HASH_HANDLE hash_ = nullptr;
  bool works_ = false;
};

constexpr std::size_t kBlock = 1 << 16;

}  // namespace

std::string sha256(std::string_view bytes) {
  Sum sum;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kBlock))) {
    sum.add(bytes.data(), std::min(bytes.size(), kBlock));
  }
  return sum.digits();
}

std::string sha256_of(const Descriptor& file) {
  Sum sum;
  char block[kBlock];
  for (;;) {
    const std::ptrdiff_t count = read_some(file, block, sizeof block);
    if (count < 0) return {};
    if (count == 0) return sum.digits();
    sum.add(block, static_cast<std::size_t>(count));
  }
}

}  // namespace shigusa
