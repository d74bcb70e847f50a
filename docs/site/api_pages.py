# SPDX-License-Identifier: MIT
"""api_pages.py XML TARGET: writes the site's reference of C++ and C from what Doxygen read of the headers.

XML holds what scripts/check_docs.sh keeps. TARGET/cpp gets a page for each header, in the header's own order, and the
list of headers; TARGET/c gets shigusa.h.
"""
import re
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

SITE = Path(__file__).resolve().parent
CLASSES = ("class", "struct", "union", "concept")
# Doxygen takes two hyphens for a dash
SYMBOLS = {"ndash": "--", "mdash": "---", "nonbreakablespace": "&nbsp;", "linebreak": "<br>", "zwj": ""}
LONGEST_VALUE = 60  # characters of an initialiser that is shown
LONGEST_LINE = 76  # of a declaration before each argument has a line of its own


@dataclass
class Name:
    """A name of the interface: its element of Doxygen's XML, its header, line, anchor and the names within."""
    element: ElementTree.Element
    header: str
    line: int
    anchor: str
    title: str
    inside: list = field(default_factory=list)

    @property
    def kind(self):
        return self.element.get("kind")


class Reference:
    """All names of an interface, by header, and where each is to be found."""

    def __init__(self, xml, language):
        self.language = language
        self.headers = {}  # header: [Name]
        self.places = {}  # Doxygen's id: (header, anchor)
        self.known = {}  # a title: its places
        for path in sorted(xml.glob("*.xml")):
            for compound in ElementTree.parse(path).getroot().findall("compounddef"):
                self.read_compound(compound)
        for names in self.headers.values():
            names.sort(key=lambda name: name.line)

    def read_compound(self, compound):
        if compound.get("kind") in CLASSES and compound.get("prot", "public") == "public":
            title = compound.findtext("compoundname").removeprefix("shigusa::").replace("< ", "<").replace(" >", ">")
            name = self.add(compound, title, title)
            for section in compound.findall("sectiondef"):
                if section.get("kind").startswith(("public", "user-defined")):
                    for member in section.findall("memberdef"):
                        if member.findtext("name").startswith("~"):
                            continue
                        name.inside.append(self.made(member, f"{title}.{member.findtext('name')}", member.findtext("name")))
            name.inside.sort(key=lambda inner: inner.line)
        elif compound.get("kind") in ("namespace", "file"):
            for member in compound.iter("memberdef"):
                # a file has the members of its namespaces too, as those have
                if member.get("id") not in self.places:
                    title = member.findtext("name").replace("< ", "<").replace(" >", ">")
                    self.add(member, title, title)

    def made(self, element, anchor, title):
        place = element.find("location")
        header = Path(place.get("file")).name
        anchor = anchor.replace("@", "enum-")  # one without a name
        if "operator" in anchor:
            anchor = re.sub(r"[^\w.:]", lambda sign: f"-{ord(sign[0]):x}", anchor)
        anchor = re.sub(r"[^\w.:~-]+", "-", anchor).strip("-")
        self.places[element.get("id")] = (header, anchor)
        for value in element.findall("enumvalue"):
            self.places[value.get("id")] = (header, anchor)
        return Name(element, header, int(place.get("line", 0)), anchor, title)

    def add(self, element, anchor, title):
        name = self.made(element, anchor, title)
        self.headers.setdefault(name.header, []).append(name)
        self.known.setdefault(title, set()).add((name.header, name.anchor))
        return name

    def link(self, place, text, here):
        header, anchor = place
        page = "" if header == here else page_of(header).replace(".md", ".html")
        return f'<a href="{page}#{anchor}">{text}</a>'


def page_of(header):
    """The page of a header."""
    return "index.md" if header.endswith(".h") else header.replace(".hpp", ".md")


def tightened(code):
    """Doxygen's spaces within types, taken out of HTML."""
    return code.replace("&lt; ", "&lt;").replace(" &gt;", "&gt;").replace(" &amp;", "&amp;").replace(" *", "*")


