# SPDX-License-Identifier: MIT
# coverage.awk FLOORS SUMMARY: used by scripts/coverage. From llvm-cov's summary prints the share of lines run in
# each room (src/ROOM, and dataset), or with `record` the lines of a new FLOORS, a point below. Fails if a room is
# below its floor or has none, if one of `rooms` (words) or of FLOORS was not counted, and if none was.

function number(name,   rest) {
  rest = $0
  sub(".*\"" name "\":", "", rest)
  return rest + 0
}
function complain(text) {
  print "coverage: " text
  bad = 1
}

# an empty file has no first line, so files are told apart by name
FILENAME == ARGV[1] { if ($0 !~ /^#/) floor[$1] = $2; next }

# "filename":…, "summary": {…, "lines": {"count": N, "covered": N, …}, …}, and "totals" in the end
/"filename":/ || /"totals":/ {
  room = match($0, /\/(src\/[a-z]+|dataset)\/[a-z_0-9]+\.[ch]pp/) ? substr($0, RSTART, RLENGTH) : ""
  sub(/\/[^\/]*$/, "", room)
  sub(/.*\//, "", room)
}
counts {
  lines[room] += number("count")
  covered[room] += number("covered")
}
{ counts = /"lines":$/ && room != "" }

END {
  for (room in lines) {
    ++counted
    share = lines[room] > 0 ? 100 * covered[room] / lines[room] : 0
    if (record) {
      printf "%s %d\n", room, (share > 1 ? share - 1 : 0)
      continue
    }
    printf "%-12s %6d lines %6.2f %%\n", room, lines[room], share
    if (!(room in floor)) complain(room " has no floor; scripts/coverage --record writes it")
    else if (!(share >= floor[room])) complain(room " is below its floor, " floor[room] " %")
  }
  if (counted == 0) complain("no room was counted")
  n = split(rooms, wanted, " ")
  for (i = 1; i <= n; ++i) if (!(wanted[i] in lines)) complain(wanted[i] " was not counted")
  if (!record) for (room in floor) if (!(room in lines)) complain(room " has a floor and was not counted")
  exit bad
}
