#!/bin/sh
# SPDX-License-Identifier: MIT
# check_spdx.sh [ROOT]: fails when a source, script or CMake file does not name its licence in its
# first line (a script: in its second).
set -eu
cd "${1:-$(dirname "$0")/..}"

# every file of ours in which a comment can stand, not what builds leave among them; scripts are known
# by their first two characters
find . \( -name .git -o -path ./build -o -path ./out -o -name node_modules -o -path './*/dist' \
  -o -name shigusa.mjs \) -prune -o -type f -print |
  LC_ALL=C sort | {
    bad=0
    while IFS= read -r file; do
      line=1
      case $file in
        *.hpp | *.h | *.cpp | *.cmake | *.cmake.in | */CMakeLists.txt | *.ts | *.mts | *.js | *.mjs) ;;
        *) if [ "$(head -c 2 "$file" | tr -d '\0')" = '#!' ]; then line=2; else continue; fi ;;
      esac
      sed -n "${line}p" "$file" | grep -qE '^(//|#) SPDX-License-Identifier: MIT$' || {
        echo "$file:$line: no SPDX-License-Identifier: MIT"
        bad=1
      }
    done
    exit "$bad"
  }
