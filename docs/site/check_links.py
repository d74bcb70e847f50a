# SPDX-License-Identifier: MIT
"""check_links.py SITE: fails where a page of the built site links to a page, a place on one or a file that is not there, or
loads anything from elsewhere. Links to the pages of others are for a reader to follow, and are not opened.
"""
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADED = {"img": "src", "script": "src", "link": "href", "source": "src", "video": "src", "iframe": "src", "object": "data"}
# of a <link> that loads nothing
POINTERS = {"canonical", "next", "prev"}
URL = re.compile(r"url\(\s*['\"]?([^'\")]+)")


class Page(HTMLParser):
    """The places on a page that can be linked to, and what it links to and loads."""

    def __init__(self, text):
        super().__init__()
        self.places = set()
        self.links = []
        self.loaded = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.places.update(attributes[name] for name in ("id", "name") if attributes.get(name))
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        if tag in LOADED and attributes.get(LOADED[tag]) and attributes.get("rel") not in POINTERS:
            self.loaded.append(attributes[LOADED[tag]])
        self.loaded += URL.findall(attributes.get("style") or "")


class Site:
    """The built site's files, and what is wrong with their links."""

    def __init__(self, root):
        self.root = root.resolve()
        self.pages = {path: Page(path.read_text(encoding="utf-8")) for path in self.root.rglob("*.html")}
        self.faults = set()

    def fault(self, path, text):
        self.faults.add(f"{path.relative_to(self.root)}: {text}")

    def check(self):
        for path, page in self.pages.items():
            for address in page.links:
                self.check_link(path, address)
            for address in page.loaded:
                self.check_loaded(path, address)
        for path in self.root.rglob("*.css"):
            for address in URL.findall(path.read_text(encoding="utf-8")):
                self.check_loaded(path, address)

    def target(self, path, address):
        """The file that an address is, beside a page."""
        local = unquote(urlsplit(address).path)
        if not local:
            return path
        base = self.root if local.startswith("/") else path.parent
        return (base / local.lstrip("/")).resolve()

    def check_link(self, path, address):
        parts = urlsplit(address)
        if parts.scheme or parts.netloc:
            return
        target = self.target(path, address)
        # the page of what is not found is shown at any address, so that its links begin at the root
        if target.is_dir() and path.name == "404.html":
            return
        if not target.is_file():
            self.fault(path, f"links to {address}, which is not there")
        elif parts.fragment and target in self.pages:
            place = unquote(parts.fragment)
            if place not in self.pages[target].places and not place.startswith("__"):
                self.fault(path, f"links to {address}, and there is no such place on that page")

    def check_loaded(self, path, address):
        parts = urlsplit(address)
        if parts.scheme == "data" or address.startswith("#"):
            return
        if parts.scheme or parts.netloc:
            self.fault(path, f"loads {address} from elsewhere")
        elif not self.target(path, address).is_file():
            self.fault(path, f"loads {address}, which is not there")


def main():
    site = Site(Path(sys.argv[1]))
    if not site.pages:
        sys.exit(f"check_links: no page in {sys.argv[1]}")
    site.check()
    for fault in sorted(site.faults):
        print(fault, file=sys.stderr)
    sys.exit(f"check_links: {len(site.faults)} faults" if site.faults else 0)


if __name__ == "__main__":
    main()
