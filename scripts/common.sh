# SPDX-License-Identifier: MIT
# Sourced by the other scripts: goes to the project's root and defines common functions.
# shellcheck shell=bash
# Read by the commands beside it: goes to the project's root and gives them a few words.
set -euo pipefail
shopt -s inherit_errexit # otherwise failures within $(…) are ignored
called_from=$PWD # base of the relative paths that a caller gives
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DEBIAN_FRONTEND=noninteractive
jobs=$(nproc)
# ccache's entries serve other clones on this machine too
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=true

# say TEXT: prints one line about the next step, with the time
say() { printf '== %(%H:%M:%S)T %s\n' -1 "$*"; }

# quietly COMMAND…: shows the command's output only if it fails
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 </dev/null || status=$?
  [ "$status" = 0 ] || cat "$log"
  rm -f "$log"
  return "$status"
}

# If a caller tests the status of one of these functions, `set -e` is off within it, so each step returns explicitly.

# build PRESET CMAKE_OPTION…: configures and builds into build/PRESET
build() {
  quietly cmake --preset "$@" || return
  if [ -t 1 ]; then
    cmake --build "build/$1" --parallel "$jobs"
  else
    quietly cmake --build "build/$1" --parallel "$jobs" -- --quiet
  fi
}

# build_target PRESET TARGET…: configures build/PRESET and builds only these targets
build_target() {
  local preset=$1
  shift
  quietly cmake --preset "$preset" || return
  quietly cmake --build "build/$preset" --parallel "$jobs" --target "$@" -- --quiet
}

# build_research TARGET…: builds these programs of research/, without tests
build_research() {
  quietly cmake --preset gcc -D SHIGUSA_BUILD_TESTS=OFF -D SHIGUSA_BUILD_RESEARCH=ON || return
  build_target gcc "$@"
}

# whether unexpected skips are failures: in .ci/run (SHIGUSA_STRICT), if ../shared is present
strict=
[ -z "${SHIGUSA_STRICT:-}" ] || [ ! -d ../shared ] || strict=yes
awk_of_tap=$PWD/scripts/tap.awk

# run_tests PRESET CTEST_OPTION…: runs ctest; passed and skipped tests are only counted, unless on a terminal
run_tests() {
  local preset=$1 rooms
  shift
  local ctest=(ctest --preset "$preset" --no-tests=error --no-label-summary --parallel "$jobs" "$@")
  if [ -t 1 ]; then
    "${ctest[@]}"
  else
    rooms=$(printf '%s\n' tests/*/*_test.cpp | cut -d / -f 2 | LC_ALL=C sort -u | tr '\n' ' ')
    "${ctest[@]}" </dev/null | awk -v strict="$strict" -v rooms="$rooms" -f scripts/tests_told.awk tests/may_skip.txt -
  fi
}

# node_tests NODE_OPTION…: runs tests of node:test
node_tests() {
  node --test --test-reporter=tap --test-reporter-destination=stdout "$@" | awk -v strict="$strict" -f "$awk_of_tap"
}

# npm_packages FOLDER: installs the packages of its lock file, unless they are installed
npm_packages() {
  local lock
  lock=$(sha256sum "$1/package-lock.json" | cut -d ' ' -f 1) || return
  [ ! -e "$1/node_modules/.lock-$lock" ] || return 0
  say "fetching the npm packages of $1, as locked"
  quietly npm ci --prefix "$1" --no-audit --no-fund --ignore-scripts || return
  touch "$1/node_modules/.lock-$lock"
}

# in_parallel FUNCTION ARGUMENT…: calls the function once for each argument, as many at once as there are
# cores; fails after all calls if one failed, and without an argument
in_parallel() {
  local function=$1 argument running=0 failed=0
  shift
  [ $# -gt 0 ] || {
    echo "in_parallel: nothing for $function to do" >&2
    return 1
  }
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

# run_rooms PRESET ROOM…: runs the test programs of these rooms, each in as many parts as there are cores. Each part is
# one process, not one per test, as sanitizers take half a second to start. Fails if no test of a room ran, as when a
# filter's name has changed.
run_rooms() {
  local preset=$1 room part parts=() failed=0 counts
  shift
  export LSAN_OPTIONS=suppressions=$PWD/tests/lsan.supp:print_suppressions=0
  export TSAN_OPTIONS=suppressions=$PWD/tests/tsan.supp UBSAN_OPTIONS=print_stacktrace=1
  counts=$(mktemp)
  # run_part "ROOM PART"
  run_part() {
    local log status=0
    log=$(mktemp)
    RC_PARAMS="seed=42 max_success=30" GTEST_TOTAL_SHARDS=$jobs GTEST_SHARD_INDEX=${1#* } \
      timeout 1200 "build/$preset/tests/test_${1% *}" --gtest_brief=1 >"$log" 2>&1 </dev/null || status=$?
    [ "$status" = 0 ] || cat "$log"
    sed -nE "s/^\[=+\] ([0-9]+) tests? from .* ran\..*/${1% *} \1/p" "$log" >>"$counts"
    rm -f "$log"
    return "$status"
  }
  for room in "$@"; do
    for ((part = 0; part < jobs; ++part)); do parts+=("$room $part"); done
  done
  in_parallel run_part "${parts[@]}" || failed=1
  awk -f scripts/rooms_ran.awk "$counts" - <<<"$*" || failed=1
  rm -f "$counts"
  return "$failed"
}

# install_alone PRESET FOLDER PACKAGE…: installs what needs nothing else, the program and the C interface, into a folder
# to be packed, with the licences of the Debian packages that are linked in
install_alone() {
  local preset=$1 folder=$2 package
  shift 2
  quietly cmake --install "build/$preset" --prefix "$folder" || return
  # the C++ library needs others, and the page a server
  (cd "$folder" && rm -rf include/shigusa lib/libshigusa.a lib/cmake lib/pkgconfig/shigusa.pc share/shigusa/studio) || return
  mv "$folder/share/doc/shigusa/LICENSE" "$folder" || return
  mkdir "$folder/licences" || return
  for package in "$@"; do cp -L "/usr/share/doc/$package/copyright" "$folder/licences/$package" || return; done
}

project_folder=$PWD
# without_project COMMAND…: runs it where an empty folder lies over the project's, if this system can hide a folder
without_project() {
  # shellcheck disable=SC2016  # for the inner shell
  local hide=(unshare --map-root-user --mount sh -euc 'mount -t tmpfs none "$1"; shift; exec "$@"' sh "$project_folder")
  if "${hide[@]}" true 2>/dev/null; then
    "${hide[@]}" "$@"
  else
    echo "$(basename "$0"): this system cannot hide a folder (unshare), so that $1 can see the project's" >&2
    "$@"
  fi
}

# attempt WHAT COMMAND…: runs the command, and records a failure or, by 77, a skip
attempt() {
  local what=$1 status=0
  shift
  say "$what"
  "$@" || status=$?
  case $status in
    0) ;;
    77) attempts_skipped+=("$what") ;;
    *) attempts_failed+=("$what") ;;
  esac
}
attempts_failed=()
attempts_skipped=()

# tell_attempts NAME: prints the recorded skips and failures; fails if there was a failure
tell_attempts() {
  [ ${#attempts_skipped[@]} -eq 0 ] || printf "$1: skipped: %s\n" "${attempts_skipped[@]}" >&2
  [ ${#attempts_failed[@]} -eq 0 ] || printf "$1: failed: %s\n" "${attempts_failed[@]}" >&2
  [ ${#attempts_failed[@]} -eq 0 ]
}
