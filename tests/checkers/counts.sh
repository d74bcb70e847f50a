# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Sourced by self_test.sh: tests the gates that compare counts with recorded ones. Each refuses an empty list, and one
# that lacks a row.

# gate PROGRAM RECORDED COUNTED OPTION…: runs one of scripts/*.awk on files of the tree
gate() {
  program=$1
  recorded=$tree/$2
  counted=$tree/$3
  shift 3
  awk "$@" -f "$scripts/$program" "$recorded" - <"$counted"
}
fresh
: >"$tree/empty"

# coverage
# summary ROOM COUNT COVERED …: prints it like llvm-cov, with a new line after every {
summary() {
  while [ $# -gt 0 ]; do
    printf '"filename":"/home/me/src/%s/a_b.cpp","summary":\n"functions":\n"count":1,"covered":1},"lines":\n' "$1"
    printf '"count":%d,"covered":%d,"percent":1},"regions":\n"count":9,"covered":0}\n' "$2" "$3"
    shift 3
  done
  printf '"totals":\n"lines":\n"count":9,"covered":0}\n'
}
coverage() { recorded=$1; summarised=$2; shift 2; gate coverage.awk "$recorded" "$summarised" -v rooms="body io" "$@"; }
summary body 100 95 io 50 40 >"$tree/good"
summary body 100 89 io 50 40 >"$tree/low"
summary body 100 95 >"$tree/one"
summary body 0 0 io 50 40 >"$tree/none"
write floors '# floors' 'body 90' 'io 80'
write few 'body 90'
write many 'body 90' 'io 80' 'gone 70'
passes 'coverage above its floors' coverage floors good
fails_with 'body is below its floor' 'coverage below a floor' coverage floors low
fails_with 'body is below its floor' 'a room without lines' coverage floors none
fails_with 'io has no floor' 'a room without a floor' coverage few good
fails_with 'io has no floor' 'coverage without floors' coverage empty good
fails_with 'io was not counted' 'a room that is not counted' coverage floors one
fails_with 'gone has a floor' 'a floor of no room' coverage many good
fails_with 'no room was counted' 'coverage of nothing' coverage floors empty
passes 'coverage to be recorded' coverage empty good -v record=yes
[ "$output" = "body 94
io 79" ] || [ "$output" = "io 79
body 94" ] || report "coverage --record gives other floors: $output"
fails_with 'no room was counted' 'coverage of nothing to be recorded' coverage empty empty -v record=yes

# instructions of a motion
callgrind() { gate callgrind_counts.awk "$1" "$2" -v margin=10 -v lacking="${3:-}"; }
write counts '# counts' 'half double 1000' 'half avx2 100'
write same 'half double 1050' 'half avx2 95'
write slow 'half double 1200' 'half avx2 95'
write fast 'half double 700' 'half avx2 95'
write zero 'half double 0' 'half avx2 95'
write some 'half double 1000'
passes 'as many instructions' callgrind counts same
passes 'a machine without AVX2' callgrind counts some avx2
fails_with 'slower' 'more instructions' callgrind counts slow
fails_with 'faster' 'fewer instructions' callgrind counts fast
fails_with 'faster' 'no instructions' callgrind counts zero
fails_with 'half avx2: not counted' 'what is not counted' callgrind counts some
fails_with 'half avx2: not recorded' 'what is not recorded' callgrind some same
fails_with 'not recorded' 'counts beside nothing' callgrind empty same
fails_with 'nothing was counted' 'counts of nothing' callgrind counts empty

# speed
speed() { gate speed_ratios.awk "$1" "$2" -v lacking="${3:-}"; }
# measured SPEED …: speeds of a/double, a/avx2 and a/avx512
measured() {
  echo 'name,iterations,"motions/s"'
  for set in double avx2 avx512; do
    [ $# -eq 0 ] || printf '"a/%s_mean",7,1\n"a/%s_median",7,%s\n' "$set" "$set" "$1"
    [ $# -eq 0 ] || shift
  done
}
write ratios '# ratios' 'a/double a/avx2 8' 'a/double a/avx512 10'
measured 10 70 90 >"$tree/quick"
measured 10 30 90 >"$tree/dull"
measured 10 70 >"$tree/old"
measured 10 nan 90 >"$tree/nan"
passes 'the ratios of speed' speed ratios quick
passes 'a machine without AVX-512' speed ratios old avx512
fails_with 'less than half' 'half of the speed' speed ratios dull
fails_with 'not measured here: a/avx512' 'a benchmark that is not there' speed ratios old
fails_with 'a/avx2' 'a speed that is no number' speed ratios nan
fails_with '' 'speeds beside nothing' speed empty quick
fails_with 'not measured' 'speeds of nothing' speed ratios empty

# mutants
mutants() { awk -v least=80 -f "$scripts/mutants_report.awk" "$tree/$1"; }
fates() { for fate in "$@"; do printf '%s\ta.cpp:1:2\tx\ty\n' "$fate"; done; }
fates killed killed killed killed survived >"$tree/tried"
fates killed killed killed survived >"$tree/survivors"
fates killed 'does not compile' >"$tree/broken"
fates killed killed '' >"$tree/odd"
passes 'four of five killed' mutants tried
fails_with 'fewer than 80 %' 'three of four killed' mutants survivors
fails_with 'half of them do not compile' 'a build that is broken' mutants broken
fails_with 'no fate' 'a mutant of no fate' mutants odd
fails_with 'or there are none' 'no mutant' mutants empty
write src/core/a.cpp 'int f(int a) { return a < 3 ? a : 0; } // a < 4' 'const char* b = " < ";' \
  '#ifdef __wasm_simd128__' 'int c = 3;' '#endif' 'SHG_ASSERT(0 < 1);'
passes 'changes' awk -f "$scripts/mutants.awk" "$tree/src/core/a.cpp"
[ "$(printf '%s\n' "$output" | cut -f 2-4 | tr '\t\n' ':,')" = "1:25: < ,1:28:3,1:36:0," ] ||
  [ "$(printf '%s\n' "$output" | wc -l)" = 3 ] || report "mutants.awk gives other changes: $output"

# outputs of ctest and node:test
ctest_says() { gate tests_told.awk "$1" "$2" -v strict="${3:-}" -v rooms="${4:-}"; }
write skips '# may skip' 'io.Root needs another user'
write passed ' 1/2 Test #1: io.File .....   Passed    0.01 sec' ' 2/2 Test #2: io.Root .....***Skipped   0.01 sec' \
  '100% tests passed, 0 tests failed out of 2'
write skipped ' 1/2 Test #1: io.File .....   Passed    0.01 sec' ' 2/2 Test #2: io.Disk .....***Skipped   0.01 sec'
write unread ' 1/1 Test #2: io.Root .....***Skipped   0.01 sec'
passes 'a skip that is known' ctest_says skips passed yes
passes 'a room with a test' ctest_says skips passed yes io
fails_with 'no test of oracles passed' 'a room without a test' ctest_says skips passed yes 'io oracles'
passes 'a skip where not all must run' ctest_says skips skipped
passes 'a skip without a list' ctest_says empty passed
fails_with 'not in' 'a skip that is not known' ctest_says skips skipped yes
fails_with 'not in' 'a skip beside an empty list' ctest_says empty passed yes
fails_with 'no test passed' 'a test that does nothing' ctest_says skips unread yes
fails_with 'no test passed' 'no test' ctest_says skips empty yes
node_says() { awk -v strict="${2:-}" -f "$scripts/tap.awk" "$tree/$1"; }
write tap 'ok 1 - a' 'ok 2 - b # SKIP in the night' '# pass 1' '# skipped 1'
write tap_skips 'ok 1 - a' 'ok 2 - b # SKIP no characters here' '# pass 1' '# skipped 1'
write tap_none '1..0' '# tests 0' '# pass 0'
passes 'a test of the night' node_says tap yes
passes 'a skip of node where not all must run' node_says tap_skips
fails_with 'no characters here' 'a skip of node' node_says tap_skips yes
fails_with 'no test passed' 'no test of node' node_says tap_none
fails_with 'no test passed' 'nothing of node' node_says empty
rooms_ran() { echo "$2" | awk -f "$scripts/rooms_ran.awk" "$tree/$1" -; }
write ran 'io 3' 'io 0' 'core 0'
passes 'rooms whose tests ran' rooms_ran ran io
fails_with 'no test of core ran' 'a room whose tests did not run' rooms_ran ran 'io core'
fails_with 'no test of io ran' 'rooms beside nothing' rooms_ran empty io
fails_with '' 'no rooms' rooms_ran ran ''

# characters' reaches
if command -v node >/dev/null; then
  # reaches LINE…: writes lines of JSON, one per character
  reaches() {
    rm -f "$tree"/*.json
    number=0
    for row in "$@"; do
      number=$((number + 1))
      printf '%s' "$row" >"$tree/$number.json"
    done
    node "$scripts/characters_table.mjs" "$tree" "${asked:-1}"
  }
  # row VERDICTS MET LONGER DEEPEST
  row() { printf '{"file": "a", "goals": {"low": {"verdicts": "%s", "met": %s, "longer": %s, "deepest_mm": %s, "deeper_mm": 1}}}' "$@"; }
  asked=1
  passes 'a reach' reaches "$(row ppp true 1.2 10)"
  fails_with 'that are possible' 'a reach that is impossible' reaches "$(row i true 1.2 10)"
  fails_with 'that are possible' 'a goal that is not met' reaches "$(row ppp false 1.2 10)"
  fails_with 'longest first choice' 'a reach that takes twice as long' reaches "$(row ppp true 2 10)"
  fails_with 'deepest vertex' 'an arm deep in the body' reaches "$(row ppp true 1.2 300)"
  fails_with 'characters that are read' 'a character that is not read' reaches ''
  asked=0
  set --
  for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do set -- "$@" "$(row ppp true 1.2 null)"; done
  fails_with 'depths were measured' 'depths that are no numbers' reaches "$@"
fi
