#!/bin/sh
# SPDX-License-Identifier: MIT
# check_spdx.sh [ROOT]: fails if a source, script or CMake file does not name its licence in its first line
# (scripts: in the second). It is MIT, and GPL-3.0-or-later in bindings/blender, which imports Blender's.
set -eu
cd "${1:-$(dirname "$0")/..}"
find . -name '*.[ch]pp' | grep -q . || { echo "check_spdx: no sources below $(pwd)" >&2; exit 1; }

# all of the project's files that can hold a comment, without build outputs; scripts are recognised by their first
# two characters
find . \( -name .git -o -path ./build -o -path ./out -o -name node_modules -o -path './*/dist' \
  -o -name shigusa.mjs \) -prune -o -type f -size +0 -print0 | LC_ALL=C sort -z |
  LC_ALL=C xargs -0 awk '
    FNR == 1 {
      blender = FILENAME ~ /^\.\/bindings\/blender\/.*\.(py|toml)$/
      licence = blender ? "GPL-3.0-or-later" : "MIT"
      script = !blender && FILENAME !~ /(\.(hpp|h|cpp|cmake|cmake\.in|ts|mts|js|mjs)|\/CMakeLists\.txt)$/
      if (script && /^#!/) next
      if (script) nextfile
    }
    {
      if ($0 !~ "^(//|#) SPDX-License-Identifier: " licence "$") {
        print FILENAME ":" FNR ": no SPDX-License-Identifier: " licence
        bad = 1
      }
      nextfile
    }
    END { exit bad }'
