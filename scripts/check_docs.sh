#!/bin/sh
# SPDX-License-Identifier: MIT
# check_docs.sh [ROOT [XML]]: fails if Doxygen warns about a public header of C++ or C: a declaration without a
# comment, or a comment that it cannot parse. Keeps Doxygen's output in XML/cpp and XML/c, if a folder is given.
# Exits with 77 without Doxygen.
set -eu
scripts=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$scripts/..}"

command -v doxygen >/dev/null || {
  echo "check_docs: skipped, as there is no doxygen; scripts/build_docs installs it"
  exit 77
}
work=${2:-}
if [ -z "$work" ]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
# read_headers OUTPUT DOXYFILE…: runs Doxygen with these settings into $work/OUTPUT
read_headers() {
  output=$1
  shift
  { cat "$@" && printf 'OUTPUT_DIRECTORY = %s\nXML_OUTPUT = %s\n' "$work" "$output"; } | doxygen - >/dev/null
}
docs=$scripts/../docs
more=$work/more
{ [ ! -d dataset/include ] || echo 'INPUT += dataset/include/shigusa'; } >"$more"
read_headers cpp "$docs/Doxyfile" "$more"
[ ! -d bindings/c ] || read_headers c "$docs/Doxyfile" "$docs/Doxyfile_c"

# Doxygen 1.9.4 does not warn about an enum's value without a comment
awk '
  FNR == 1 { value = 0 }
  /<memberdef / { ++members }
  /<memberdef kind="enum"/ { of = "" }
  /<enumvalue / { value = 1; told = 0; name = "" }
  /<name>/ { gsub(/ *<\/?name>/, ""); if (value) name = $0; else of = $0 }
  /<para>/ { if (value) told = 1 }
  /<\/enumvalue>/ {
    if (!told) { print "check_docs: no comment on " of "::" name; missing = 1 }
    value = 0
  }
  END {
    if (!members) print "check_docs: Doxygen found no declaration"
    exit missing || !members
  }' "$work"/*/*.xml
