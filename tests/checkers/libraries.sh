# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Sourced by self_test.sh: tests the checkers of built libraries.

# a library that uses the C library's functions
fresh
write src/math/hidden.cpp '#include <cmath>' 'using namespace std;' \
  'double hidden(double y, double x) { return atan2(y, x); }'
accepts check_c_math.sh
"$compiler" -c "$tree/src/math/hidden.cpp" -o "$tree/hidden.o"
ar cr "$tree/libhidden.a" "$tree/hidden.o"
if sh "$scripts/check_c_math.sh" "$tree" "$tree/libhidden.a" >/dev/null 2>&1; then
  report "check_c_math.sh accepts a library that needs atan2"
fi

# functions that the files of a SIMD set share with others
# scorers LINE…: builds a library whose scorers and layers have these lines besides a function of
# their own pack
scorers() {
  fresh
  rm -f "$tree/libscorers.a"
  write other.cpp "$other"
  "$compiler" -c "$tree/other.cpp" -o "$tree/other.o"
  for set in avx2:8 avx512:16; do
    for kind in scorer:PackScorer layers:PackLayers; do
      class=${kind#*:}
      write set.cpp "template <int N> struct $class { int lanes() const; };" \
        'template <class T, int N> struct Pack { T lanes[N]; };' \
        "template <int N> int $class<N>::lanes() const { return N; }" \
        "int lanes_of() { return $class<${set#*:}>().lanes(); }" "$@"
      "$compiler" -c "$tree/set.cpp" -o "$tree/pack_${kind%:*}_${set%:*}.cpp.o"
    done
  done
  ar cr "$tree/libscorers.a" "$tree"/*.o
}
simd_symbols() { sh "$scripts/check_simd_symbols.sh" "$tree/libscorers.a" 2>&1; }

other='int other() { return 1; }'
scorers 'static int own() { return 1; }' 'int both() { return own(); }' 'int shared_data = 1;'
output=$(simd_symbols) || report "check_simd_symbols.sh refuses a good library: $output"
scorers 'inline int helper() { return 1; }' 'int use() { return helper(); }'
if output=$(simd_symbols); then report "check_simd_symbols.sh accepts a shared function"; fi
case $output in
  *"pack_scorer_avx2 shares with the rest of the program: helper()"*) ;;
  *) report "check_simd_symbols.sh refuses a shared function for another reason: $output" ;;
esac
# a pack of one set that occurs in another file
scorers 'inline int helper(const Pack<float, 8>&) { return 1; }' 'int use() { return helper({}); }'
if simd_symbols >/dev/null; then report "check_simd_symbols.sh accepts the pack of another set"; fi
other='template <class T, int N> struct Pack { T lanes[N]; };
inline int lanes(Pack<float, 8>) { return 8; }
int other() { return lanes({}); }'
scorers 'static int own() { return 1; }' 'int both() { return own(); }'
if simd_symbols >/dev/null; then report "check_simd_symbols.sh accepts a wide pack elsewhere"; fi
ar d "$tree/libscorers.a" pack_scorer_avx2.cpp.o
if simd_symbols >/dev/null; then report "check_simd_symbols.sh accepts a library without scorers"; fi
scorers
ar d "$tree/libscorers.a" pack_layers_avx512.cpp.o
if simd_symbols >/dev/null; then report "check_simd_symbols.sh accepts a library without layers"; fi

# the functions of the C interface
fresh
write door.cpp 'extern "C" int promised() { return 1; }'
"$compiler" -shared -fPIC "$tree/door.cpp" -o "$tree/door.so"
write list 'promised'
abi() { sh "$scripts/check_abi.sh" "$tree/$1" "$tree/$2"; }
passes 'what is promised' abi door.so list
write list 'gone' 'promised'
fails_with '< gone' 'a function that is gone' abi door.so list
write list 'other'
fails_with '> promised' 'a function that is not promised' abi door.so list
write none.cpp 'static int own;' 'int* own_of() { return &own; }'
"$compiler" -shared -fPIC -fvisibility=hidden "$tree/none.cpp" -o "$tree/none.so"
: >"$tree/list"
fails_with 'shows nothing' 'a library that shows nothing' abi none.so list
fails_with 'is not there' 'a library that is not there' abi gone.so list
"$compiler" -c "$tree/door.cpp" -o "$tree/door.o"
fails_with 'needs nothing' 'a library of no code' sh "$scripts/check_c_math.sh" "$tree" "$tree/door.o"
