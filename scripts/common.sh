# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Read by the commands beside it: goes to the project's root and gives them a few words.
set -euo pipefail
called_from=$PWD # paths that a caller gives are meant from there
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DEBIAN_FRONTEND=noninteractive
jobs=$(nproc)
# what ccache keeps serves other clones on this machine too
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=true

# say TEXT: one line on what comes next, and when
say() { printf '== %(%H:%M:%S)T %s\n' -1 "$*"; }

# quietly COMMAND…: shows the command's output only when it fails
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 </dev/null || status=$?
  [ "$status" = 0 ] || cat "$log"
  rm -f "$log"
  return "$status"
}

# build PRESET CMAKE_OPTION…: configures and builds into build/PRESET
build() {
  quietly cmake --preset "$@"
  if [ -t 1 ]; then
    cmake --build "build/$1" --parallel "$jobs"
  else
    quietly cmake --build "build/$1" --parallel "$jobs" -- --quiet
  fi
}

# build_target PRESET TARGET…: configures build/PRESET and builds only these
build_target() {
  local preset=$1
  shift
  quietly cmake --preset "$preset"
  quietly cmake --build "build/$preset" --parallel "$jobs" --target "$@" -- --quiet
}

# run_tests PRESET CTEST_OPTION…: what passed or was skipped is only counted, unless on a terminal
run_tests() {
  local preset=$1
  shift
  local ctest=(ctest --preset "$preset" --no-tests=error --no-label-summary --parallel "$jobs" "$@")
  if [ -t 1 ]; then
    "${ctest[@]}"
  else
    "${ctest[@]}" </dev/null | awk '
      /^ *Start +[0-9]+: / || /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .* Passed / { next }
      /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .*\*\*\*Skipped / { ++skipped; next }
      /^The following tests did not run:/ || /^\t *[0-9]+ - .* \(Skipped\)$/ { next }
      /tests passed, / && skipped { print skipped " tests skipped what this machine lacks" }
      { print }'
  fi
}

# npm_packages FOLDER: what its lock file names, unless it is there already
npm_packages() {
  local lock
  lock=$(sha256sum "$1/package-lock.json" | cut -d ' ' -f 1)
  [ ! -e "$1/node_modules/.lock-$lock" ] || return 0
  say "fetching the npm packages of $1, as locked"
  quietly npm ci --prefix "$1" --no-audit --no-fund --ignore-scripts
  touch "$1/node_modules/.lock-$lock"
}

# in_parallel FUNCTION ARGUMENT…: the function once for each argument, as many at once as there are
# cores; fails when one fails, after all are done
in_parallel() {
  local function=$1 argument running=0 failed=0
  shift
  for argument in "$@"; do
    if [ "$running" -ge "$jobs" ]; then
      wait -n || failed=1
      running=$((running - 1))
    fi
    "$function" "$argument" &
    running=$((running + 1))
  done
  while [ "$running" -gt 0 ]; do
    wait -n || failed=1
    running=$((running - 1))
  done
  return "$failed"
}

# run_rooms PRESET ROOM…: the test programs of these rooms, each in as many parts as there are cores. A process
# for all tests of a part and not one each, which takes sanitizers half a second to begin.
run_rooms() {
  local preset=$1 room part parts=()
  shift
  export LSAN_OPTIONS=suppressions=$PWD/tests/lsan.supp:print_suppressions=0
  export TSAN_OPTIONS=suppressions=$PWD/tests/tsan.supp UBSAN_OPTIONS=print_stacktrace=1
  run_part() {
    RC_PARAMS="seed=42 max_success=30" GTEST_TOTAL_SHARDS=$jobs GTEST_SHARD_INDEX=${1#* } \
      quietly timeout 1200 "build/$preset/tests/test_${1% *}" --gtest_brief=1
  }
  for room in "$@"; do
    for ((part = 0; part < jobs; ++part)); do parts+=("$room $part"); done
  done
  in_parallel run_part "${parts[@]}"
}
