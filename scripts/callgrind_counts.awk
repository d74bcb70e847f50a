# SPDX-License-Identifier: MIT
# callgrind_counts.awk RECORDED COUNTED: read by scripts/callgrind_counts. Of two lists, lines of a body, how and a number of
# instructions, tells how far apart they are. Fails where one changed by more than `margin` per cent, where what was counted
# was not recorded, where what was recorded was not counted, but for a set of `lacking` (words), and where nothing was.

function complain(text) {
  print text
  bad = 1
}

FILENAME == ARGV[1] { if ($0 !~ /^#/) recorded[$1 " " $2] = $3; next }
{
  name = $1 " " $2
  ++counted[name]
  if (!(recorded[name] > 0)) { complain(name ": not recorded"); next }
  change = 100 * ($3 / recorded[name] - 1)
  printf "%s: %d instructions, recorded %d (%+.1f %%)\n", name, $3, recorded[name], change
  if (change > margin) complain("  slower: find out why")
  else if (change < -margin) complain("  faster: run scripts/callgrind_counts to record it")
}
END {
  n = split(lacking, word, " ")
  for (i = 1; i <= n; ++i) lacks[word[i]] = 1
  for (name in recorded) {
    if (name in counted) continue
    split(name, word, " ")
    if (!(word[2] in lacks)) complain(name ": not counted")
  }
  for (name in counted) any = 1
  if (!any) complain("nothing was counted")
  exit bad
}
