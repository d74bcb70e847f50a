// SPDX-License-Identifier: MIT
#include "failure.hpp"

#include <pthread.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

namespace shigusa::door {
namespace {

struct Failure {
  // a fixed buffer, available even without memory
  char text[1024] = "";
  Error error{};  // with a default code for failures that have only a text
};

// Placeholder for a failure without memory.
char no_memory = 0;

void forget(void* kept) {
  if (kept != &no_memory) delete static_cast<Failure*>(kept);
}

// Storage of each thread's failure. A thread_local object would end the program if memory for
// registering its destructor were missing.
class Key {
 public:
  Key() : there_(pthread_key_create(&key_, forget) == 0) {}
  ~Key() {
    if (!there_) return;
    forget(kept());
    pthread_key_delete(key_);
    there_ = false;
  }
  Key(const Key&) = delete;
  Key& operator=(const Key&) = delete;

  [[nodiscard]] void* kept() const { return there_ ? pthread_getspecific(key_) : nullptr; }
  [[nodiscard]] bool keep(void* value) const {
    return there_ && pthread_setspecific(key_, value) == 0;
  }

 private:
  pthread_key_t key_{};
  bool there_;
};
Key key;

Failure* kept_failure() {
  void* const kept = key.kept();
  return kept == &no_memory ? nullptr : static_cast<Failure*>(kept);
}

// The thread's failure, allocated on first use; null without memory.
Failure* made_failure() noexcept {
  if (Failure* const kept = kept_failure()) return kept;
  auto* const made = new (std::nothrow) Failure;
  if (made != nullptr && key.keep(made)) return made;
  delete made;
  (void)key.keep(&no_memory);
  return nullptr;
}

// Longest prefix of a UTF-8 text that fits, cut at a character boundary.
std::size_t fitting(std::string_view text) {
  std::size_t size = std::min(text.size(), sizeof(Failure::text) - 1);
  const auto continues = [&](std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  while (size > 0 && continues(size)) --size;
  return size;
}

void put(std::string_view text, Failure& failure) {
  const std::size_t size = fitting(text);
  // the caller may pass back the pointer that it was given
  std::memmove(failure.text, text.data(), size);
  failure.text[size] = '\0';
}

}  // namespace

void keep_failure(std::string_view text) noexcept {
  Failure* const failure = made_failure();
  if (failure == nullptr) return;
  put(text, *failure);
  failure->error = {};
}

void keep_failure(Error error) {
  const std::string text = error.to_string();
  Failure* const failure = made_failure();
  if (failure == nullptr) throw std::bad_alloc();
  put(text, *failure);
  failure->error = std::move(error);
}

const char* failure_text() noexcept {
  if (key.kept() == &no_memory) return "out of memory";
  const Failure* const failure = kept_failure();
  return failure == nullptr ? "" : failure->text;
}

const Error* failure_error() noexcept {
  const Failure* const failure = kept_failure();
  return failure == nullptr || failure->error.message.empty() ? nullptr : &failure->error;
}

}  // namespace shigusa::door