class Page:
    """Writes the page of one header."""

    def __init__(self, reference, header):
        self.reference = reference
        self.header = header

    # text

    def code(self, element):
        """An element of types as HTML, with links."""
        if element is None:
            return ""
        text = escape(element.text or "", quote=False)
        for child in element:
            inner = self.code(child)
            place = self.reference.places.get(child.get("refid"))
            text += self.reference.link(place, inner, self.header) if place else inner
            text += escape(child.tail or "", quote=False)
        return tightened(text.strip() if element.tag in ("type", "defval") else text)

    def prose(self, element):
        """A comment as HTML."""
        text = escape(element.text or "", quote=False)
        for child in element:
            text += self.inline(child) + escape(child.tail or "", quote=False)
        return text

    def inline(self, child):
        if child.tag == "computeroutput":
            text = "".join(child.itertext())
            places = self.reference.known.get(text.removesuffix("()"), ())
            shown = f"<code>{escape(text, quote=False)}</code>"
            return self.reference.link(next(iter(places)), shown, self.header) if len(places) == 1 else shown
        if child.tag == "ref":
            place = self.reference.places.get(child.get("refid"))
            return self.reference.link(place, self.prose(child), self.header) if place else self.prose(child)
        tags = {"itemizedlist": "ul", "orderedlist": "ol", "listitem": "li", "bold": "strong", "emphasis": "em",
                "para": "p", "subscript": "sub", "superscript": "sup"}
        if child.tag in SYMBOLS:
            return SYMBOLS[child.tag]
        if child.tag == "blockquote":
            # a comment that begins with "greater than"
            return "&gt; " + " ".join(self.prose(para).strip() for para in child.findall("para"))
        if child.tag not in tags:
            sys.exit(f"api_pages: {self.header}: a comment has <{child.tag}>, which the pages have no form for")
        tag = tags[child.tag]
        return f"<{tag}>{self.prose(child)}</{tag}>"

    def comment(self, element):
        """The whole comment of a name: its first sentence, which Doxygen takes out, and the rest."""
        paragraphs = [self.prose(para).strip() for part in ("briefdescription", "detaileddescription")
                      for para in element.findall(f"{part}/para")]
        return "<br>".join(filter(None, [" ".join(paragraphs[:2]), *paragraphs[2:]]))

    # declarations

    def template(self, element):
        parameters = element.find("templateparamlist")
        if parameters is None:
            return ""
        inner = ", ".join(self.parameter(parameter) for parameter in parameters.findall("param"))
        return f"template &lt;{inner}&gt;\n"

    def parameter(self, parameter):
        text = self.code(parameter.find("type"))
        name = parameter.findtext("declname") or parameter.findtext("defname") or ""
        text += f" {name}" if name and not re.search(r"(class|typename) " + re.escape(name) + "$", text) else ""
        text += escape(parameter.findtext("array") or "", quote=False)
        value = parameter.find("defval")
        return text + (f" = {self.code(value)}" if value is not None else "")

    def function(self, element, name):
        words = ["static"] if element.get("static") == "yes" and self.reference.language == "cpp" else []
        words += ["explicit"] if element.get("explicit") == "yes" else []
        start = " ".join(filter(None, [*words, self.code(element.find("type")), f"<b>{escape(name, quote=False)}</b>"]))
        arguments = [self.parameter(parameter) for parameter in element.findall("param")]
        suffix = tightened(escape(re.sub(r"^\(.*\)", "", element.findtext("argsstring") or "", flags=re.DOTALL), quote=False))
        line = f"{start}({', '.join(arguments)}){suffix}"
        if len(plain(line)) > LONGEST_LINE and arguments:
            line = f"{start}(\n    " + ",\n    ".join(arguments) + f"){suffix}"
        return self.template(element) + line

    def variable(self, element, name):
        value = self.code(element.find("initializer")).strip()
        if len(plain(value)) > LONGEST_VALUE or "\n" in value:
            value = "= …"
        between = " " if value.startswith("=") else ""
        kind = self.code(element.find("type"))
        after = element.findtext("argsstring") or ""
        if "(*" in kind or kind.endswith("("):
            after = tightened(escape(after, quote=False))
            return f"{kind}<b>{escape(name, quote=False)}</b>{after}"
        return f"{self.template(element)}{kind} <b>{escape(name, quote=False)}</b>{escape(after)}{between}{value}"

    def declaration(self, name):
        """What the header declares, as HTML."""
        element, kind = name.element, name.kind
        title = name.title
        if kind == "function":
            return self.function(element, title)
        if kind == "variable":
            return self.variable(element, title)
        if kind == "typedef":
            target = self.code(element.find("type"))
            if self.reference.language == "c":
                return f"typedef {target} <b>{title}</b>"
            return f"{self.template(element)}using <b>{title}</b> = {target.removeprefix('typedef ')}"
        if kind == "define":
            arguments = [parameter.findtext("defname") for parameter in element.findall("param")]
            value = (element.findtext("initializer") or "").strip()
            shown = f"({', '.join(arguments)})" if arguments else (f" {value}" if re.fullmatch(r"[\w.]+", value) else "")
            return f"#define <b>{title}</b>{escape(shown)}"
        if kind == "enum":
            scoped = " class" if element.get("strong") == "yes" else ""
            return f"enum{scoped}" + ("" if title.startswith("@") else f" <b>{title}</b>")
        bases = ", ".join(self.code(base) for base in element.findall("basecompoundref"))
        return f"{self.template(element)}{kind} <b>{escape(title, quote=False)}</b>" + (f" : {bases}" if bases else "")

    # pages

    def entry(self, name, with_anchor=True):
        """A name with its comment, as an entry of a list."""
        anchor = f' id="{escape(name.anchor)}"' if with_anchor else ""
        return f"<dt{anchor}><code>{self.declaration(name)}</code></dt>\n<dd>{self.comment(name.element)}</dd>"

    def values(self, element):
        for value in element.findall("enumvalue"):
            number = (value.findtext("initializer") or "").strip()
            shown = f"<b>{value.findtext('name')}</b>" + (f" {number}" if number else "")
            yield f"<dt><code>{shown}</code></dt>\n<dd>{self.comment(value)}</dd>"

    def section(self, names):
        """Names that are spelled alike, such as overloads, under one heading."""
        first = names[0]
        title = first.title if not first.title.startswith("@") else plain(self.comment(first.element)).rstrip(".")
        lines = [f"## {title.replace('<', '&lt;')} {{ #{first.anchor} }}", ""]
        for name in names:
            lines.append(f'<pre class="declaration"><code>{self.declaration(name)}</code></pre>\n')
            lines.append(f"<p>{self.comment(name.element)}</p>\n")
            entries = [*self.values(name.element), *(self.entry(inner, i == 0 or inner.anchor != name.inside[i - 1].anchor)
                                                     for i, inner in enumerate(name.inside))]
            if entries:
                lines.append('<dl class="members">\n' + "\n".join(entries) + "\n</dl>\n")
        return "\n".join(lines)

    def text(self, title, lead):
        names = self.reference.headers[self.header]
        constants = [name for name in names if name.kind in ("variable", "define")]
        groups = {}
        for name in names:
            if name not in constants:
                groups.setdefault(name.anchor, []).append(name)
        parts = [f"# {title}", "", lead, ""]
        if self.reference.language == "cpp":
            parts += [f'<pre class="declaration"><code>#include &lt;shigusa/{self.header}&gt;</code></pre>', ""]
        parts += [self.section(group) for group in groups.values()]
        if constants:
            parts += ["## Constants and macros\n", '<dl class="members">', *(self.entry(name) for name in constants), "</dl>"]
        return "\n".join(parts) + "\n"


