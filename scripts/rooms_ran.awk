# SPDX-License-Identifier: MIT
# rooms_ran.awk COUNTS ROOMS: used by common.sh. Fails if no test of a room of ROOMS (words) ran, by COUNTS, whose
# lines have a room and a number of tests.

FILENAME == ARGV[1] { ran[$1] += $2; next }
{
  for (i = 1; i <= NF; ++i) {
    ++rooms
    if (ran[$i] > 0) continue
    print "run_rooms: no test of " $i " ran"
    bad = 1
  }
}
END { exit bad || rooms == 0 }
