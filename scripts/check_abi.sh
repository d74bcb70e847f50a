#!/bin/sh
# SPDX-License-Identifier: MIT
# check_abi.sh LIBRARY [LIST]: fails unless the C interface's library exports exactly the functions of
# tests/c/exported_symbols.txt. Within an ABI version that list only grows.
set -eu
[ -s "$1" ] || { echo "check_abi: $1 is not there" >&2; exit 1; }
list=${2:-$(dirname "$0")/../tests/c/exported_symbols.txt}
shown=$(mktemp)
trap 'rm -f "$shown"' EXIT
# templates of the standard library are exported as weak or unique symbols, despite hidden visibility
nm -D --defined-only "$1" | awk '$2 == "T" || $2 == "D" || $2 == "B" || $2 == "R" { print $3 }' |
  LC_ALL=C sort >"$shown"
[ -s "$shown" ] || { echo "check_abi: $1 shows nothing" >&2; exit 1; }
LC_ALL=C sort "$list" | diff - "$shown" || {
  echo "check_abi: < is promised and missing, > is shown and not promised" >&2
  exit 1
}
