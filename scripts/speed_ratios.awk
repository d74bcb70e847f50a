# SPDX-License-Identifier: MIT
# speed_ratios.awk RECORDED MEASURED: used by scripts/check_speed_ratios. RECORDED has lines of a slow and a fast
# benchmark and a ratio, MEASURED is the benchmark's CSV. Fails if a ratio is less than half of the recorded one or
# was not measured (except names that end in a set of `lacking`, words), and if nothing was measured.

BEGIN { n_lacking = split(lacking, lacks, " ") }
function is_lacking(name,   i) {
  for (i = 1; i <= n_lacking; ++i) if (name ~ ("/" lacks[i] "$")) return 1
  return 0
}

FILENAME == ARGV[1] {
  if ($0 ~ /^#/) next
  slow[++n] = $1
  fast[n] = $2
  was[n] = $3
  next
}
{ split($0, cell, ",") }
/^name,/ { for (i in cell) if (cell[i] == "\"motions/s\"") column = i }
/_median"/ {
  gsub(/^"|_median"$/, "", cell[1])
  speed[cell[1]] = column && cell[column] ~ /^[0-9]/ ? cell[column] + 0 : 0
}
END {
  for (i = 1; i <= n; ++i) {
    if (!(speed[slow[i]] > 0 && speed[fast[i]] > 0)) {
      excused = is_lacking(fast[i])
      print "not measured here: " fast[i] " beside " slow[i] (excused ? ", which this machine lacks" : "")
      bad += !excused
      continue
    }
    ++compared
    ratio = speed[fast[i]] / speed[slow[i]]
    lost = !(ratio >= was[i] / 2)
    bad += lost
    printf "%s is %.1f times as fast as %s; recorded: %.1f%s\n", fast[i], ratio, slow[i], was[i], lost ? ". That is less than half" : ""
  }
  exit bad > 0 || !compared
}
