#!/bin/sh
# SPDX-License-Identifier: MIT
# self_test.sh COMPILER: shows on small trees and small inputs that each checker and each gate of scripts/ refuses what
# it should, and accepts what it should. The parts beside this file have them by kind.
set -eu
compiler=$1
checkers=$(cd "$(dirname "$0")" && pwd)
scripts=$(cd "$(dirname "$0")/../../scripts" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# fresh: an empty tree with one file that every checker accepts
fresh() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree/include" "$tree/src"
  write include/shigusa/error.hpp '// SPDX-License-Identifier: MIT' '#include <string>' \
    '#include <tl/expected.hpp>' 'namespace shigusa {' 'inline double f(double x) { return x; }' '}'
}

# write PATH LINE…
write() {
  path=$tree/$1
  shift
  mkdir -p "$(dirname "$path")"
  printf '%s\n' "$@" >"$path"
}

report() {
  echo "self_test: $1"
  failures=$((failures + 1))
}

# accepts CHECKER: the tree as it stands passes
accepts() {
  output=$(sh "$scripts/$1" "$tree" 2>&1) || report "$1 refuses a good tree: $output"
}

# refuses CHECKER PATH LINE MESSAGE: a good tree and this file do not pass, and MESSAGE is told
refuses() {
  fresh
  write docs/glossary.md '## Retired' '| `OldName`, `so many` | NewName |'
  write "$2" "$3"
  if output=$(sh "$scripts/$1" "$tree" 2>&1); then
    report "$1 accepts '$3' in $2"
  else
    case $output in
      *"$2:1: $4"*) ;;
      *) report "$1 refuses '$3' in $2 for another reason: $output" ;;
    esac
  fi
}

# fails_with MESSAGE WHAT COMMAND…: fails, and says MESSAGE
fails_with() {
  wanted=$1
  what=$2
  shift 2
  if output=$("$@" 2>&1); then
    report "$what is accepted"
  else
    case $output in
      *"$wanted"*) ;;
      *) report "$what is refused for another reason: $output" ;;
    esac
  fi
}

# passes WHAT COMMAND…
passes() {
  what=$1
  shift
  output=$("$@" 2>&1) || report "$what is refused: $output"
}

for part in sources libraries pages commands counts; do . "$checkers/$part.sh"; done
[ "$failures" = 0 ]
