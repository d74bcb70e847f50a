#!/bin/sh
# SPDX-License-Identifier: MIT
# check_docs.sh [ROOT]: fails where Doxygen warns of a public header: a declaration without a comment, or
# a comment that it cannot read. Exits with 77 where there is no Doxygen.
set -eu
scripts=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$scripts/..}"

command -v doxygen >/dev/null || {
  echo "check_docs: skipped, as there is no doxygen; scripts/build_docs installs it"
  exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{
  cat "$scripts/../docs/Doxyfile"
  echo "OUTPUT_DIRECTORY = $work"
  # without an output it would look at nothing
  echo "GENERATE_HTML = NO"
  echo "GENERATE_XML = YES"
} | doxygen - >/dev/null
