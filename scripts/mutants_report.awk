# SPDX-License-Identifier: MIT
# Read by scripts/mutants. Of a report, lines of FATE, PLACE, CHANGE and the source's line with tabs between, prints the
# survivors and how many there are of each fate. Fails where fewer than `least` of a hundred that compile are killed,
# where half do not compile, which tells of a broken build, or where a fate is none.

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
