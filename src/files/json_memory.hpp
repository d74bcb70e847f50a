// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// nlohmann's JSON with values whose destruction never fails. A value moves its parts into a list
// before destroying them, and a destructor that runs out of memory ends the program. So such a list
// takes memory from the operating system if the C library has none.
namespace shigusa {

[[nodiscard]] void* take_list_memory(std::size_t bytes);
void give_list_memory(void* memory, std::size_t bytes) noexcept;

// Allocator with that fallback.
template <class Value>
struct ListAllocator {
  using value_type = Value;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using propagate_on_container_move_assignment = std::true_type;
  using is_always_equal = std::true_type;

  [[nodiscard]] Value* allocate(std::size_t count) {
    return static_cast<Value*>(take_list_memory(count * sizeof(Value)));
  }
  void deallocate(Value* values, std::size_t count) noexcept {
    give_list_memory(values, count * sizeof(Value));
  }
};

}  // namespace shigusa

// The two variants of JSON values. Sources of the library include this header rather than
// nlohmann's. If that was included before, the fallback is missing; either variant frees the
// other's memory, except for fallback blocks.
#ifndef INCLUDE_NLOHMANN_JSON_HPP_
#define SHIGUSA_LIST_ALLOCATOR(...)                                                                \
  template <>                                                                                      \
  struct std::allocator<__VA_ARGS__> : shigusa::ListAllocator<__VA_ARGS__> {                       \
    constexpr allocator() noexcept = default;                                                      \
    template <class Other>                                                                         \
    constexpr allocator(const std::allocator<Other>&) noexcept {}                                  \
    friend constexpr bool operator==(const allocator&, const allocator&) noexcept { return true; } \
  }
SHIGUSA_LIST_ALLOCATOR(nlohmann::json);
SHIGUSA_LIST_ALLOCATOR(nlohmann::ordered_json);
// called by a value about to become a list or an object, before it has the memory
SHIGUSA_LIST_ALLOCATOR(std::vector<nlohmann::json>);
SHIGUSA_LIST_ALLOCATOR(std::vector<nlohmann::ordered_json>);
SHIGUSA_LIST_ALLOCATOR(std::map<std::string, nlohmann::json, std::less<>,
                                std::allocator<std::pair<const std::string, nlohmann::json>>>);
SHIGUSA_LIST_ALLOCATOR(
    nlohmann::ordered_map<std::string, nlohmann::ordered_json, std::less<>,
                          std::allocator<std::pair<const std::string, nlohmann::ordered_json>>>);
#undef SHIGUSA_LIST_ALLOCATOR
#endif

#include <nlohmann/json.hpp>
