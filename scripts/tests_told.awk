# SPDX-License-Identifier: MIT
# tests_told.awk SKIPS CTEST_OUTPUT: read by common.sh. Of what ctest prints leaves out what passed and only counts what was
# skipped. With `strict` fails where a test was skipped that SKIPS, lines of a name and a reason, does not name, where of one
# of `rooms`, words, no test passed, as when a library that it needs is not there, or where none did at all.

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
