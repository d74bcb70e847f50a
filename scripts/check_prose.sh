#!/bin/sh
# SPDX-License-Identifier: MIT
# check_prose.sh [ROOT]: fails if README.md or a page of docs/tutorials has a sentence of more than 35 words or a
# line of more than 100 characters, or if README.md has more than 110 lines. Code, tables and link addresses are not
# counted; code between backquotes is one word.
set -eu
cd "${1:-$(dirname "$0")/..}"

pages=$(find README.md docs/tutorials -name '*.md' 2>/dev/null | LC_ALL=C sort) || true
[ -n "$pages" ] || { echo "check_prose: no README.md below $(pwd)" >&2; exit 1; }

# shellcheck disable=SC2086  # no path in the project holds a space
LC_ALL=C awk -v most_words=35 -v most_characters=100 -v most_lines=110 '
function complain(line, text) {
  printf "%s:%d: %s\n", file, line, text
  bad = 1
}
# code between backquotes may continue on the next line
function without_code(text) {
  if (in_code && !sub(/^[^`]*`/, "", text)) return ""
  gsub(/`[^`]*`/, "code", text)
  in_code = sub(/`.*/, "code", text)
  return text
}
function end_sentence() {
  if (words > most_words) complain(begin, "a sentence of " words " words, from \"" first "\" on; at most " most_words)
  words = 0
}
function end_file() {
  end_sentence()
  if (file == "README.md" && lines > most_lines) complain(lines, lines " lines; at most " most_lines)
}
FNR == 1 {
  if (NR > 1) end_file()
  file = FILENAME
  fenced = in_code = 0
}
{ lines = FNR }
/^ *(```|~~~)/ { fenced = !fenced; end_sentence(); next }
fenced || /^ *\|/ { next }
/^ *<!--.*-->$/ { next }
{
  text = $0
  gsub(/\]\([^)]*\)/, "]", text)
  gsub(/https?:[^ )>]*/, "URL", text)
  counted = text
  # only the first byte of a multibyte character counts
  gsub(/[\200-\277]/, "", counted)
  if (length(counted) > most_characters) complain(FNR, length(counted) " characters; at most " most_characters)
  if (text ~ /^ *$/) in_code = 0
  if (text ~ /^ *$/ || text ~ /^ *([-*+]|[0-9]+\.|#+|>) /) end_sentence()
  if (text ~ /^#/) next
  text = without_code(text)
  n = split(text, tokens, " ")
  for (i = 1; i <= n; ++i) {
    if (tokens[i] !~ /[A-Za-z0-9\300-\377]/) continue
    if (words == 0) { begin = FNR; first = tokens[i] }
    ++words
    if (tokens[i] ~ /[.!?]["*_)\]]*$/) end_sentence()
  }
}
END { end_file(); exit bad }' $pages
