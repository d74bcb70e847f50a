#!/bin/sh
# SPDX-License-Identifier: MIT
# check_c_math.sh [ROOT [LIBRARY]]: fails if include/ or src/, or the built static LIBRARY, uses a transcendental
# function of the C library. Their results differ in the last bits between C libraries; shigusa/math.hpp has its
# own.
set -eu
cd "${1:-$(dirname "$0")/..}"
library=${2:-}

files=$(find include src -type f \( -name '*.hpp' -o -name '*.h' -o -name '*.cpp' \) | LC_ALL=C sort)
[ -n "$files" ] || { echo "check_c_math: no sources below $(pwd)" >&2; exit 1; }

ours='asin|acos|atan2'   # math.hpp declares these too: only the C library's are refused
theirs='sin|cos|tan|atan|sinh|cosh|tanh|asinh|acosh|atanh|sincos|exp|exp2|expm1|log|log2|log10'
theirs="$theirs|log1p|pow|cbrt|hypot|erf|erfc|tgamma|lgamma"
not_word='([^A-Za-z0-9_]|$)'

qualified="(^|[^A-Za-z0-9_])(std)?[[:space:]]*::[[:space:]]*($ours|$theirs)[fl]?$not_word"
builtin="__builtin_($ours|$theirs)[fl]?$not_word"
suffixed="(^|[^A-Za-z0-9_.>:])($ours)[fl][[:space:]]*\\("
plain="(^|[^A-Za-z0-9_.>:])($theirs)[fl]?[[:space:]]*\\("

bad=0
for file in $files; do
  # comments and strings are ignored; a quote as a character constant opens no string; a log() that
  # returns void is no logarithm
  found=$(sed -E "s/'\\\\?\"'//g"'; s/void log\(/(/; s/"([^"\\]|\\.)*"/""/g; s,//.*,,; s,/\*.*\*/,,g' "$file" |
    grep -nE "$qualified|$builtin|$suffixed|$plain") || continue
  printf '%s\n' "$found" | sed "s|^\([0-9]*\):[[:space:]]*|$file:\1: the C library's function: |"
  bad=1
done

if [ -n "$library" ]; then
  symbols=$(nm --undefined-only --format=posix "$library")
  printf '%s\n' "$symbols" | grep -q ' U ' || { echo "check_c_math: $library needs nothing at all" >&2; exit 1; }
  if printf '%s\n' "$symbols" | grep -E "^($ours|$theirs)[fl]? "; then
    echo "$library needs these functions of the C library"
    bad=1
  fi
fi
exit "$bad"
