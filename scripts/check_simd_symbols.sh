#!/bin/sh
# SPDX-License-Identifier: MIT
# check_simd_symbols.sh LIBRARY: fails if an object file of the static LIBRARY that is compiled for a SIMD set
# (pack_scorer_avx2, pack_layers_avx512, …) defines a function that other files may define too, and whose name lacks
# the set's pack. The linker keeps one copy of such functions, so the whole program might get the one with
# instructions that the machine lacks. Fails also if another file defines a function of such a pack, which it would
# pass in other registers.
set -eu
library=${1:?which library?}

# of what nm lists, W, w, i and u are functions (and unknown things) that files share; V is data
shared='^[0-9a-f]* [Wwiu] '
# clang's own; it calls two functions of the C++ runtime and nothing else
harmless=' __clang_call_terminate$'

# lines of the object file, a colon, and the symbol as printed by nm
symbols=$(nm --defined-only --demangle "$library" | awk '
  /^[^ ].*\.o(bj)?:$/ { file = substr($0, 1, length($0) - 1); next }
  { print file ": " $0 }')

bad=0
for set in scorer_avx2:Scorer:8 scorer_avx512:Scorer:16 layers_avx2:Layers:8 layers_avx512:Layers:16; do
  name=pack_${set%%:*}
  lanes=${set##*:}
  pack=${set#*:}
  pack=Pack${pack%:*}
  own=$(printf '%s\n' "$symbols" | sed -n "s/^$name\\.[^:]*: //p")
  if ! printf '%s\n' "$own" | grep -qF "$pack<$lanes>"; then
    echo "check_simd_symbols: $library has no $name with $pack<$lanes>" >&2
    bad=1
    continue
  fi
  found=$(printf '%s\n' "$own" | grep -E "$shared" | grep -vE "$harmless" |
    grep -vE "Pack<float, $lanes>|$pack<$lanes>") || continue
  printf '%s\n' "$found" | sed -E "s/$shared/$name shares with the rest of the program: /"
  bad=1
done
if printf '%s\n' "$symbols" | grep -vE '^pack_(scorer|layers)_avx' | grep -E ': [0-9a-f]* [WwiuTt] ' |
  grep -E 'Pack<float, (8|16)>'; then
  echo "check_simd_symbols: only the files of a SIMD set may use these packs"
  bad=1
fi
exit "$bad"
