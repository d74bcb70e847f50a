// SPDX-License-Identifier: MIT
// shigusa_reliability FOLDER TASKS [CHARACTERS [KIND]]: generates motions for random tasks, judges
// them independently of the library, writes FOLDER/reliability.md and prints broken promises.
// CHARACTERS: a folder of further character files. KIND: only tasks of this kind, by its number
// from 0. Exits with 1 if a promise was broken.
#include <algorithm>
#include <atomic>
#include <charconv>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "auditor.hpp"
#include "page.hpp"

namespace {

using namespace shigusa::bench;

// Motions scored per task: a twelfth of the default, as the promises do not depend on the score.
// More motions are possible after a longer search.
constexpr int kEvaluations = 150;

struct Numbered {
  std::uint64_t kind;
  std::uint64_t number;
};

Numbered task_at(std::uint64_t index, std::optional<std::uint64_t> only) {
  if (only) return {*only, index};
  const std::uint64_t kinds = all_kinds().size();
  return {index % kinds, index / kinds};
}

// By kind; threads take tasks in turn. Failures are sorted, so that the output does not depend on
// scheduling.
std::vector<Audit> audit_tasks(const Cast& cast, std::uint64_t tasks,
                               std::optional<std::uint64_t> only) {
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t kinds = all_kinds().size();
  std::vector<std::vector<Auditor>> parts(threads, std::vector(kinds, Auditor(kEvaluations)));
  std::atomic<std::uint64_t> next = 0;
  std::vector<std::thread> running;
  for (std::vector<Auditor>& part : parts) {
    running.emplace_back([&] {
      for (std::uint64_t i = next++; i < tasks; i = next++) {
        const auto [k, number] = task_at(i, only);
        const Kind& kind = all_kinds()[k];
        part[k].take(kind, kind.draw(cast, number));
        if (i % 1000 == 999) std::cerr << i + 1 << " tasks\n";
      }
    });
  }
  for (std::thread& thread : running) thread.join();
  std::vector<Audit> sums(kinds);
  for (const std::vector<Auditor>& part : parts) {
    for (std::size_t k = 0; k < kinds; ++k) sums[k].add(part[k].audit());
  }
  for (Audit& sum : sums) std::sort(sum.failures.begin(), sum.failures.end());
  return sums;
}

std::optional<std::uint64_t> number_in(std::string_view word) {
  std::uint64_t number = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec != std::errc() || read.ptr != word.data() + word.size()) return std::nullopt;
  return number;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  const auto tasks = words.size() > 1 ? number_in(words[1]) : std::nullopt;
  const auto only = words.size() > 3 ? number_in(words[3]) : std::nullopt;
  if (words.size() > 4 || !tasks || *tasks == 0 || only.value_or(0) >= all_kinds().size()) {
    std::cerr << "usage: shigusa_reliability FOLDER TASKS [CHARACTERS [KIND]]\n";
    return 2;
  }
  const Cast cast = load_cast(words.size() > 2 ? std::string(words[2]) : std::string());
  for (const std::string& absent : cast.absent) std::cerr << "left out: " << absent << "\n";
  const std::vector<Audit> kinds = audit_tasks(cast, *tasks, only);
  std::ofstream(std::string(words[0]) + "/reliability.md")
      << reliability_page(kinds, cast, kEvaluations);
  std::cerr << kinds_log(kinds);
  for (const Audit& kind : kinds) {
    for (const std::string& failure : kind.failures) std::cout << failure << "\n\n";
  }
  const bool kept = std::all_of(kinds.begin(), kinds.end(),
                                [](const Audit& kind) { return kind.failures.empty(); });
  return kept ? 0 : 1;
}
