#!/bin/sh
# SPDX-License-Identifier: MIT
# check_readme.sh [--record] PROGRAM [ROOT]: runs the commands of README.md, and fails if one fails or makes another
# picture than the page shows; --record writes the pictures. Fails also if README.ja.md has other commands, other
# C++ or more than 110 lines; check_prose.sh counts the lines of README.md.
#
# The picture docs/images/readme/NAME.svg is out/NAME/candidate-1.svg.
set -eu
record=
if [ "$1" = --record ]; then
  record=yes
  shift
fi
program=$(realpath "$1")
cd "${2:-$(dirname "$0")/..}"
pictures=$PWD/docs/images/readme
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

bad=0
wrong() {
  echo "check_readme: $1" >&2
  bad=1
}

# blocks LANGUAGE FILE: the lines of the file's fenced blocks of that language, each command on one, without comments
blocks() {
  awk -v fence="\`\`\`$1" '/^```/ { inside = !inside && $0 == fence; next } inside' "$2" |
    sed -e ':more' -e '/\\$/{' -e N -e 's/ *\\\n */ /' -e 'b more' -e '}' -e 's/  *# .*$//'
}
commands() { blocks sh "$1" | grep '^shigusa ' || true; }

lines=$(wc -l <README.ja.md)
[ "$lines" -le 110 ] || wrong "README.ja.md has $lines lines; at most 110 are allowed"
[ "$(blocks sh README.md)" = "$(blocks sh README.ja.md)" ] || wrong "README.ja.md has other commands than README.md"
[ "$(blocks cpp README.md)" = "$(blocks cpp README.ja.md)" ] || wrong "README.ja.md has other C++ than README.md"

commands README.md >"$work/commands"
[ -s "$work/commands" ] || wrong "README.md shows no command"
[ -n "$(blocks cpp README.md)" ] || wrong "README.md shows no C++"
ln -s "$PWD/examples" "$work/examples"
mkdir "$work/bin"
ln -s "$program" "$work/bin/shigusa"
if ! (cd "$work" && PATH=$work/bin:$PATH sh -eu commands) >"$work/said" 2>&1; then
  cat "$work/said" >&2
  wrong "a command of README.md fails"
fi

[ -z "$record" ] || mkdir -p "$pictures"
for made in "$work"/out/*/candidate-1.svg; do
  [ -e "$made" ] || continue
  name=$(basename "$(dirname "$made")")
  grep -q "(docs/images/readme/$name.svg)" README.md || wrong "README.md shows no picture of out/$name"
  if [ -n "$record" ]; then
    cp "$made" "$pictures/$name.svg"
  elif ! cmp -s "$made" "$pictures/$name.svg"; then
    wrong "docs/images/readme/$name.svg is not the picture that the command makes now; scripts/make_gallery writes it"
  fi
done
# and each picture that it shows was made
for name in $(grep -o '(docs/images/readme/[^)]*\.svg)' README.md | sed 's/.*\///; s/\.svg)$//' | LC_ALL=C sort -u); do
  [ -e "$work/out/$name/candidate-1.svg" ] ||
    wrong "no command of README.md makes docs/images/readme/$name.svg"
done
exit "$bad"
