# SPDX-License-Identifier: MIT
# Used by scripts/mutants. Reads a report with lines of FATE, PLACE, CHANGE and the source's line, separated by
# tabs, and prints the survivors and the count of each fate. Fails if fewer than `least` per cent of those that
# compile are killed, if half do not compile, which indicates a broken build, or on an unknown fate.

BEGIN { FS = "\t" }
{ ++fates[$1] }
$1 == "survived" { printf "%s: %s: %s\n", $2, $3, $4 }
$1 !~ /^(killed|survived|does not compile)$/ { print "mutants: no fate: " $0; bad = 1 }
END {
  killed = fates["killed"] + 0
  tried = killed + fates["survived"]
  printf "%d killed, %d survived, %d do not compile\n", killed, fates["survived"], fates["does not compile"]
  if (2 * tried <= NR) { print "mutants: half of them do not compile, or there are none"; bad = 1 }
  if (100 * killed < least * tried) { print "mutants: fewer than " least " % are killed"; bad = 1 }
  exit bad
}
