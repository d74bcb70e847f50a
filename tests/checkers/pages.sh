# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Sourced by self_test.sh: tests the checkers of pages.

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

# the paper's map
fresh
write tests/core/good_test.cpp 'f'
write docs/paper_map.md '| 3 | a thing | `f` in `error.hpp`; `inline` | `core/good_test.cpp` |'
accepts check_paper_map.sh
refuses check_paper_map.sh docs/paper_map.md '| 3 | a thing | `g` in `error.hpp` | |' 'no g in error.hpp'
refuses check_paper_map.sh docs/paper_map.md '| 3 | a thing | `gone` | |' 'no gone in the sources'
refuses check_paper_map.sh docs/paper_map.md '| 3 | a thing | `f` in `core/gone.hpp` | |' 'no file core/gone.hpp'
refuses check_paper_map.sh docs/paper_map.md '| 3 | a thing | `f` | `core/gone_test.cpp` |' 'no file core/gone_test.cpp'

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
  # tutorial LINE…: writes a page that ends in these lines, for which the program makes a picture and prints a line
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

# README.md's commands and pictures
fresh
write program '#!/bin/sh' '[ "$1" != fail ] || exit 4' 'mkdir -p out/low' 'printf "%s" "$1" >out/low/candidate-1.svg'
chmod +x "$tree/program"
# readme COMMAND PICTURE: writes both pages with these
readme() {
  for page in README.md README.ja.md; do
    write $page '```sh' "shigusa $1" '```' '```cpp' 'int x;' '```' "![x](docs/images/readme/$2.svg)"
  done
}
check_readme() { sh "$scripts/check_readme.sh" "$tree/program" "$tree"; }
mkdir -p "$tree/docs/images/readme"
printf reach >"$tree/docs/images/readme/low.svg"
readme reach low
passes 'a good README' check_readme
readme fail low
fails_with 'a command of README.md fails' 'a command that fails' check_readme
readme other low
fails_with 'is not the picture' 'a picture of earlier' check_readme
readme reach high
fails_with 'no command of README.md makes docs/images/readme/high.svg' 'a picture that nothing makes' check_readme
readme reach low
write README.ja.md '```sh' 'shigusa other' '```'
fails_with 'has other commands' 'another page in Japanese' check_readme
for page in README.md README.ja.md; do write $page 'No command.'; done
fails_with 'shows no command' 'a page without commands' check_readme

# formulas
if command -v node >/dev/null && [ -e /usr/share/javascript/katex/katex.js ]; then
  fresh
  formulas() { node "$scripts/../docs/site/render_formulas.mjs" "$tree/site"; }
  write site/a.html '<span class="arithmatex">\(x^2\)</span>'
  passes 'a formula' formulas
  fails_with 'no formula' 'a site without formulas' formulas
  write site/a.html '<span class="arithmatex">\(\gone\)</span>'
  fails_with 'gone' 'a formula that is none' formulas
  write site/a.html '<span class="arithmatex">\(x^2\)</span><p class="arithmatex">x</p>'
  fails_with 'of neither form' 'a formula in another tag' formulas
fi

# empty trees
for checker in layers messages c_math spdx words prose paper_map spelling docs; do
  rm -rf "${tree:?}"/*
  write docs/glossary.md '## Retired' '| `OldName` | NewName |'
  write docs/site/words.txt 'shigusa'
  case $checker in spelling) rm "$tree/docs/glossary.md" ;; esac
  if sh "$scripts/check_$checker.sh" "$tree" >/dev/null 2>&1; then report "check_$checker.sh accepts a tree of nothing"; fi
done

# version
fresh
write include/shigusa/shigusa.hpp '#define SHIGUSA_VERSION_MAJOR 1' '#define SHIGUSA_VERSION_MINOR 2' \
  '#define SHIGUSA_VERSION_PATCH 3'
write bindings/c/include/shigusa.h '#define SHIGUSA_HEADER_VERSION "1.2.3"'
write CITATION.cff 'version: 1.2.3'
write CHANGELOG.md '# Changelog' '## 1.2.3' '## 1.2.2'
write debian/changelog 'shigusa (1.2.3) unstable; urgency=medium'
accepts check_version.sh
write CITATION.cff 'version: 1.2.2'
fails_with 'CITATION.cff: 1.2.2, of 1.2.3' 'another version of the citation' sh "$scripts/check_version.sh" "$tree"
write CITATION.cff 'version: 1.2.3'
write CHANGELOG.md '# Changelog' '## Unreleased' '## 1.2.3'
fails_with 'CHANGELOG.md: Unreleased' 'a changelog without the version' sh "$scripts/check_version.sh" "$tree"
