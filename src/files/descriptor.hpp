// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <shigusa/result.hpp>
#include <string_view>
#include <utility>

namespace shigusa {

// A file or folder that is open, closed when this goes. Its number is never one of the standard
// streams': with these closed, what is printed would go to a file.
class Descriptor {
 public:
  Descriptor() = default;
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { (void)close(); }

  [[nodiscard]] int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }

  // The number, for somebody else to close.
  [[nodiscard]] int release() { return std::exchange(number_, -1); }

  // 0, or the system's reason: a full disk may show only now.
  [[nodiscard]] int close();

 private:
  friend Descriptor open_at(int folder, const char* name, int flags, mode_t mode);
  explicit Descriptor(int number) : number_(number) {}

  int number_ = -1;
};

// openat() of a name in a folder (AT_FDCWD: where the program stands), closed in other programs.
// Where it fails the descriptor is none, and errno tells why. A pipe whose other end nobody has is
// waited for, but with O_NONBLOCK.
[[nodiscard]] Descriptor open_at(int folder, const char* name, int flags, mode_t mode = 0666);

// Writes all of it; 0, or the system's reason.
[[nodiscard]] int write_all(const Descriptor& file, std::string_view bytes);

// The next bytes of a file; none at its end, and a number below 0, with errno, where it fails.
[[nodiscard]] ssize_t read_some(const Descriptor& file, char* block, std::size_t size);

// "PATH: cannot ACTION: " and the system's reason (errno).
[[nodiscard]] tl::unexpected<Error> refused(const std::filesystem::path& path, const char* action,
                                            int reason);

}  // namespace shigusa
