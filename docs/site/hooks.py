# SPDX-License-Identifier: MIT
"""What MkDocs asks for while it builds the site: pages that are not known before go below their part of the navigation."""
from pathlib import Path


def on_config(config):
    source = Path(config["docs_dir"])
    for part in config["nav"]:
        for title, entries in part.items():
            if title == "Reference":
                for entry in entries:
                    if isinstance(entry, dict) and "C++" in entry:
                        headers = sorted(page.name for page in source.glob("reference/cpp/*.md") if page.stem != "index")
                        entry["C++"] += [f"reference/cpp/{name}" for name in headers]
    return config
