#!/bin/sh
# SPDX-License-Identifier: MIT
# self_test.sh COMPILER: shows on small trees that each checker of scripts/ refuses what it should,
# and accepts what it should.
set -eu
compiler=$1
scripts=$(cd "$(dirname "$0")/../../scripts" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# fresh: an empty tree with one file that every checker accepts
fresh() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree/include" "$tree/src"
  write include/shigusa/result.hpp '// SPDX-License-Identifier: MIT' '#include <string>' \
    '#include <tl/expected.hpp>' 'namespace shigusa {' 'inline double f(double x) { return x; }' '}'
}

# write PATH LINE…
write() {
  path=$tree/$1
  shift
  mkdir -p "$(dirname "$path")"
  printf '%s\n' "$@" >"$path"
}

report() {
  echo "self_test: $1"
  failures=$((failures + 1))
}

# accepts CHECKER: the tree as it stands passes
accepts() {
  output=$(sh "$scripts/$1" "$tree" 2>&1) || report "$1 refuses a good tree: $output"
}

# refuses CHECKER PATH LINE MESSAGE: a good tree and this file do not pass, and MESSAGE is told
refuses() {
  fresh
  write docs/glossary.md '## Retired' '| `OldName`, `so many` | NewName |'
  write "$2" "$3"
  if output=$(sh "$scripts/$1" "$tree" 2>&1); then
    report "$1 accepts '$3' in $2"
  else
    case $output in
      *"$2:1: $4"*) ;;
      *) report "$1 refuses '$3' in $2 for another reason: $output" ;;
    esac
  fi
}

# messages
fresh
write src/io/a.cpp 'return fail(ErrorCode::parse, say("no_goal"), "goal of " + name);' 'wrong("key", say("must_be_truth"));' \
  '// fail(ErrorCode::parse, "a text")' 'doubts.push_back(say("no_neck"));'
write src/io/file.cpp 'return fail(ErrorCode::io, "is a pipe");'
accepts check_messages.sh
refuses check_messages.sh src/io/a.cpp 'return fail(ErrorCode::parse, "a text", place);' 'no sentence'
refuses check_messages.sh src/io/a.cpp 'return fail(ErrorCode::parse, fmt::format("{}", a));' 'no sentence'
refuses check_messages.sh src/io/a.cpp 'return fail(ErrorCode::parse, name + " is none", place);' 'no sentence'
refuses check_messages.sh src/io/a.cpp 'reader.wrong("key", "must be true");' 'no sentence'
refuses check_messages.sh src/io/a.cpp 'doubts.push_back("a guess");' 'no sentence'

# layers
fresh
write src/generate/a.cpp '#include <shigusa/search.hpp>' '#include "search/b.hpp"' '#include "c.hpp"' '#include <fmt/core.h>'
write src/document/a.cpp '#include <shigusa/bvh.hpp>' '#include "../io/c.hpp"'
write include/shigusa/task_file.hpp '#include <shigusa/character.hpp>'
write include/shigusa/shigusa.hpp '#include <shigusa/task_file.hpp>'
write examples/one/main.cpp '#include <shigusa/shigusa.hpp>' '#include <shigusa/bvh.hpp>' '#include "local.hpp"'
write tests/search/a_test.cpp '#include <shigusa/body_model.hpp>' '#include "io/internal.hpp"'
write bench/a.cpp '#include "rollout/b.hpp"'
accepts check_layers.sh
public=include/shigusa
refuses check_layers.sh $public/vec3.hpp '#include <shigusa/body_model.hpp>' 'math must not include body'
refuses check_layers.sh $public/search.hpp '#include <shigusa/body_model.hpp>' 'search must not include body'
refuses check_layers.sh src/rollout/a.cpp '# include "shigusa/search.hpp"' 'rollout must not include search'
refuses check_layers.sh src/rollout/a.cpp '#include "search/b.hpp"' 'rollout must not include search'
refuses check_layers.sh src/generate/a.cpp '#include <shigusa/bvh.hpp>' 'generate must not include io'
refuses check_layers.sh src/io/a.cpp '#include <shigusa/task_file.hpp>' 'io must not include document'
refuses check_layers.sh src/math/a.cpp '#include "../body/b.hpp"' 'math must not include body'
refuses check_layers.sh src/math/a.cpp '#include "body/b.hpp"' 'math must not include body'
refuses check_layers.sh src/document/a.cpp '#include <shigusa/shigusa.hpp>' 'document must not include shigusa'
refuses check_layers.sh src/document/a.cpp '#include <shigusa/io/b.hpp>' '<shigusa/io/b.hpp> is no public header'
refuses check_layers.sh src/extra/a.cpp '#include <string>' '"extra" is not a room'
refuses check_layers.sh $public/extra.hpp '#include <string>' '"extra.hpp" belongs to no room'
refuses check_layers.sh $public/core/result.hpp '#include <string>' '"core/result.hpp" belongs to no room'
refuses check_layers.sh $public/file.hpp '#include <nlohmann/json.hpp>' 'a public header must not include'
refuses check_layers.sh $public/file.hpp '#include <cairo.h>' 'a public header must not include'
refuses check_layers.sh $public/file.hpp '#include "io/b.hpp"' 'a public header includes only'
refuses check_layers.sh apps/shigusa/a.cpp '#include "../../src/io/b.hpp"' 'apps must use public headers only'
refuses check_layers.sh examples/one/a.cpp '#include "io/b.hpp"' 'examples must use public headers only'
refuses check_layers.sh bindings/c/a.cpp '#include "io/b.hpp"' 'bindings must use public headers only'
refuses check_layers.sh tests/consumer/cxx/a.cpp '#include "io/b.hpp"' 'tests must use public headers only'

