#!/bin/sh
# SPDX-License-Identifier: MIT
# self_test.sh COMPILER: tests, on small trees and inputs, that each checker and each gate of scripts/ refuses faults and
# accepts the rest. The files beside this one have the tests by kind.
set -eu
compiler=$1
checkers=$(cd "$(dirname "$0")" && pwd)
scripts=$(cd "$(dirname "$0")/../../scripts" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# fresh: makes a tree with one file that every checker accepts
fresh() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree/include" "$tree/src"
  write include/shigusa/error.hpp '// SPDX-License-Identifier: MIT' '#include <string>' \
    '#include <tl/expected.hpp>' 'namespace shigusa {' 'inline double f(double x) { return x; }' '}'
}

# write PATH LINE…: writes a file of the tree
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

# accepts CHECKER: expects the present tree to pass
accepts() {
  output=$(sh "$scripts/$1" "$tree" 2>&1) || report "$1 refuses a good tree: $output"
}

# refuses CHECKER PATH LINE MESSAGE: expects a good tree with this file to fail with MESSAGE
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

# fails_with MESSAGE WHAT COMMAND…: expects the command to fail with MESSAGE
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

# passes WHAT COMMAND…: expects the command to pass
passes() {
  what=$1
  shift
  output=$("$@" 2>&1) || report "$what is refused: $output"
}

for part in sources libraries pages commands counts; do . "$checkers/$part.sh"; done
[ "$failures" = 0 ]