def plain(html):
    return re.sub(r"<[^>]*>", "", html)


def write_cpp(xml, target):
    """A page for each header and the list of all."""
    reference = Reference(xml, "cpp")
    overview = (SITE / "reference_cpp.md").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| `(\w+\.hpp)` \| (.*) \|$", overview, re.MULTILINE))
    headers = {path.name for within in ("include", "dataset/include") for path in (SITE.parents[1] / within / "shigusa").glob("*.hpp")}
    if wrong := headers.symmetric_difference(rows):
        sys.exit(f"api_pages: docs/site/reference_cpp.md and include/shigusa and dataset/include do not all have {', '.join(sorted(wrong))}")
    pages = headers & set(reference.headers)
    overview = re.sub(r"`(\w+\.hpp)`", lambda found: f"[`{found[1]}`]({page_of(found[1])})" if found[1] in pages else found[0],
                      overview)
    target.mkdir(parents=True, exist_ok=True)
    (target / "index.md").write_text(overview, encoding="utf-8")
    for header in sorted(pages):
        lead = rows[header][0].upper() + rows[header][1:] + ". [All headers](index.md)"
        (target / page_of(header)).write_text(Page(reference, header).text(header, lead), encoding="utf-8")


def write_c(xml, target):
    """The one page of the C interface; its lead is the header's own comment."""
    reference = Reference(xml, "c")
    page = Page(reference, "shigusa.h")
    file = ElementTree.parse(xml / "shigusa_8h.xml").getroot().find("compounddef")
    target.mkdir(parents=True, exist_ok=True)
    paragraphs = [f"<p>{page.prose(para)}</p>" for part in ("briefdescription", "detaileddescription")
                  for para in file.findall(f"{part}/para")]
    (target / "index.md").write_text(page.text("C reference: shigusa.h", "\n".join(paragraphs)), encoding="utf-8")


def main():
    xml, target = Path(sys.argv[1]), Path(sys.argv[2])
    write_cpp(xml / "cpp", target / "cpp")
    write_c(xml / "c", target / "c")


if __name__ == "__main__":
    main()
