#!/bin/sh
# SPDX-License-Identifier: MIT
# check_words.sh [ROOT]: fails on a word that docs/glossary.md retires, on a comment's sentence whose subject is a
# clause of "what" or "who", and on a joint, a bone or an effector that is sought by a literal name and not by its
# JointKind, HumanoidBone or BodyPart. Readers, writers and code for a user's words may have names.
#
# The glossary's table under "Retired" has one word per row, or several separated by commas, each in backquotes.
# They are sought as spelled, as whole words, in C, C++ and TypeScript; single words also in the pages, except the
# changelog, which describes earlier versions.
set -eu
cd "${1:-$(dirname "$0")/..}"

glossary=docs/glossary.md
[ -f "$glossary" ] || { echo "check_words: no $glossary below $(pwd)" >&2; exit 1; }
words=$(awk '/^## / { retired = /^## Retired/ } retired && /^\| *`/ { print $0 }' "$glossary" |
  cut -d '|' -f 2 | tr ',' '\n' | sed -n 's/^ *`\([^`]*\)` *$/\1/p')
[ -n "$words" ] || { echo "check_words: $glossary retires no word" >&2; exit 1; }

sources=$(find include src apps bindings examples bench tests studio/src \( -name node_modules -o -name dist \) -prune -o -type f \
  \( -name '*.hpp' -o -name '*.h' -o -name '*.cpp' -o -name '*.ts' \) -print 2>/dev/null | LC_ALL=C sort) || true
[ -n "$sources" ] || { echo "check_words: no sources below $(pwd)" >&2; exit 1; }
pages=$(find README.md CONTRIBUTING.md docs -name '*.md' ! -path "$glossary" 2>/dev/null | LC_ALL=C sort) || true

joints='"_?((left|right)_)?(hips?|knee|ankle|toes|foot|spine|chest|upper_chest|neck|jaw|clavicle|shoulder|elbow|wrist|hand|thigh|shank|(upper|lower)_(arm|leg))(\.[a-z]+)?"'
named='^(src/(human|rig|measure|robot|formats|plan|core/messages)/|src/draw/mannequin|dataset/(export|show)_|include/shigusa/(body|ergonomics|goal)\.hpp|src/cost/posture_parts|src/body/(joint_name|further_effectors|posture_modes|seat)\.|src/character/landmarks_json|src/document/(joint_names|character_export)|src/problem/task_supports)'
kernel=$(find include src dataset \( -name '*.hpp' -o -name '*.cpp' \) -print 2>/dev/null | LC_ALL=C sort | LC_ALL=C grep -vE "$named") || true

# found PLACES-WITH-TEXT MESSAGE: prints the places, if there are any, and the message
bad=0
found() {
  [ -n "$1" ] || return 0
  printf '%s\n' "$1" | sed 's/^\([^:]*:[0-9]*\):/\1: /'
  echo "check_words: $2" >&2
  bad=1
}
# shellcheck disable=SC2086  # no path in the project holds a space
{
  found "$(printf '%s\n' "$words" | LC_ALL=C grep -nwF -f - /dev/null $sources)" "$glossary retires these words"
  found "$(printf '%s\n' "$words" | sed '/ /d' | LC_ALL=C grep -nwF -f - /dev/null $pages)" \
    "$glossary retires these words"
  found "$(LC_ALL=C grep -nE '(^ *|[;{}),] +)//+<? *(What|Who) [^?]*$|//.*[.:] (What|Who) [^?]*$' /dev/null $sources)" \
    "these comments have no noun as their subject"
  found "$(LC_ALL=C grep -nE "^([^/]|/[^/])*$joints" /dev/null $kernel | grep -v '#include')" \
    "these names are literal: take JointKind, HumanoidBone or BodyPart"
}
exit "$bad"
