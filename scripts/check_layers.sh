#!/bin/sh
# SPDX-License-Identifier: MIT
# check_layers.sh [ROOT]: fails when a folder includes one that it may not use.
#
# Rooms stand in docs/architecture.md's order. A room may use itself and the rooms to the right of its
# name here. The public headers lie side by side in include/shigusa, and each belongs to a room all the
# same. Of other libraries a public header may use the standard one and tl/expected.hpp; it uses no
# header of src. Programs that show how the library is used have its public headers alone: apps,
# bindings, examples and tests/consumer.
#
# The operating system has one room too, files: no other file includes its headers, but for the few that
# are named below.
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
  allow("plan", "criteria dynamics kinematics motion body math core")
  motions = "plan criteria dynamics kinematics motion " persons " simd"
  allow("rollout", motions)
  motions = "rollout " motions
  allow("nlp", motions)
  allow("paper", motions)
  allow("problem", "search " motions)
  generates = "nlp paper problem search " motions
  allow("generate", generates)
  generates = "generate " generates
  allow("robot", "kinematics motion " persons)
  allow("formats", "robot files motion " persons)
  allow("character", "formats robot files criteria dynamics kinematics motion " persons)
  allow("draw", "files " generates)
  documents = "draw character formats robot files " generates
  allow("document", documents)
  allow("edit", "document " documents)
  all = "dataset edit document " documents
  allow("dataset", "edit document " documents)
  allow("shigusa", all)  # the one header that gathers the others
  outside = "apps examples tests bindings bench research"
  n = split(outside, list, " ")
  for (i = 1; i <= n; ++i) allow(list[i], "shigusa " all)

  face("core", "message result progress random words field parallel version")
  face("math", "scalar vec3 mat3 quat transform")
  face("files", "file")
  face("body", "skeleton joint_place body_model body_build goal")
  face("motion", "motion")
  face("human", "landmarks human_body")
  face("dynamics", "kinematics")
  face("criteria", "criteria motion_measures")
  face("search", "search")
  face("plan", "parameters layered_settings")
  face("problem", "request task")
  face("generate", "generate verdict")
  face("formats", "bvh file_format")
  face("draw", "strip_figure motion_page result_words")
  face("character", "character")
  face("document", "task_file result_file export score_clip limb_cache facts")
  face("edit", "edit")
  face("dataset", "dataset dataset_merge dataset_check dataset_show dataset_export dataset_read")
  face("shigusa", "shigusa")

  n = split("aio dirent dlfcn execinfo fcntl ftw glob grp ifaddrs langinfo libgen link netdb poll pthread pwd " \
            "sched semaphore signal spawn strings syslog termios ucontext unistd utime wordexp windows io", list, " ")
  for (i = 1; i <= n; ++i) system_headers[list[i] ".h"] = 1
  # streams and signals of the program; sockets of a web server; keys of threads
  n = split("apps/shigusa/system.cpp apps/shigusa/page_server.cpp bindings/c/src/failure.cpp", list, " ")
  for (i = 1; i <= n; ++i) may_ask_system[list[i]] = 1

  # a component of its own has public headers, and of these rooms what lies within
  inside["dataset"] = " dataset core files formats "
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
    # a path through folders: the first one that is a room is the one used
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
