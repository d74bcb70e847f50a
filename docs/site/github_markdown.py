# SPDX-License-Identifier: MIT
"""GitHub's Markdown in the form that Python-Markdown, which MkDocs has, reads alike: what belongs to an item of a list is
indented by four, and a blank line stands before a list or a table.
"""
import re

ITEM = re.compile(r"^( *)([-*+]|\d+[.)]) +(?=\S)")
FENCE = re.compile(r"^ *(`{3,}|~{3,})")


def converted(lines):
    """The lines of a page; those of fenced blocks move along with their item."""
    made, fence, columns, shift = [], None, [], 0  # columns: where the text of each open item begins
    for line in lines:
        found = FENCE.match(line)
        if fence is not None:
            made.append(moved(line, shift))
            if found and found[1].startswith(fence):
                fence = None
            continue
        if not line.strip():
            made.append(line)
            continue
        indent = len(line) - len(line.lstrip(" "))
        while columns and indent < columns[-1]:
            columns.pop()
        shift = 4 * len(columns) - (columns[-1] if columns else 0)
        if found:
            fence = found[1]
        item = ITEM.match(line)
        if begins_block(line, item, made[-1] if made else ""):
            made.append("")
        made.append(moved(line, shift))
        if item:
            columns.append(len(item[0]))
    return made


def moved(line, shift):
    """A line with that many more spaces before it."""
    return " " * shift + line if line.strip() and shift > 0 else line[-shift:] if shift < 0 and line.strip() else line


def begins_block(line, item, before):
    """Whether a list or a table begins right below a line of text."""
    if not before.strip() or before.startswith(("#", " ")):
        return False
    if line.startswith("|"):
        return not before.startswith("|")
    return bool(item) and not item[1] and not ITEM.match(before)
