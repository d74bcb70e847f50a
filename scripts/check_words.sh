#!/bin/sh
# SPDX-License-Identifier: MIT
# check_words.sh [ROOT]: fails where a word that docs/glossary.md retires is used, where a comment's
# sentence has a clause of "what" or "who" as its subject, or where a joint, a bone or an effector is
# sought by a literal name and not by its JointKind, HumanoidBone or BodyPart. Readers and writers have
# names, and what takes or tells a user's words.
#
# The glossary's table under "Retired" has a word a row, or several with commas between them, each in
# backquotes. They are sought as they are spelled, as whole words, in C, C++ and TypeScript; single words
# in the pages too, but for the changelog, which tells of earlier versions.
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
named='^(src/(human|rig|measure|robot|formats|plan|core/messages)/|src/draw/mannequin|dataset/(export|show)_|include/shigusa/(body|goal)\.hpp|src/body/(joint_name|further_effectors|posture_modes|seat)\.|src/character/landmarks_json|src/document/(joint_names|character_export)|src/problem/task_supports)'
kernel=$(find include src dataset \( -name '*.hpp' -o -name '*.cpp' \) -print 2>/dev/null | LC_ALL=C sort | LC_ALL=C grep -vE "$named") || true

# found PLACES-WITH-TEXT MESSAGE: prints them, when there are any
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
