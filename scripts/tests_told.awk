# SPDX-License-Identifier: MIT
# tests_told.awk SKIPS CTEST_OUTPUT: used by common.sh. Prints ctest's output without passed tests, and only counts
# the skipped ones. With `strict` fails if a skipped test is not in SKIPS, whose lines have a name and a reason, if
# no test passed of one of `rooms` (words), as when its library is missing, or if none passed at all.

FILENAME == ARGV[1] { if ($0 !~ /^(#|$)/) may_skip[$1] = 1; next }
/^ *Start +[0-9]+: / { next }
/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .* Passed / {
  ++passed
  room = $0
  sub(/^.*Test +#[0-9]+: /, "", room)
  sub(/\..*/, "", room)
  ++passed_of[room]
  next
}
/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .*\*\*\*Skipped / {
  ++skipped
  name = $0
  sub(/^.*Test +#[0-9]+: /, "", name)
  sub(/ .*/, "", name)
  if (!(name in may_skip)) unknown = unknown " " name
  next
}
/^The following tests did not run:/ || /^\t *[0-9]+ - .* \(Skipped\)$/ { next }
/tests passed, / && skipped { print skipped " tests skipped what this machine lacks" }
{ print }

END {
  if (strict && unknown != "") { print "run_tests: skipped, and not in " ARGV[1] ":" unknown; bad = 1 }
  n = split(rooms, wanted, " ")
  for (i = 1; strict && i <= n; ++i) {
    if (passed_of[wanted[i]]) continue
    print "run_tests: no test of " wanted[i] " passed"
    bad = 1
  }
  if (strict && !passed) { print "run_tests: no test passed"; bad = 1 }
  exit bad
}
