#!/bin/sh
# SPDX-License-Identifier: MIT
# check_version.sh [ROOT]: fails unless shigusa.h, CITATION.cff, the first heading of CHANGELOG.md and the Debian package
# have the version of include/shigusa/shigusa.hpp.
set -eu
cd "${1:-$(dirname "$0")/..}"
version=$(sed -nE 's/^#define SHIGUSA_VERSION_(MAJOR|MINOR|PATCH) ([0-9]+)$/\2/p' include/shigusa/shigusa.hpp | paste -sd .)
for told in \
  "bindings/c/include/shigusa.h: $(sed -nE 's/^#define SHIGUSA_HEADER_VERSION "(.*)"$/\1/p' bindings/c/include/shigusa.h)" \
  "CITATION.cff: $(sed -n 's/^version: //p' CITATION.cff)" \
  "CHANGELOG.md: $(sed -n 's/^## //p' CHANGELOG.md | head -n 1)" \
  "debian/changelog: $(sed -nE '1s/^shigusa \(([^)]*)\).*/\1/p' debian/changelog)"; do
  [ "${told#*: }" = "$version" ] && [ -n "$version" ] || { echo "check_version: $told, of $version" >&2; exit 1; }
done
