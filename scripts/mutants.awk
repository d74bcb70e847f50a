# SPDX-License-Identifier: MIT
# Used by scripts/mutants. Writes a line for each possible small change to the given sources: FILE, LINE, COLUMN,
# the old text and the new text, separated by tabs.

function change(from, to) {
  ++changes
  old[changes] = from
  new[changes] = to
}
function tell(column, from, to) {
  printf "%s\t%d\t%d\t%s\t%s\n", FILENAME, FNR, column, from, to
}
# whether a place is outside strings and comments
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

# code that this build does not compile
FNR == 1 || /^#(else|endif)/ { elsewhere = 0 }
/^#ifdef __wasm_simd128__/ { elsewhere = 1 }
elsewhere || /SHG_ASSERT\(/ { next }

# lines without computation
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
  # numbers: times 1.5, whole numbers plus 1, 0 to 1
  start = 1
  while (match(substr($0, start), /[ (\[{-][0-9]+(\.[0-9]+)?(e-?[0-9]+)?[ ;,)\]}]/)) {
    column = start + RSTART
    number = substr($0, column, RLENGTH - 2)
    changed = number ~ /[.e]/ ? (number + 0 == 0 ? "1.0" : "(1.5 * " number ")") : number + 1
    if (is_code(column)) tell(column, number, changed)
    start = column + RLENGTH - 2
  }
}
