#!/bin/sh
# SPDX-License-Identifier: MIT
# check_messages.sh [ROOT]: fails if an error or a doubt has a text of its own instead of a sentence of the
# catalogue (src/core/messages), which pages translate: say("no_goal") and not "no goal: …".
set -eu
cd "${1:-$(dirname "$0")/..}"

# Exceptions, texts that no page shows: errors of the operating system about files and folders (files/file,
# files/descriptor, document/result_folder, document/result_store), the library's own faulty tables (formats/csv),
# settings of strip figures, which are options of the command line (draw), data sets (dataset) and the tools of
# assistants (assistant). The command line and the C interface (apps, bindings) are in English.
files=$(find src include -type f \( -name '*.hpp' -o -name '*.cpp' \) ! -path 'src/core/*' ! -path 'src/draw/*' ! -path 'src/assistant/*' \
  ! -path src/files/file.cpp ! -path src/files/descriptor.cpp ! -path src/formats/csv.cpp \
  ! -path src/document/result_folder.cpp ! -path src/document/result_store.cpp | LC_ALL=C sort) || true
[ -n "$files" ] || { echo "check_messages: no sources below $(pwd)" >&2; exit 1; }

# shellcheck disable=SC2086  # no path in the project holds a space
awk '
function line_at(place,   n) {
  for (n = lines; n > 1 && start[n] > place; --n) {}
  return n
}
function find_in(pattern,   rest, before) {
  before = 0
  rest = all
  while (match(rest, pattern)) {
    printf "%s:%d: no sentence of the catalogue: %s\n", file, line_at(before + RSTART), substr(rest, RSTART, RLENGTH + 40)
    bad = 1
    before += RSTART + RLENGTH - 1
    rest = substr(all, before + 1)
  }
}
function look() {
  find_in("fail\\(ErrorCode::[a-z_]+, (R?\"|fmt::format\\(|std::string\\(|[^,;(]*\\+ R?\")")
  find_in("(fail_at|wrong|fail_here|wrong_[a-z]+|unreadable)\\((\"[^\"]*\", |[^\"();]*(\\([^\"()]*\\))?[^\"();]*, )?(\"[^\"]*\"( \"[^\"]*\")*\\)|fmt::format\\()")
  find_in("doubts[_a-z.]*\\.(push_back|emplace_back)\\((\"|fmt::format\\(|std::string\\()")
  all = ""
}
FNR == 1 { if (file != "") look(); file = FILENAME }
{
  sub(/^[ \t]+/, "")
  sub(/^\/\/.*/, "")
  if (all !~ /\($/) all = all " "
  start[FNR] = length(all) + 1
  lines = FNR
  all = all $0
}
END { look(); exit bad }
' $files