# the C library's functions
fresh
write src/math/own.hpp 'namespace shigusa {' 'double atan2(double y, double x);  // not std::atan2' \
  'inline double g(double y) { return atan2(y, 1.0) + sin_cos(y).sin + exponent(y); }' '}'
write src/io/text.cpp 'const char* help = "sin(x)";' 'char quote = '"'\"'"';'
accepts check_c_math.sh
for line in 'double y = std::sin(x);' 'double y = std :: acos (x);' 'float y = ::expf(x);' \
  'double y = cos(x);' 'float y = atan2f(x, x);' 'using std::pow;' 'double y = __builtin_log(x);' \
  'double y = (c == '"'\"'"' ? exp(x) : 0) + text("");'; do
  refuses check_c_math.sh src/math/a.cpp "$line" "the C library's function"
done
fresh
write src/math/hidden.cpp '#include <cmath>' 'using namespace std;' \
  'double hidden(double y, double x) { return atan2(y, x); }'
accepts check_c_math.sh
"$compiler" -c "$tree/src/math/hidden.cpp" -o "$tree/hidden.o"
ar cr "$tree/libhidden.a" "$tree/hidden.o"
if sh "$scripts/check_c_math.sh" "$tree" "$tree/libhidden.a" >/dev/null 2>&1; then
  report "check_c_math.sh accepts a library that needs atan2"
fi

# what the files of a SIMD set share with others
# scorers LINE…: a library whose scorers and layers have these lines beside a function of their own
# pack
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
# the pack of one set is another file's in the other
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

# comments of public headers
if command -v doxygen >/dev/null; then
  fresh
  write include/shigusa/face.hpp '/// All.' 'namespace shigusa {' '/// Gives x.' 'double f(double x);' '}'
  accepts check_docs.sh
  write include/shigusa/more.hpp 'namespace shigusa {' 'double g(double x);' '}'
  if sh "$scripts/check_docs.sh" "$tree" >/dev/null 2>&1; then
    report "check_docs.sh accepts a declaration without a comment"
  fi
  rm "$tree/include/shigusa/more.hpp"
  write bindings/c/include/shigusa.h '/** @file' ' * All. */' '/** Gives x. */' 'double f(double x);'
  accepts check_docs.sh
  write bindings/c/include/shigusa.h '/** @file' ' * All. */' '/* Gives x. */' 'double f(double x);'
  if sh "$scripts/check_docs.sh" "$tree" >/dev/null 2>&1; then
    report "check_docs.sh accepts a declaration of C without a comment"
  fi
fi

# licences
fresh
write scripts/tool '#!/bin/sh' '# SPDX-License-Identifier: MIT'
write CMakeLists.txt '# SPDX-License-Identifier: MIT'
write data.json '{}'
accepts check_spdx.sh
refuses check_spdx.sh src/core/a.cpp 'int a;' 'no SPDX'
refuses check_spdx.sh cmake/a.cmake 'set(a 1)' 'no SPDX'
fresh
write scripts/tool '#!/bin/sh' 'true'
if sh "$scripts/check_spdx.sh" "$tree" >/dev/null 2>&1; then
  report "check_spdx.sh accepts a script without a licence"
fi

# the paper's map
fresh
write tests/core/good_test.cpp 'f'
write docs/paper_map.md '| 3 | a thing | `f` in `result.hpp`; `inline` | `core/good_test.cpp` |'
accepts check_paper_map.sh
refuses check_paper_map.sh docs/paper_map.md '| 3 | a thing | `g` in `result.hpp` | |' 'no g in result.hpp'
refuses check_paper_map.sh docs/paper_map.md '| 3 | a thing | `gone` | |' 'no gone in the sources'
refuses check_paper_map.sh docs/paper_map.md '| 3 | a thing | `f` in `core/gone.hpp` | |' 'no file core/gone.hpp'
refuses check_paper_map.sh docs/paper_map.md '| 3 | a thing | `f` | `core/gone_test.cpp` |' 'no file core/gone_test.cpp'

