// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <shigusa/error.hpp>
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
  friend Descriptor open_at(int folder, const char* name, int flags);
  explicit Descriptor(int number) : number_(number) {}

  int number_ = -1;
};

// openat() of a name in a folder (AT_FDCWD: where the program stands), closed in other programs.
// Where it fails the descriptor is none, and errno tells why. A pipe whose other end nobody has is
// waited for, but with O_NONBLOCK. The flags are the system's: of other rooms open_to_read and
// open_folder are asked.
[[nodiscard]] Descriptor open_at(int folder, const char* name, int flags);

// A file, for reading; nothing is waited for.
[[nodiscard]] Descriptor open_to_read(const std::filesystem::path& path);

// Writes all of it; 0, or the system's reason.
[[nodiscard]] int write_all(const Descriptor& file, std::string_view bytes);

// The next bytes of a file; none at its end, and a number below 0, with errno, where it fails.
[[nodiscard]] std::ptrdiff_t read_some(const Descriptor& file, char* block, std::size_t size);

// Reads bytes from a place in a file, all of them; false where it has fewer, or reading fails.
[[nodiscard]] bool read_at(const Descriptor& file, std::uint64_t at, char* block, std::size_t size);

// Goes to a place of a file, from which it is read and written; 0, or the system's reason.
[[nodiscard]] int go_to(const Descriptor& file, std::uint64_t at);

// Goes to the end of a file; its bytes, or none, with errno, where it fails.
[[nodiscard]] std::optional<std::uint64_t> go_to_end(const Descriptor& file);

// "PATH: cannot ACTION: " and the system's reason (errno).
[[nodiscard]] tl::unexpected<Error> refused(const std::filesystem::path& path, const char* action,
                                            int reason);

}  // namespace shigusa
