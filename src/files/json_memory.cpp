// SPDX-License-Identifier: MIT
#include "json_memory.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <new>

#include "pages.hpp"

namespace shigusa {
namespace {

// Fallback blocks in use: few at a time, one per value under destruction.
constexpr std::size_t kMostBlocks = 4096;
std::array<std::atomic<void*>, kMostBlocks> blocks{};
std::atomic<int> taken{0};

// Records a block; false if the table is full.
bool note(void* block) {
  for (std::atomic<void*>& place : blocks) {
    void* none = nullptr;
    if (place.compare_exchange_strong(none, block)) {
      ++taken;
      return true;
    }
  }
  return false;
}

bool forget(void* block) {
  for (std::atomic<void*>& place : blocks) {
    void* own = block;
    if (place.compare_exchange_strong(own, nullptr)) {
      --taken;
      return true;
    }
  }
  return false;
}

}  // namespace

void* take_list_memory(std::size_t bytes) {
  if (void* const memory = ::operator new(bytes, std::nothrow)) return memory;
  void* const block = take_pages(bytes);
  if (block == nullptr) throw std::bad_alloc();
  if (note(block)) return block;
  give_pages(block, bytes);
  throw std::bad_alloc();
}

void give_list_memory(void* memory, std::size_t bytes) noexcept {
  // fallback blocks are page-aligned, and others hardly ever
  constexpr std::uintptr_t kPage = 4096;
  const bool page = reinterpret_cast<std::uintptr_t>(memory) % kPage == 0;
  if (page && memory != nullptr && taken.load(std::memory_order_relaxed) > 0 && forget(memory)) {
    give_pages(memory, bytes);
  } else {
    ::operator delete(memory);
  }
}

}  // namespace shigusa
