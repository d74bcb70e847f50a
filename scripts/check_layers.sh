#!/bin/sh
# SPDX-License-Identifier: MIT
# check_layers.sh [ROOT]: fails if a folder includes one that it may not use.
#
# Rooms are in the order of docs/architecture.md. A room may use itself and the rooms listed after its name
# below. Each public header, in include/shigusa, belongs to a room. A public header may use the standard library
# and tl/expected.hpp, but no header of src. Programs that show the use of the library (examples and
# tests/consumer) use public headers only; the data sets, the command-line tool and the bindings also use a few rooms.
#
# Only the room files includes headers of the operating system, except for the few files named below.
set -eu
cd "${1:-$(dirname "$0")/..}"

files=$(find include src dataset apps bindings examples bench research tests -type f \
  \( -name '*.hpp' -o -name '*.h' -o -name '*.cpp' \) 2>/dev/null | LC_ALL=C sort) || true
[ -n "$files" ] || { echo "check_layers: no sources below $(pwd)" >&2; exit 1; }

# shellcheck disable=SC2086  # no path in the project holds a space
awk '
function allow(room, used,   names, n, i) {
  known[room] = 1
  n = split(used " " room, names, " ")
  for (i = 1; i <= n; ++i) may[room, names[i]] = 1
}
function face(room, headers,   names, n, i) {
  n = split(headers, names, " ")
  for (i = 1; i <= n; ++i) room_of[names[i] ".hpp"] = room
}
function complain(text) {
  printf "%s:%d: %s\n", FILENAME, FNR, text
  bad = 1
}
function check_system(target) {
  if (target !~ /^(sys|arpa|net|netinet|linux|mach)\// && !(target in system_headers)) return
  if (FILENAME ~ /^(tests|src\/files)\//) return
  if (FILENAME in may_ask_system) unasked[FILENAME] = 0
  else complain("<" target "> is the operating system\047s: only src/files includes it")
}
function check_room(target) {
  if (!(target in known)) complain("\"" target "\" is not a room")
  else if (room in known && !((room, target) in may)) complain(room " must not include " target)
}

BEGIN {
  allow("core", "")
  allow("math", "core")
  allow("files", "core")
  allow("simd", "math core")
  allow("search", "math core")
  allow("body", "math core")
  allow("motion", "body math core")
  allow("human", "body math core")
  allow("rig", "human body math core")
  persons = "measure rig human body math core"
  allow("measure", persons)
  allow("kinematics", "motion " persons)
  allow("dynamics", "kinematics motion body math core")
  allow("criteria", "dynamics kinematics motion body math core")
  allow("cost", "criteria dynamics kinematics motion body math core")
  allow("plan", "criteria dynamics kinematics motion body math core")
  motions = "plan criteria dynamics kinematics motion " persons " simd"
  allow("rollout", motions)
  motions = "rollout " motions
  allow("nlp", motions)
  allow("paper", motions)
  allow("problem", "cost search " motions)
  generates = "nlp paper problem cost search " motions
  allow("generate", generates)
  generates = "generate " generates
  allow("work", generates)
  allow("explore", generates)
  allow("robot", "kinematics motion " persons)
  allow("formats", "robot files motion " persons)
  allow("character", "formats robot files criteria dynamics kinematics motion " persons)
  allow("scene", "formats robot files problem cost search " motions)
  allow("draw", "files " generates)
  documents = "work explore draw scene character formats robot files " generates
  allow("document", documents)
  allow("edit", "document " documents)
  allow("assistant", "edit document " documents)
  all = "assistant work dataset edit document " documents
  allow("dataset", "edit document " documents)
  allow("shigusa", all)  # the header that includes all others
  outside = "apps examples tests bindings bench research"
  n = split(outside, list, " ")
  for (i = 1; i <= n; ++i) allow(list[i], "shigusa " all)

  face("core", "error run")
  face("math", "math")
  face("body", "body goal motion action")
  face("human", "human")
  face("criteria", "criteria habit")
  face("cost", "cost ergonomics")
  face("dynamics", "kinematics")
  face("search", "search")
  face("plan", "parameters")
  face("problem", "request")
  face("generate", "generate")
  face("explore", "explore")
  face("formats", "formats")
  face("scene", "scene")
  face("draw", "draw")
  face("character", "character")
  face("document", "files report score series")
  face("edit", "edit")
  face("dataset", "dataset dataset_merge dataset_check dataset_export dataset_read")
  face("shigusa", "shigusa")

  n = split("aio dirent dlfcn execinfo fcntl ftw glob grp ifaddrs langinfo libgen link netdb poll pthread pwd " \
            "sched semaphore signal spawn strings syslog termios ucontext unistd utime wordexp windows io", list, " ")
  for (i = 1; i <= n; ++i) system_headers[list[i] ".h"] = 1
  # streams and signals of the program; sockets of a web server; keys of threads
  n = split("apps/shigusa/system_posix.cpp apps/shigusa/system_windows.cpp apps/shigusa/page_server.cpp bindings/c/src/failure.cpp", list, " ")
  for (i = 1; i <= n; ++i) may_ask_system[list[i]] = 1

  # folders that may use public headers, and all headers of these rooms
  inside["dataset"] = " dataset core files formats "
  inside["apps"] = " assistant core files problem "
  inside["bindings"] = " document generate "
}

FNR == 1 {
  split(FILENAME, part, "/")
  if (FILENAME in may_ask_system) unasked[FILENAME] = 1
  public = part[1] == "include" || part[2] == "include"
  internal_allowed = part[1] == "src" || part[1] == "bench" || part[1] == "research" || part[1] in inside || (part[1] == "tests" && part[2] != "consumer")
  if (public) {
    header = FILENAME
    sub(/^(dataset\/)?include\/shigusa\//, "", header)
    room = room_of[header]
    if (room == "") complain("\"" header "\" belongs to no room")
  } else {
    room = part[1] == "src" ? part[2] : part[1]
    if (!(room in known)) complain("\"" room "\" is not a room")
  }
}

/^[ \t]*#[ \t]*include/ {
  target = $0
  sub(/^[ \t]*#[ \t]*include[ \t]*/, "", target)
  quoted = substr(target, 1, 1) == "\""
  sub(/^["<]/, "", target)
  sub(/[">].*/, "", target)
  check_system(target)

  if (target ~ /^shigusa\//) {
    sub(/^shigusa\//, "", target)
    if (target in room_of) check_room(room_of[target])
    else complain("<shigusa/" target "> is no public header")
  } else if (!quoted) {
    if (public && target != "tl/expected.hpp" && target !~ /^[a-z_0-9]+$/)
      complain("a public header must not include <" target ">")
  } else if (public) {
    complain("a public header includes only <shigusa/...>, not \"" target "\"")
  } else if (target ~ /\//) {
    # in a path through folders the first one that is a room counts
    n = split(target, part, "/")
    for (i = 1; i < n && !(part[i] in known); ++i) {}
    if (i < n || target ~ /(^|\/)(src|include)\//) {
      if (!internal_allowed) complain(room " must use public headers only, not \"" target "\"")
      else if (room in inside && index(inside[room], " " part[i] " ") == 0)
        complain(room " must not include \"" target "\"")
      else if (i < n) check_room(part[i])
    }
  }
}

END {
  for (name in unasked) {
    if (!unasked[name]) continue
    print name ":1: may include what is the operating system\047s, and does not: take its name out of here"
    bad = 1
  }
  exit bad
}
' $files
