#!/bin/sh
# SPDX-License-Identifier: MIT
# check_spelling.sh [ROOT [SHIGUSA]]: fails if a page, or the help of the program SHIGUSA, has a word that is
# neither in hunspell's British dictionary nor in docs/site/words.txt. Ignores code and text between backquotes.
# Exits with 77 without hunspell.
set -eu
scripts=$(cd "$(dirname "$0")" && pwd)
program=${2:-}
cd "${1:-$scripts/..}"

command -v hunspell >/dev/null && hunspell -D </dev/null 2>&1 | grep -q '/en_GB$' || {
  echo "check_spelling: skipped, as there is no hunspell with its British dictionary; scripts/test installs them"
  exit 77
}
words=docs/site/words.txt
[ -f "$words" ] || { echo "check_spelling: no $words below $(pwd)" >&2; exit 1; }
LC_ALL=C sort -c -u "$words" || { echo "check_spelling: $words is not sorted, or has a word twice" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

pages=$(find README.md CONTRIBUTING.md CHANGELOG.md docs -name '*.md' 2>/dev/null | LC_ALL=C sort) || true
[ -n "$pages" ] || { echo "check_spelling: no pages below $(pwd)" >&2; exit 1; }
# a misspelt word, whose absence from the findings shows that the check does not work
echo 'wrongg' >"$work/canary"
pages="$pages $work/canary"
if [ -n "$program" ]; then
  "$program" manual --as markdown >"$work/manual"
  pages="$pages $work/manual"
fi
# shellcheck disable=SC2086  # no path in the project holds a space
{
  # without code, formulas, addresses, tags and names of files
  awk 'FNR == 1 { fenced = formula = 0 }
    /^ *(```|~~~)/ { fenced = !fenced; next }
    /^ *\$\$/ && !/\$\$.*\$\$/ { formula = !formula; next }
    !fenced && !formula' $pages | awk 'BEGIN { RS = "" } { gsub(/`[^`]*`/, " "); print $0 "\n" }' |
    sed -e 's/\](\([^)]*\))/ /g' -e 's|https*://[^ )>]*| |g' -e 's/\$\$*[^$]*\$\$*/ /g' \
      -e 's/<[^>]*>/ /g' -e 's/&[a-z]*;/ /g' -e "s/['’]s\\>//g" -e 's/[A-Za-z_./-]*[_/0-9][A-Za-z0-9_./-]*/ /g' \
      -e 's/[A-Za-z]*\.[A-Za-z][A-Za-z.]*/ /g' |
    LC_ALL=C.UTF-8 hunspell -d en_GB -p "$words" -l | LC_ALL=C sort -u |
    # without symbols, other scripts, and names such as BVH and MuJoCo
    LC_ALL=C grep -vE '[^ -~]|^[A-Z]+s?$|[a-z][A-Z]|^[A-Z][A-Z]|^.$' | while read -r word; do
    LC_ALL=C grep -nwF -- "$word" /dev/null $pages | cut -d : -f 1,2 | head -n 3 | sed "s|$work/||; s/\$/: $word/"
  done
} >"$work/found" || true
grep -q '^canary:1: wrongg$' "$work/found" || { echo "check_spelling: the pages could not be read" >&2; exit 1; }
sed -i '/^canary:1: wrongg$/d' "$work/found"
[ -s "$work/found" ] || exit 0
cat "$work/found"
echo "check_spelling: mend these words, or add those that are right to $words" >&2
exit 1
