// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <shigusa/error.hpp>
#include <string_view>
#include <utility>

// The calls of the operating system that other files here make. system_posix.cpp implements
// descriptor.hpp, folder.hpp and pages.hpp, system_windows.cpp does for Windows. Paths and names
// are UTF-8.
namespace shigusa {

// Owner of an open file or folder.
class Descriptor {
 public:
  Descriptor() = default;
  // Takes over the system's number or, of Windows, its handle; -1 is none.
  explicit Descriptor(std::intptr_t number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept
      : number_(std::exchange(other.number_, -1)), lock_(std::exchange(other.lock_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    std::swap(lock_, other.lock_);
    return *this;
  }
  ~Descriptor() { (void)close(); }

  // Never that of a standard stream: if one of these is closed, printed text would end up in the
  // file.
  [[nodiscard]] std::intptr_t number() const { return number_; }
  explicit operator bool() const { return number_ != -1; }

  // Releases the number; the caller closes it.
  [[nodiscard]] std::intptr_t release() { return std::exchange(number_, -1); }

  // Closes it; returns 0 or errno, as a full disk may be reported only then.
  [[nodiscard]] int close();

 private:
  friend struct LockOf;

  std::intptr_t number_ = -1;
  mutable std::intptr_t lock_ = -1;  // of Windows, where a folder itself cannot be locked
};

// The functions that open return an empty descriptor on failure, and set errno.

// Opens a file for reading, without waiting for the other end of a pipe.
[[nodiscard]] Descriptor open_to_read(const std::filesystem::path& path);
// Lets reads of it wait.
[[nodiscard]] int let_wait(const Descriptor& file);
// Opens a device for writing.
[[nodiscard]] Descriptor open_to_write(const std::filesystem::path& path);

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
