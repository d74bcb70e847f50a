// SPDX-License-Identifier: MIT
#include "memory/failing_malloc.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);
}

namespace shigusa::testing_support {
namespace {

thread_local Lack lacking = Lack::none;
thread_local long lacking_at = 0;
thread_local long made = 0;
std::atomic<long> held{0};

bool is_refused() {
  ++made;
  if (lacking == Lack::none || made < lacking_at) return false;
  return lacking == Lack::from_then || made == lacking_at;
}

template <class Take>
void* counted(Take&& take) {
  void* const memory = is_refused() ? nullptr : take();
  if (memory == nullptr) {
    errno = ENOMEM;
  } else {
    ++held;
  }
  return memory;
}

}  // namespace

void run_out(Lack lack, long allocation) {
  lacking = lack;
  lacking_at = allocation;
  made = 0;
}

long allocations() { return made; }
long blocks() { return held; }

}  // namespace shigusa::testing_support

using shigusa::testing_support::counted;
using shigusa::testing_support::held;

extern "C" {

void* malloc(std::size_t size) noexcept {
  return counted([size] { return __libc_malloc(size); });
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  return counted([count, size] { return __libc_calloc(count, size); });
}
void* realloc(void* memory, std::size_t size) noexcept {
  if (memory == nullptr) return malloc(size);
  if (shigusa::testing_support::is_refused()) {
    errno = ENOMEM;
    return nullptr;
  }
  void* const moved = __libc_realloc(memory, size);
  if (moved == nullptr && size == 0) --held;
  return moved;
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return counted([alignment, size] { return __libc_memalign(alignment, size); });
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  void* const taken = memalign(alignment, size);
  if (taken == nullptr) return ENOMEM;
  *memory = taken;
  return 0;
}
void free(void* memory) noexcept {
  if (memory != nullptr) --held;
  __libc_free(memory);
}

}  // extern "C"
