# SPDX-License-Identifier: MIT
# Read by scripts/mutants. Writes a line for each small change that can be made to the sources that
# it is given: FILE, LINE, COLUMN, what stands there and what takes its place, with tabs between.

function change(from, to) {
  ++changes
  old[changes] = from
  new[changes] = to
}
function tell(column, from, to) {
  printf "%s\t%d\t%d\t%s\t%s\n", FILENAME, FNR, column, from, to
}
# outside of "…" and of what stands behind //
function is_code(column,   before) {
  before = substr($0, 1, column - 1)
  return before !~ /\/\// && gsub(/"/, "", before) % 2 == 0
}

BEGIN {
  # clang-format puts spaces around operators and none into the brackets of templates
  change(" < ", " <= "); change(" <= ", " < "); change(" > ", " >= "); change(" >= ", " > ")
  change(" == ", " != "); change(" != ", " == "); change(" && ", " || "); change(" || ", " && ")
  change(" + ", " - "); change(" - ", " + "); change(" * ", " / "); change(" / ", " * ")
  change(" += ", " -= "); change(" -= ", " += "); change(" *= ", " /= ")
  change("max(", "min("); change("min(", "max("); change("sin(", "cos("); change("cos(", "sin(")
  change("true", "false"); change("false", "true")
  change("(-", "("); change("= -", "= "); change("return -", "return ")
}

# what this build does not compile
FNR == 1 || /^#(else|endif)/ { elsewhere = 0 }
/^#ifdef __wasm_simd128__/ { elsewhere = 1 }
elsewhere || /SHG_ASSERT\(/ { next }

# lines that hold no step of a computation
/^[ \t]*(\/\/|#|namespace|template|using|static_assert|friend)/ { next }

{
  for (i = 1; i <= changes; ++i) {
    start = 1
    while (at = index(substr($0, start), old[i])) {
      column = start + at - 1
      if (is_code(column)) tell(column, old[i], new[i])
      start = column + length(old[i])
    }
  }
  # numbers: half as much again, one more of whole ones, 1 for 0
  start = 1
  while (match(substr($0, start), /[ (\[{-][0-9]+(\.[0-9]+)?(e-?[0-9]+)?[ ;,)\]}]/)) {
    column = start + RSTART
    number = substr($0, column, RLENGTH - 2)
    changed = number ~ /[.e]/ ? (number + 0 == 0 ? "1.0" : "(1.5 * " number ")") : number + 1
    if (is_code(column)) tell(column, number, changed)
    start = column + RLENGTH - 2
  }
}