# words
fresh
write docs/glossary.md '## Retired' '| retired | in its place |' '| `OldName`, `so many` | NewName |'
write src/core/good.hpp '// NewName, olderOldNames; asks what it is.' 'int OldNames;'
accepts check_words.sh
refuses check_words.sh src/core/a.cpp 'int OldName;' 'int OldName;'
refuses check_words.sh src/core/a.cpp 'int n;  // so many steps' 'int n;  // so many'
refuses check_words.sh src/core/a.cpp '// What it finds is kept.' '// What it finds'
refuses check_words.sh src/core/a.cpp '// It finds. Who asks gets it.' '// It finds. Who'
refuses check_words.sh docs/page.md 'see `OldName`' 'see `OldName`'

# prose
words() { printf 'word %.0s' $(seq "$1"); }
fresh
write README.md '# Title' "$(words 17)" "$(words 16)and [last](https://example.org/$(printf '%0100d' 0))." '' \
  '```' "$(words 40)" '```' "| $(words 40)|" 'In `one word of code of many` that counts as one.'
write docs/tutorials/a.md "$(printf '%.0sé' $(seq 100))"
accepts check_prose.sh
refuses check_prose.sh README.md "$(words 20 | sed 's/word/w/g')$(words 15 | sed 's/word/w/g')end." 'a sentence of 36 words'
refuses check_prose.sh docs/tutorials/a.md "$(printf '%0101d' 0)" '101 characters'
fresh
printf 'A line.\n%.0s' $(seq 111) >"$tree/README.md"
if sh "$scripts/check_prose.sh" "$tree" >/dev/null; then report "check_prose.sh accepts a README.md of 111 lines"; fi

# spelling
fresh
write docs/site/words.txt 'shigusa'
write README.md 'The colour of `quikc` code: $\\frac{a}{b}$, [shigusa](teh.html) and MuJoCo.' '```sh' 'teh' '```'
status=0
output=$(sh "$scripts/check_spelling.sh" "$tree" 2>&1) || status=$?
if [ "$status" != 77 ]; then
  [ "$status" = 0 ] || report "check_spelling.sh refuses a good tree: $output"
  write docs/page.md 'It is teh end.'
  if output=$(sh "$scripts/check_spelling.sh" "$tree" 2>&1); then report "check_spelling.sh accepts 'teh'"; fi
  case $output in
    *"docs/page.md:1: teh"*) ;;
    *) report "check_spelling.sh refuses 'teh' for another reason: $output" ;;
  esac
fi

# tutorials and the site's links
if command -v python3 >/dev/null; then
  # tutorial LINE…: a page that ends in these, of which the program makes a picture and prints a line
  tutorial() {
    write docs/tutorials/a.md '```sh' 'printf good >picture.svg; echo took 3 s, cost 7' '```' \
      '![A picture](../images/tutorials/a/picture.svg)' '' "$@"
    output=$(python3 "$tree/scripts/run_tutorials" --installed "$tree" 2>&1)
  }
  fresh
  mkdir -p "$tree/scripts" "$tree/docs/images/tutorials/a"
  cp "$scripts/run_tutorials" "$tree/scripts"
  printf good >"$tree/docs/images/tutorials/a/picture.svg"
  tutorial '```text' 'took 5 s, … 7' '```' '```c title="a/b.c"' 'int x;' '```' '```sh' 'grep int a/b.c' '```' ||
    report "run_tutorials refuses a good page: $output"
  if tutorial '```text' 'took 5 s, cost 8' '```'; then report "run_tutorials accepts output that is not printed"; fi
  if tutorial '```sh' 'false' '```'; then report "run_tutorials accepts a command that fails"; fi
  if tutorial '```json' '{}' '```'; then report "run_tutorials accepts a block that is neither run nor a file"; fi
  printf old >"$tree/docs/images/tutorials/a/picture.svg"
  if tutorial; then report "run_tutorials accepts a picture of earlier"; fi

  fresh
  write site/index.html '<a href="other.html#here">x</a><a href="https://example.org">y</a><img src="a.svg">'
  write site/other.html '<h2 id="here">z</h2>'
  write site/a.svg '<svg/>'
  links() { output=$(python3 "$scripts/../docs/site/check_links.py" "$tree/site" 2>&1); }
  links || report "check_links.py refuses a good site: $output"
  for line in '<a href="gone.html">x</a>' '<a href="other.html#there">x</a>' '<img src="b.svg">' \
    '<script src="https://example.org/a.js"></script>' '<p style="background: url(c.png)">x</p>'; do
    write site/index.html "$line"
    if links; then report "check_links.py accepts $line"; fi
  done
fi

[ "$failures" = 0 ]
