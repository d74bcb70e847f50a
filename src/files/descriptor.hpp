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

// Owner of an open file or folder. Its number is never that of a standard stream: if one of these
// is closed, printed text would end up in the file.
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

  // Releases the number; the caller closes it.
  [[nodiscard]] int release() { return std::exchange(number_, -1); }

  // Closes it; returns 0 or errno, as a full disk may be reported only then.
  [[nodiscard]] int close();

 private:
  friend Descriptor open_at(int folder, const char* name, int flags);
  explicit Descriptor(int number) : number_(number) {}

  int number_ = -1;
};

// openat() of a name in a folder (AT_FDCWD: the working directory), with close-on-exec. On failure
// the descriptor is empty and errno is set. Waits for the other end of a pipe unless O_NONBLOCK is
// given. The flags are the system's; other rooms use open_to_read and open_folder.
[[nodiscard]] Descriptor open_at(int folder, const char* name, int flags);

// Opens a file for reading, without waiting.
[[nodiscard]] Descriptor open_to_read(const std::filesystem::path& path);

// Writes all bytes; returns 0 or errno.
[[nodiscard]] int write_all(const Descriptor& file, std::string_view bytes);

// Reads the next bytes of a file; 0 at its end, negative on failure, with errno.
[[nodiscard]] std::ptrdiff_t read_some(const Descriptor& file, char* block, std::size_t size);

// Reads bytes at an offset of a file; false if it has fewer, or on failure.
[[nodiscard]] bool read_at(const Descriptor& file, std::uint64_t at, char* block, std::size_t size);

// Sets the file offset for reading and writing; returns 0 or errno.
[[nodiscard]] int go_to(const Descriptor& file, std::uint64_t at);

// Moves to the end of a file; returns its size, or empty on failure, with errno.
[[nodiscard]] std::optional<std::uint64_t> go_to_end(const Descriptor& file);

// Message "PATH: cannot ACTION: " and the text of errno.
[[nodiscard]] tl::unexpected<Error> refused(const std::filesystem::path& path, const char* action,
                                            int reason);

}  // namespace shigusa
