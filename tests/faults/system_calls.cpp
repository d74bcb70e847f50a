// SPDX-License-Identifier: MIT
#include "faults/system_calls.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>

namespace shigusa::testing_support {
namespace {

Fault armed = Fault::none;
int faulty_call = 0;
int calls = 0;

// Runs a counted call; `full` is its behaviour on a full disk.
template <class Call, class Full>
auto counted(Call&& call, Full&& full) -> decltype(call()) {
  if (armed == Fault::none) return call();
  ++calls;
  if (armed == Fault::disk_full && calls >= faulty_call) return full();
  if (calls != faulty_call) return call();
  if (armed == Fault::killed_after) call();
  kill(getpid(), SIGKILL);
  return call();
}

template <class Call>
auto counted(Call&& call) -> decltype(call()) {
  return counted(call, [&]() -> decltype(call()) {
    errno = ENOSPC;
    return -1;
  });
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

void arm(Fault fault, int call) {
  armed = fault;
  faulty_call = call;
  calls = 0;
}

int calls_made() { return calls; }

}  // namespace shigusa::testing_support

using namespace shigusa::testing_support;

extern "C" {

ssize_t write(int file, const void* bytes, size_t size) {
  static auto* const system = real<decltype(write)>("write");
  const auto call = [&] { return system(file, bytes, size); };
  return counted(call, [&]() -> ssize_t {
    if (size > 1) return system(file, bytes, size / 2);
    errno = ENOSPC;
    return -1;
  });
}

// fsync does nothing: no power fails in these tests, and disks are slow.
int fsync(int) {
  return counted([] { return 0; });
}

int mkdirat(int folder, const char* name, mode_t mode) noexcept {
  static auto* const system = real<int(int, const char*, mode_t)>("mkdirat");
  return counted([&] { return system(folder, name, mode); });
}

int renameat(int from, const char* name, int to, const char* other) noexcept {
  static auto* const system = real<int(int, const char*, int, const char*)>("renameat");
  return counted([&] { return system(from, name, to, other); });
}

// A full disk still deletes files.
int unlinkat(int folder, const char* name, int flags) noexcept {
  static auto* const system = real<int(int, const char*, int)>("unlinkat");
  const auto call = [&] { return system(folder, name, flags); };
  return armed == Fault::disk_full ? call() : counted(call);
}

int openat(int folder, const char* name, int flags, ...) {
  static auto* const system = real<int(int, const char*, int, mode_t)>("openat");
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  const auto call = [&] { return system(folder, name, flags, mode); };
  return (flags & O_CREAT) != 0 ? counted(call) : call();
}

}  // extern "C"
