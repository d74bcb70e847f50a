# SPDX-License-Identifier: MIT
# callgrind_counts.awk RECORDED COUNTED: used by scripts/callgrind_counts. Compares two lists with lines of a body,
# a mode and a number of instructions. Fails if a number changed by more than `margin` per cent, if a counted line
# was not recorded or the reverse (except those of the set `lacking`, words), and if nothing was counted.

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
