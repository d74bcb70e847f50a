# SPDX-License-Identifier: MIT
# Used by common.sh. Passes on the output of node:test, and fails if no test passed, or, with `strict`, if one was
# skipped for another reason than its duration.

{ print }
/^ *ok [0-9]+ .*# SKIP/ { if (tolower($0) !~ /# skip.*(night|long)/) unknown = unknown "\n" $0 }
/^# pass [0-9]+$/ { passed += $3 }

END {
  if (passed + 0 == 0) { print "node_tests: no test passed"; bad = 1 }
  if (strict && unknown != "") { print "node_tests: skipped:" unknown; bad = 1 }
  exit bad
}
