# SPDX-License-Identifier: MIT
"""typescript_page.py TARGET: writes the reference of the TypeScript package from its sources, bindings/wasm/src.

What a module exports is shown with its comment: types whole, classes and functions without their bodies. It goes by the
sources' layout, which the linter keeps: an export begins a line, and a brace alone in the first column ends it.
"""
import re
import sys
from pathlib import Path

SOURCES = Path(__file__).resolve().parents[2] / "bindings/wasm/src"
MODULES = {
    "engine.ts": "In a page: two workers compute, and every call gives a promise. The module `.` of the package.",
    "door.ts": "In one thread, as Node.js has it: every call computes before it returns. The module `./door` of the package.",
    "errors.ts": "What is refused.",
    "types.ts": "The values that go in and out.",
    "task_types.ts": "Tasks and their parts, as the [schema of task files](task.md) has them.",
}
EXPORT = re.compile(r"^export (?:async )?(interface|class|type|const|function) (\w+)")
LEAD = """# TypeScript reference

[How the package is used](../files/bindings/wasm/README.md). Metres, kilograms, seconds and radians; +Y is up, a
body faces +Z and its left is +X; quaternions are `[x, y, z, w]`.
"""


def comment_above(lines, at):
    """The comment that ends above a line, as text."""
    begin = at
    if begin > 0 and lines[begin - 1].endswith("*/"):
        begin -= 1
        while not lines[begin].startswith("/**"):
            begin -= 1
    text = " ".join(line.strip().removeprefix("/**").removesuffix("*/").removeprefix("*").strip() for line in lines[begin:at])
    return text.strip()


def to_column_zero(lines, at):
    """A declaration that a closing bracket in the first column ends, or a semicolon outside of brackets."""
    depth = 0
    for end in range(at, len(lines)):
        code = lines[end].split(" // ")[0]
        depth += sum(code.count(c) for c in "{[(") - sum(code.count(c) for c in "}])")
        if depth == 0 and code.endswith((";", "}")):
            return lines[at:end + 1]
    sys.exit(f"typescript_page: {lines[at]}: has no end")


def signature(lines, at):
    """A function's first lines, without its body, and the line after them."""
    for end in range(at, len(lines)):
        if lines[end].endswith("{"):
            return [*lines[at:end], lines[end].removesuffix("{").rstrip() + ";"], end + 1
        if lines[end].endswith(";") or lines[end].endswith("}"):
            return lines[at:end + 1], end + 1
    sys.exit(f"typescript_page: {lines[at]}: has no end")


def class_text(lines, at):
    """A class with the signatures of what is not private."""
    text, comment, line = [lines[at]], [], at + 1
    while lines[line] != "}":
        if lines[line].startswith("  /**") or lines[line].startswith("   *"):
            comment.append(lines[line])
            line += 1
        elif re.match(r"  [\w*]", lines[line]):
            shown, after = signature(lines, line)
            if not lines[line].startswith("  private ") and not lines[line].startswith("  constructor(private"):
                text += comment + shown
            has_body = not lines[after - 1].endswith(("}", ";")) or lines[after - 1].endswith("{")
            line = after
            while has_body and lines[line] != "  }":
                line += 1
            line += has_body
            comment = []
        else:
            line += 1
    return [*text, "}"]


def section(lines, at, kind, name):
    if kind == "class":
        shown = class_text(lines, at)
    elif kind == "function":
        shown = signature(lines, at)[0]
    else:
        shown = to_column_zero(lines, at)
    comment = comment_above(lines, at)
    return "\n".join([f"### {name}", "", *([comment, ""] if comment else []), "```ts", *shown, "```", ""])


def main():
    parts = [LEAD]
    for module, about in MODULES.items():
        lines = (SOURCES / module).read_text(encoding="utf-8").splitlines()
        parts.append(f"## {module}\n\n{about}\n")
        for at, line in enumerate(lines):
            if found := EXPORT.match(line):
                parts.append(section(lines, at, *found.groups()))
    Path(sys.argv[1]).write_text("\n".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main()
