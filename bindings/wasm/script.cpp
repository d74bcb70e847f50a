// SPDX-License-Identifier: MIT
// Functions for the module's script alone, beside those of the C interface. Progress comes without
// a table that grows and without code made at run time: the one function that a search reports to
// asks the module's own `report`.
#include <emscripten.h>
#include <shigusa.h>

#include "generate/start_table.hpp"

// clang-format off
EM_JS(int32_t, shigusa_report_to_script, (double fraction, int32_t evaluations, double best_score), {
  return Module["report"](fraction, evaluations, best_score) ? 1 : 0;
});
// clang-format on

namespace {

int32_t report(void*, double fraction, int32_t evaluations, double best_score) {
  return shigusa_report_to_script(fraction, evaluations, best_score);
}

constexpr shigusa_watch kWatch{report, nullptr};

}  // namespace

extern "C" {

// shigusa_generate gets this where the caller sets `report`: a function of the share of the
// budget, motions scored and the lowest score, which returns true to stop.
SHIGUSA_API const shigusa_watch* shigusa_script_watch(void);
const shigusa_watch* shigusa_script_watch(void) { return &kWatch; }

// Gives the module its start tables, the `size` bytes of starts.tsv, which it does not hold. Called
// once, before anything is generated. 0 if the bytes are no such tables, 1 otherwise.
SHIGUSA_API int32_t shigusa_script_set_starts(const char* text, uint32_t size);
int32_t shigusa_script_set_starts(const char* text, uint32_t size) {
  return shigusa::set_start_tables({text, size}) && !shigusa::start_tables().empty() ? 1 : 0;
}
}
