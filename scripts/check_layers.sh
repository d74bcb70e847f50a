#!/bin/sh
# SPDX-License-Identifier: MIT
# check_layers.sh [ROOT]: fails when a folder includes one that it may not use.
#
# Rooms stand in docs/architecture.md's order. A room may use itself and what stands to the right of
# its name here; of other libraries a public header may use the standard one and tl/expected.hpp.
set -eu
cd "${1:-$(dirname "$0")/..}"

files=$(find include src apps bindings examples bench tests -type f \
  \( -name '*.hpp' -o -name '*.h' -o -name '*.cpp' \) 2>/dev/null | LC_ALL=C sort) || true
[ -n "$files" ] || { echo "check_layers: no sources below $(pwd)" >&2; exit 1; }

# shellcheck disable=SC2086  # no path in the project holds a space
awk '
function allow(room, used,   names, n, i) {
  known[room] = 1
  n = split(used " " room, names, " ")
  for (i = 1; i <= n; ++i) may[room, names[i]] = 1
}
function complain(text) {
  printf "%s:%d: %s\n", FILENAME, FNR, text
  bad = 1
}
function check_room(target) {
  if (!(target in known)) complain("\"" target "\" is not a room")
  else if (!((room, target) in may)) complain(room " must not include " target)
}

BEGIN {
  allow("core", "")
  allow("math", "core")
  allow("simd", "math core")
  allow("body", "math core")
  allow("motion", "body math core")
  allow("kinematics", "motion body math core")
  allow("dynamics", "kinematics motion body math core")
  allow("criteria", "dynamics kinematics motion body math core")
  allow("rollout", "criteria dynamics kinematics motion body math core simd")
  allow("search", "math core")
  all = "rollout criteria dynamics kinematics motion body math core simd search"
  allow("hierarchy", all)
  allow("io", "motion body math core")
  allow("project", "hierarchy io " all)
  # the one header that gathers the others
  allow("shigusa.hpp", "project hierarchy io " all)
  all = all " shigusa.hpp"
  all = "project hierarchy " all
  allow("shigusa.hpp", all)  # the front door: what a program includes that wants everything
  allow("apps", "shigusa.hpp io " all)
  allow("examples", "shigusa.hpp io " all)
  allow("tests", "shigusa.hpp io " all)
  allow("bindings", "shigusa.hpp " all)
  allow("bench", "shigusa.hpp io " all)
}

FNR == 1 {
  split(FILENAME, part, "/")
  if (part[1] == "include") room = part[2] == "shigusa" ? part[3] : part[2]
  else room = part[1] == "src" ? part[2] : part[1]
  public = part[1] == "include"
  internal_allowed = part[1] == "src" || part[1] == "tests"
  if (!(room in known)) complain("\"" room "\" is not a room")
}

/^[ \t]*#[ \t]*include/ {
  target = $0
  sub(/^[ \t]*#[ \t]*include[ \t]*/, "", target)
  quoted = substr(target, 1, 1) == "\""
  sub(/^["<]/, "", target)
  sub(/[">].*/, "", target)

  if (target ~ /^shigusa\//) {
    split(target, part, "/")
    check_room(part[2])
  } else if (!quoted) {
    if (public && target != "tl/expected.hpp" && target !~ /^[a-z_0-9]+$/)
      complain("a public header must not include <" target ">")
  } else if (public) {
    complain("a public header includes only <shigusa/...>, not \"" target "\"")
  } else if (target ~ /\//) {
    # a path through folders: the first one that is a room is the one used
    n = split(target, part, "/")
    for (i = 1; i < n && !(part[i] in known); ++i) {}
    if (i < n || target ~ /(^|\/)(src|include)\//) {
      if (!internal_allowed) complain(room " must use public headers only, not \"" target "\"")
      else if (i < n) check_room(part[i])
    }
  }
}

END { exit bad }
' $files
