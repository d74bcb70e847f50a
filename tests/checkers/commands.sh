# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Sourced by self_test.sh: tests the commands of scripts/ on small projects, whose compilers, tests and programs are short
# scripts.

# project: makes a tree with scripts/, where programs of $tree/bin come first on PATH; nothing is installed
project() {
  fresh
  mkdir -p "$tree/scripts" "$tree/bin"
  cp "$scripts"/* "$tree/scripts" 2>/dev/null || true
  program scripts/install_dependencies
  program bin/cmake 'true'
}

# program PATH LINE…: writes a bash script
program() {
  write "$1" '#!/usr/bin/env bash'
  program_path=$tree/$1
  shift
  [ $# -eq 0 ] || printf '%s\n' "$@" >>"$program_path"
  chmod +x "$program_path"
}

# in_project COMMAND…: runs it in the tree
in_project() { (cd "$tree" && PATH="$tree/bin:$PATH" CCACHE_BASEDIR='' "$@"); }

# with_words LINE…: runs lines of bash with the functions of common.sh
with_words() {
  program scripts/try 'source "$(dirname "${BASH_SOURCE[0]}")/common.sh"' "$@"
  in_project "$tree/scripts/try"
}

# functions of common.sh
project
passes 'all of three' with_words 'f() { [ "$1" != bad ]; }' 'in_parallel f a b c'
fails_with '' 'one of three' with_words 'f() { [ "$1" != bad ]; }' 'in_parallel f a bad c'
fails_with 'nothing for f' 'none of none' with_words 'f() { true; }' 'in_parallel f'
fails_with '' 'what fails within $(…)' with_words 'f() { false; echo x; }' 'x=$(f)' 'echo "$x"'
fails_with 'said' 'what fails quietly' with_words 'f() { echo said; return 3; }' 'quietly f'
passes 'what is attempted' with_words 'attempt a true' 'tell_attempts night'
fails_with 'night: failed: a' 'an attempt that fails' with_words 'attempt a false' 'attempt b true' 'tell_attempts night'
passes 'an attempt that skips' with_words 'f() { return 77; }' 'attempt a f' 'tell_attempts night'
case $output in *'night: skipped: a'*) ;; *) report "a skip is not told: $output" ;; esac
# an old build exists that could be built and tested
program bin/cmake '[ "$1" = --build ]'
fails_with 'failed: a' 'a build that cannot be configured' with_words 'attempt a build gcc' 'tell_attempts night'
fails_with 'failed: a' 'a target that cannot be configured' with_words 'attempt a build_target gcc x' 'tell_attempts night'
program bin/cmake '[ "$1" != --build ]'
fails_with 'failed: a' 'a build that fails' with_words 'attempt a build gcc' 'tell_attempts night'

# tests
program bin/ctest 'echo " 1/1 Test #1: io.File .....   Passed    0.01 sec"'
cp "$checkers/../may_skip.txt" "$tree" && write tests/may_skip.txt ''
passes 'a test that passes' with_words 'run_tests gcc'
program bin/ctest 'echo " 1/2 Test #1: io.File .....   Passed    0.01 sec"' 'exit 8'
fails_with '' 'a test that fails' with_words 'run_tests gcc'
# rooms COUNT STATUS: runs a room whose tests end like this
rooms() {
  program build/gcc/tests/test_io "echo '[==========] $1 tests from 1 test suite ran. (5 ms total)'" "exit $2"
  with_words 'run_rooms gcc io'
}
passes 'a room whose tests pass' rooms 3 0
fails_with '3 tests from' 'a room whose tests fail' rooms 3 1
fails_with 'no test of io ran' 'a filter that matches no test' rooms 0 0
fails_with '' 'a room that is not built' with_words 'run_rooms gcc gone'
program bin/node 'echo "ok 1 - a"' 'echo "# pass 1"' 'exit 1'
fails_with '' 'a test of node that fails' with_words 'node_tests a'
program bin/node 'echo "# pass 0"'
fails_with 'no test passed' 'a folder without tests of node' with_words 'node_tests a'

# format
project
program bin/clang-format-14 'for file; do ! grep -q "bad layout" "$file" 2>/dev/null || exit 1; done'
fails_with 'No such file' 'a format of folders that are not there' in_project "$tree/scripts/format" --check
mkdir -p "$tree/apps" "$tree/bindings" "$tree/tests" "$tree/examples" "$tree/bench" "$tree/research" "$tree/dataset"
passes 'a good format' in_project "$tree/scripts/format" --check
write src/a.cpp 'bad layout'
fails_with '' 'a bad format' in_project "$tree/scripts/format" --check
rm "$tree/src/a.cpp" "$tree/include/shigusa/error.hpp"
fails_with 'no sources' 'a format of nothing' in_project "$tree/scripts/format" --check

# the same bytes
project
# engine BUILD SETS LINE…: writes a program that has these SIMD sets and writes a result, then runs LINE with $folder
# and $set
engine() {
  engine_path=build/$1/bin/shigusa
  engine_sets=$2
  shift 2
  program "$engine_path" 'while [ $# -gt 0 ]; do' 'case $1 in --out) folder=$2 ;; --simd) set=$2 ;; esac' 'shift' 'done' \
    "[ \"\${set:-}\" != '?' ] || { echo '$engine_sets'; exit 2; }" 'mkdir -p "$folder"' 'echo "{}" >"$folder/summary.json"' "$@"
}
same_bytes() { in_project "$tree/scripts/check_same_bytes" --some "$@"; }
engine gcc 'Known: scalar, avx2'
engine clang 'Known: scalar, avx2'
passes 'the same bytes' same_bytes gcc clang
engine clang 'no such set'
fails_with 'names no SIMD sets' 'a build that runs nothing' same_bytes gcc clang
engine clang 'Known: scalar, avx2' '[ $set != avx2 ] || echo x >"$folder/summary.json"'
fails_with 'differ from' 'other bytes of a set' same_bytes gcc clang
fails_with 'is not there' 'a build that is not there' same_bytes gcc gone
engine gcc 'Known: scalar'
engine clang 'Known: scalar' 'exit 4'
fails_with '' 'a build that fails' same_bytes gcc clang

# recorded bytes
project
recorded() { in_project "$tree/scripts/check_recorded_bytes" --only '^(pareto|far) ' "$@"; }
engine gcc 'Known: scalar'
write tests/recorded_bytes.tsv 'gone	0'
fails_with 'far
' 'motions that were not recorded' recorded
row=$(printf 'status 0\n' | sha256sum | cut -c 1-32)
for name in far pareto; do
  for rest in '' .edit .mirror .timing; do printf '%s%s\t%s\n' "$name" "$rest" "$row"; done
done >"$tree/tests/recorded_bytes.tsv"
passes 'motions as recorded' recorded
write tests/recorded_bytes.tsv "$(cat "$tree/tests/recorded_bytes.tsv")" "zone	$row"
fails_with 'zone' 'what was recorded and did not come' recorded
fails_with 'nothing for run' 'no task' in_project "$tree/scripts/check_recorded_bytes" --only 'no such task'
fails_with 'only all of them' 'a record of some' in_project "$tree/scripts/check_recorded_bytes" --record --only far
engine gcc 'Known: scalar' 'exit 5'
fails_with 'exit status 5' 'a program that fails' recorded

# fuzzing
project
write tests/fuzz/io_fuzz.cpp ''
write tests/fuzz/io_corpus/a 'seed'
for other in bvh gltf fbx urdf mjcf task work result door; do write "tests/fuzz/${other}_corpus/a" 'seed'; done
fuzz() { in_project "$tree/scripts/fuzz" 1 io_fuzz; }
program build/clang-asan/fuzz/io_fuzz 'true'
passes 'a target that finds nothing' fuzz
program build/clang-asan/fuzz/io_fuzz 'echo crash; exit 77'
fails_with 'io_fuzz failed' 'a target that finds a crash' fuzz
program build/clang-asan/fuzz/io_fuzz '[[ $* != *-merge=1* ]]'
fails_with '' 'a target whose finds cannot be kept' fuzz
rm -r "$tree/tests/fuzz/io_corpus"
program build/clang-asan/fuzz/io_fuzz 'true'
fails_with 'io_corpus' 'a target without a corpus' fuzz

# pieces of work
project
program build/gcc/bin/shigusa_work '[ "$1" = 300 ]'
passes 'pieces of work of which all holds' in_project "$tree/scripts/check_work"
fails_with '' 'pieces of work of which something fails' in_project "$tree/scripts/check_work" 20

# reports of users
project
mkdir -p "$tree/tests/checkers"
cp "$scripts/../tests/checkers/reports.mjs" "$tree/tests/checkers"
printf 'kind\tfile\n1 one\ta.urdf\n' >"$tree/manifest.tsv"
reports() {
  write expected.json "$1"
  in_project env SHIGUSA_BINARY="$tree/bin/shigusa" "$tree/scripts/check_reports" "$tree/manifest.tsv" "$tree/expected.json"
}
entry='"row": "1 one: a.urdf", "run": "body {file}"'
program bin/shigusa 'echo "{\"stature_m\": 1.7}"; echo "a note on $2" >&2; exit 3'
passes 'a report as it is to be' reports "[{$entry, \"exit\": 3, \"err\": \"note on .*a.urdf\", \"json\": {\"stature_m\": [1.6, 1.8]}}]"
fails_with 'exit code 3' 'another exit code' reports "[{$entry}]"
fails_with 'no /doubt/' 'a word that is not told' reports "[{$entry, \"exit\": 3, \"err\": \"doubt\"}]"
fails_with 'stature_m is 1.7' 'a number out of its bounds' reports "[{$entry, \"exit\": 3, \"json\": {\"stature_m\": [1.8, 2]}}]"
fails_with '0 entries for 1 rows' 'a row without an entry' reports '[]'
fails_with 'no such row' 'an entry without a row' reports "[{$entry, \"exit\": 3}, {\"row\": \"2 two: b\", \"run\": \"\"}]"
passes 'a report that is expected to fail' reports "[{$entry, \"fails\": \"not yet\"}]"
fails_with 'take "fails" away' 'a mended report that is marked as failing' reports "[{$entry, \"exit\": 3, \"fails\": \"not yet\"}]"
