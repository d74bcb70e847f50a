#!/bin/sh
# SPDX-License-Identifier: MIT
# check_paper_map.sh [ROOT]: fails if docs/paper_map.md names code or a test that does not exist.
#
# In its table `b.hpp` is a header of include/shigusa, `a/b.hpp` one below src (or src/a/b.cpp in full),
# `a/b_test.cpp` a test. Other names of code must occur in the file that follows them after "in", or else anywhere.
set -eu
cd "${1:-$(dirname "$0")/..}"

map=docs/paper_map.md
words=$(mktemp)
trap 'rm -f "$words"' EXIT
{ find include src apps tests -type f 2>/dev/null || true; } | LC_ALL=C sort >"$words"
# lines of FILE or SYMBOL, the line's number, the name, and the file stated for a symbol
LC_ALL=C awk -F '|' '
  function tell(kind, name, file) { print kind "\t" FNR "\t" name "\t" file }
  /^\| *[^-]/ && NF >= 5 {
    for (cell = 4; cell <= 5; ++cell) {
      parts = split($cell, part, "`")
      count = 0
      for (i = 2; i <= parts; i += 2) {
        name = part[i]
        if (name ~ /^[a-z_\/]+\.(hpp|cpp)$/) {
          tell("FILE", name)
          if (part[i - 1] ~ / in $/) while (count > 0) tell("SYMBOL", waiting[count--], name)
        } else if (name ~ /^[A-Za-z_:]+$/) {
          waiting[++count] = name
        }
        # names before a semicolon may occur anywhere
        if (part[i + 1] ~ /;/) while (count > 0) tell("SYMBOL", waiting[count--], "")
      }
      while (count > 0) tell("SYMBOL", waiting[count--], "")
    }
  }' "$map" | {
  bad=0
  named=0
  while IFS="$(printf '\t')" read -r kind line name file; do
    named=$((named + 1))
    of=$name
    [ "$kind" = FILE ] || of=$file
    paths=
    if [ -n "$of" ]; then
      paths=$(grep -E "(^|^include/shigusa/|^src/|^tests/)$of\$" "$words" || true)
      [ -n "$paths" ] || {
        echo "$map:$line: no file $of"
        bad=1
        continue
      }
    fi
    [ "$kind" = SYMBOL ] || continue
    # shellcheck disable=SC2086  # no path in the project holds a space
    grep -qwrs -- "${name##*::}" ${paths:-include src apps} || {
      echo "$map:$line: no $name in ${of:-the sources}"
      bad=1
    }
  done
  [ "$named" -gt 0 ] || {
    echo "$map names nothing"
    bad=1
  }
  exit "$bad"
}
