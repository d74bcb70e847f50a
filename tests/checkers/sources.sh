# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Sourced by self_test.sh: tests the checkers of sources.

# messages
fresh
write src/formats/a.cpp 'return fail(ErrorCode::parse, say("no_goal"), "goal of " + name);' 'wrong("key", say("must_be_truth"));' \
  '// fail(ErrorCode::parse, "a text")' 'doubts.push_back(say("no_neck"));'
write src/files/file.cpp 'return fail(ErrorCode::io, "is a pipe");'
accepts check_messages.sh
refuses check_messages.sh src/formats/a.cpp 'return fail(ErrorCode::parse, "a text", place);' 'no sentence'
refuses check_messages.sh src/formats/a.cpp 'return fail(ErrorCode::parse, fmt::format("{}", a));' 'no sentence'
refuses check_messages.sh src/formats/a.cpp 'return fail(ErrorCode::parse, name + " is none", place);' 'no sentence'
refuses check_messages.sh src/formats/a.cpp 'reader.wrong("key", "must be true");' 'no sentence'
refuses check_messages.sh src/formats/a.cpp 'doubts.push_back("a guess");' 'no sentence'

# layers
fresh
write src/generate/a.cpp '#include <shigusa/search.hpp>' '#include "search/b.hpp"' '#include "c.hpp"' '#include <fmt/core.h>'
write src/document/a.cpp '#include <shigusa/formats.hpp>' '#include "../formats/c.hpp"'
write include/shigusa/files.hpp '#include <shigusa/character.hpp>'
write include/shigusa/shigusa.hpp '#include <shigusa/files.hpp>'
write examples/one/main.cpp '#include <shigusa/shigusa.hpp>' '#include <shigusa/formats.hpp>' '#include "local.hpp"'
write tests/search/a_test.cpp '#include <shigusa/body.hpp>' '#include "formats/internal.hpp"'
write bench/a.cpp '#include "rollout/b.hpp"'
write dataset/a.cpp '#include <shigusa/files.hpp>' '#include "formats/b.hpp"' '#include "c.hpp"'
write src/files/a.cpp '#include <unistd.h>' '#include <sys/stat.h>' '#include <csignal>'
write tests/files/a_test.cpp '#include "files/b.hpp"' '#include <fcntl.h>'
write apps/shigusa/system_posix.cpp '#include <signal.h>'
write apps/shigusa/b.cpp '#include "problem/b.hpp"'
accepts check_layers.sh
public=include/shigusa
refuses check_layers.sh $public/math.hpp '#include <shigusa/body.hpp>' 'math must not include body'
refuses check_layers.sh $public/search.hpp '#include <shigusa/body.hpp>' 'search must not include body'
refuses check_layers.sh src/rollout/a.cpp '# include "shigusa/search.hpp"' 'rollout must not include search'
refuses check_layers.sh src/rollout/a.cpp '#include "search/b.hpp"' 'rollout must not include search'
refuses check_layers.sh src/generate/a.cpp '#include <shigusa/formats.hpp>' 'generate must not include formats'
refuses check_layers.sh src/formats/a.cpp '#include <shigusa/files.hpp>' 'formats must not include document'
refuses check_layers.sh src/math/a.cpp '#include "../body/b.hpp"' 'math must not include body'
refuses check_layers.sh src/math/a.cpp '#include "body/b.hpp"' 'math must not include body'
refuses check_layers.sh src/document/a.cpp '#include <shigusa/shigusa.hpp>' 'document must not include shigusa'
refuses check_layers.sh src/document/a.cpp '#include <shigusa/formats/b.hpp>' '<shigusa/formats/b.hpp> is no public header'
refuses check_layers.sh dataset/a.cpp '#include "generate/b.hpp"' 'dataset must not include "generate/b.hpp"'
refuses check_layers.sh apps/shigusa/b.cpp '#include "search/b.hpp"' 'apps must not include "search/b.hpp"'
refuses check_layers.sh src/document/a.cpp '#include <fcntl.h>' '<fcntl.h> is the operating system'
refuses check_layers.sh src/core/a.cpp '# include <sys/mman.h>' '<sys/mman.h> is the operating system'
refuses check_layers.sh dataset/a.cpp '#include "unistd.h"' '<unistd.h> is the operating system'
refuses check_layers.sh apps/shigusa/a.cpp '#include <spawn.h>' '<spawn.h> is the operating system'
refuses check_layers.sh bindings/c/src/failure.cpp '#include <new>' 'may include what is the operating system'
refuses check_layers.sh src/extra/a.cpp '#include <string>' '"extra" is not a room'
refuses check_layers.sh $public/extra.hpp '#include <string>' '"extra.hpp" belongs to no room'
refuses check_layers.sh $public/core/result.hpp '#include <string>' '"core/result.hpp" belongs to no room'
refuses check_layers.sh $public/file.hpp '#include <nlohmann/json.hpp>' 'a public header must not include'
refuses check_layers.sh $public/file.hpp '#include <cairo.h>' 'a public header must not include'
refuses check_layers.sh $public/file.hpp '#include "formats/b.hpp"' 'a public header includes only'
refuses check_layers.sh apps/shigusa/a.cpp '#include "../../src/formats/b.hpp"' 'apps must not include'
refuses check_layers.sh examples/one/a.cpp '#include "formats/b.hpp"' 'examples must use public headers only'
refuses check_layers.sh bindings/c/a.cpp '#include "formats/b.hpp"' 'bindings must not include'
refuses check_layers.sh tests/consumer/cxx/a.cpp '#include "formats/b.hpp"' 'tests must use public headers only'

# the C library's functions
fresh
write src/math/own.hpp 'namespace shigusa {' 'double atan2(double y, double x);  // not std::atan2' \
  'inline double g(double y) { return atan2(y, 1.0) + sin_cos(y).sin + exponent(y); }' '}'
write src/formats/text.cpp 'const char* help = "sin(x)";' 'char quote = '"'\"'"';'
accepts check_c_math.sh
for line in 'double y = std::sin(x);' 'double y = std :: acos (x);' 'float y = ::expf(x);' \
  'double y = cos(x);' 'float y = atan2f(x, x);' 'using std::pow;' 'double y = __builtin_log(x);' \
  'double y = (c == '"'\"'"' ? exp(x) : 0) + text("");'; do
  refuses check_c_math.sh src/math/a.cpp "$line" "the C library's function"
done

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

# words
fresh
write docs/glossary.md '## Retired' '| retired | in its place |' '| `OldName`, `so many` | NewName |'
write src/core/good.hpp '// NewName, olderOldNames; asks what it is.' 'int OldNames;'
accepts check_words.sh
refuses check_words.sh src/core/a.cpp 'int OldName;' 'int OldName;'
refuses check_words.sh src/core/a.cpp 'int n;  // so many steps' 'int n;  // so many'
refuses check_words.sh src/core/a.cpp '// What it finds is kept.' '// What it finds'
refuses check_words.sh src/core/a.cpp '// It finds. Who asks gets it.' '// It finds. Who'
refuses check_words.sh src/core/a.cpp 'body.find_dof("left_knee.flexion");' 'body.find_dof("left_knee'
refuses check_words.sh src/core/a.cpp 'if (name.ends_with("_hand"))' 'if (name'
refuses check_words.sh docs/page.md 'see `OldName`' 'see `OldName`'
