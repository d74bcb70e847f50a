# SPDX-License-Identifier: MIT
"""stage.py TARGET: copies what the site is made of from docs/ into the folder TARGET.

Pages link to files beside docs/, as ../CONTRIBUTING.md or ../examples/tasks: such a page is copied to files/ of the
site, another text file and a folder become a page there that shows them, and the links are written anew.
"""
import json
import os
import re
import shutil
import sys
from pathlib import Path

import github_markdown

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
SITE = DOCS / "site"
KATEX = Path("/usr/share/javascript/katex")
LANGUAGES = {
    ".hpp": "cpp", ".cpp": "cpp", ".h": "c", ".c": "c", ".json": "json", ".mjs": "js", ".ts": "ts", ".py": "python",
    ".sh": "sh", ".cmake": "cmake", ".txt": "cmake",
}
MOST_SHOWN = 200_000  # bytes of a file that becomes a page; a larger one is copied as it is
LINK = re.compile(r'(\]\(|(?:src|href)=")([^)\s"]+)')


class Stage:
    """Pages that are to be written and those that are, each known by its source."""

    def __init__(self, target):
        self.target = target
        self.waiting = []  # (source, its place in the site)
        self.places = {}
        self.broken = []

    def place_of(self, source):
        """The place in the site, relative to its root, of a file or folder of the project; queued at the first call."""
        if source in self.places:
            return self.places[source]
        if source.is_relative_to(DOCS):
            place = source.relative_to(DOCS)
        else:
            place = Path("files") / source.relative_to(ROOT)
            if source.is_dir():
                readme = source / "README.md"
                if readme.is_file():
                    return self.place_of(readme)
                place /= "index.md"
            elif source.suffix != ".md" and is_shown(source):
                place = place.with_name(place.name + ".md")
        self.places[source] = place
        self.waiting.append((source, place))
        return place

    def run(self):
        while self.waiting:
            source, place = self.waiting.pop()
            if source.is_dir():
                self.write(place, self.listing(source, place))
            elif source.suffix == ".md":
                self.write(place, self.rewritten(source, place))
            elif place.suffix == ".md":
                self.write(place, shown(source))
            else:
                (self.target / place).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, self.target / place)

    def write(self, place, text):
        path = self.target / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def rewritten(self, source, place):
        """A page whose links lead to where their targets are in the site."""
        fence, lines = None, []
        for line in source.read_text(encoding="utf-8").splitlines():
            found = github_markdown.FENCE.match(line)
            if found and (fence is None or found[1].startswith(fence)):
                fence = found[1] if fence is None else None
            elif fence is None:
                line = self.rewritten_line(line, source, place)
            lines.append(line)
        return "\n".join(github_markdown.converted(lines)) + "\n"

    def rewritten_line(self, line, source, place):
        # a page that only the site has is named by its file there
        made = {os.path.relpath(name, place.parent) for name in re.findall(r"`build/docs/site/([^`]+)`", line)}
        line = re.sub(r"`build/docs/site/([^`]+)`", lambda name: f"[{name[1]}]({os.path.relpath(name[1], place.parent)})", line)

        def moved(link):
            address, hash_mark, fragment = link[2].partition("#")
            if not address or re.match(r"[a-z]+:", address) or address in made:
                return link[0]
            aim = Path(os.path.normpath(source.parent / address))
            if not aim.exists() or not aim.is_relative_to(ROOT):
                self.broken.append(f"{source.relative_to(ROOT)}: there is no {address}")
                return link[0]
            return link[1] + os.path.relpath(self.place_of(aim), place.parent) + hash_mark + fragment

        # code between backquotes is not a link
        parts = re.split(r"(`+[^`]*`+)", line)
        codes = parts[1::2]
        text = "\0".join(parts[::2])
        return re.sub("\0", lambda _: codes.pop(0), LINK.sub(moved, text))

    def listing(self, folder, place):
        lines = [f"# `{folder.relative_to(ROOT)}`", ""]
        for entry in sorted(folder.iterdir()):
            if entry.is_file() and not entry.name.startswith("."):
                lines.append(f"- [`{entry.name}`]({os.path.relpath(self.place_of(entry), place.parent)})")
        return "\n".join(lines) + "\n"


def is_shown(source):
    """Whether a file becomes a page of its text."""
    if source.stat().st_size > MOST_SHOWN:
        return False
    try:
        source.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return False
    return True


def shown(source):
    """A page with the text of a file, of a notebook with its cells."""
    text = source.read_text(encoding="utf-8").rstrip("\n")
    if source.suffix == ".ipynb":
        cells = [(cell["cell_type"], "".join(cell["source"])) for cell in json.loads(text)["cells"]]
        return "\n\n".join(told if kind == "markdown" else f"```python\n{told}\n```" for kind, told in cells) + "\n"
    fence = "`" * (max([2, *(len(run) for run in re.findall("`+", text))]) + 1)
    return f"# `{source.relative_to(ROOT)}`\n\n{fence}{LANGUAGES.get(source.suffix, 'text')}\n{text}\n{fence}\n"


def decisions():
    """The list of decisions, which docs/architecture.md has, as a page of its own."""
    rows = re.findall(r"^\d+\. \[.*\]\(decisions/.*\)$", (DOCS / "architecture.md").read_text(encoding="utf-8"), re.MULTILINE)
    return "# Decisions\n\nOne page each: what was decided, why, and what it costs.\n\n" + "\n".join(rows) + "\n"


def copy_site_files(target):
    """The stylesheet, the icon, and what formulas are set with."""
    (target / "katex/fonts").mkdir(parents=True)
    for name in ("site.css", "site.js"):
        shutil.copyfile(SITE / name, target / name)
    shutil.copyfile(ROOT / "studio/public/favicon.svg", target / "favicon.svg")
    # every browser of today reads the smallest of the three forms of a font
    style = re.sub(r",url\([^)]*\) format\('(?:woff|truetype)'\)", "", (KATEX / "katex.min.css").read_text(encoding="utf-8"))
    (target / "katex/katex.min.css").write_text(style, encoding="utf-8")
    for font in (KATEX / "fonts").glob("*.woff2"):
        shutil.copyfile(font, target / "katex/fonts" / font.name)


def main():
    target = Path(sys.argv[1])
    stage = Stage(target)
    for page in sorted(DOCS.rglob("*.md")):
        if not page.is_relative_to(SITE) and not page.stem.endswith("_remarks"):
            stage.place_of(page)
    for page in ("CHANGELOG.md", "CONTRIBUTING.md"):
        stage.place_of(ROOT / page)
    stage.run()
    stage.write(Path("decisions.md"), decisions())
    copy_site_files(target / "site")
    if stage.broken:
        sys.exit("\n".join(["stage: these links lead nowhere", *sorted(stage.broken)]))


if __name__ == "__main__":
    main()
