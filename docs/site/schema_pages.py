# SPDX-License-Identifier: MIT
"""schema_pages.py TARGET: writes the pages of task files, results and plans from docs/*.schema.json.

Each object is a section, its keys are entries of a list: the key, its values with their range, and the sentence that the
schema has for it. An object within an object is listed below its own key.
"""
import json
import re
import sys
from html import escape
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1]
PAGES = {
    "task": ("Task files", "What `shigusa reach FILE` reads, and the C interface, the engine for browsers and the studio."),
    "result": ("Results", "What is in a result's `summary.json`."),
    "plan": ("Plans of data sets", "What `shigusa dataset PLAN` reads: how many tasks, and a task in which any value may be a "
             "[draw](#draw). Its `task` has the keys of [task files](task.md). [Data sets](../data.md) says what plans are for."),
}


def number(value):
    """A bound as a person writes it."""
    return f"{value:g}" if isinstance(value, float) else f"{value}"


def bounds(schema, low, high):
    """The words for a range, which may be open at an end."""
    least, most = schema.get(low), schema.get(high)
    if least is not None and most is not None:
        return f"{number(least)}" if least == most else f"{number(least)} to {number(most)}"
    if least is not None:
        return f"{number(least)} or more"
    return f"at most {number(most)}" if most is not None else ""


def link(reference, shared):
    """A link to where a schema says a value is told; parts that are `shared` with task files are told there."""
    page, _, fragment = reference.partition("#")
    page = page.removesuffix(".schema.json")
    words = fragment.split("/")
    name = words[-1] or page
    if "$defs" in words:
        place = ".".join(word for word in words[words.index("$defs") + 1 :] if word != "properties")
        return f'<a href="{"task.html" if place in shared else ""}#{place}">{name}</a>'
    return f'<a href="{page}.html#{page}{"." + name if fragment else ""}">{name}</a>'


def values(schema, shared=()):
    """What may stand for a key, as HTML."""
    if "$ref" in schema:
        return link(schema["$ref"], shared)
    if "const" in schema:
        return f"<code>{escape(json.dumps(schema['const']))}</code>"
    if "enum" in schema:
        return ", ".join(f"<code>{escape(json.dumps(word))}</code>" for word in schema["enum"])
    if "anyOf" in schema:
        return " or ".join(dict.fromkeys(values(choice, shared) for choice in schema["anyOf"]))
    kind = schema.get("type", "")
    if isinstance(kind, list):
        return " or ".join(values({**schema, "type": one}, shared) for one in kind)
    if kind == "array":
        count = bounds(schema, "minItems", "maxItems")
        items = values(schema.get("items", {}), shared)
        return "list" + (f" of {count}" if count else "") + (f": {items}" if items else "")
    if kind in ("number", "integer"):
        span = bounds(schema, "minimum", "maximum")
        return {"number": "number", "integer": "whole number"}[kind] + (f", {span}" if span else "")
    if kind == "object" and isinstance(schema.get("additionalProperties"), dict):
        return f"object of any names, each with {values(schema['additionalProperties'], shared)}"
    return {"boolean": "<code>true</code> or <code>false</code>", "string": "text", "null": "<code>null</code>"}.get(kind, kind)


def within(schema):
    """The object with keys that a schema holds without naming it: itself, the items of a list, or one of several."""
    if "properties" in schema:
        return schema
    for inner in [schema.get("items"), schema.get("additionalProperties"), *schema.get("anyOf", [])]:
        if isinstance(inner, dict) and (found := within(inner)):
            return found
    return None


def sentence(text):
    """A schema's description as HTML, with its code between backquotes."""
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", escape(text, quote=False))


def entries(schema, path, shared):
    """The keys of an object as entries of a list."""
    lines = ['<dl class="members">']
    for key, inner in schema["properties"].items():
        required = ", <strong>required</strong>" if key in schema.get("required", []) else ""
        shown = f" <span>{values(inner, shared)}{required}</span>"
        lines.append(f'<dt id="{path}.{key}"><code><b>{escape(key)}</b></code>{shown}</dt>')
        nested = within(inner)
        below = entries(nested, f"{path}.{key}", shared) if nested else ""
        lines.append(f"<dd>{sentence(inner.get('description', ''))}{below}</dd>")
    return "\n".join([*lines, "</dl>"])


def section(title, name, schema, shared):
    lines = [f"## {title} {{ #{name} }}", ""]
    if "description" in schema:
        lines += [f"<p>{sentence(schema['description'])}</p>", ""]
    choices = [choice for choice in schema.get("anyOf", []) if "properties" in choice]
    if len(choices) > 1:
        lines += ["<p>An object with one of these keys, and what goes along with it.</p>", ""]
        schema = {"type": "object", "properties": {key: inner for choice in choices for key, inner in choice["properties"].items()}}
    nested = within(schema)
    if schema.get("type") != "object" or not nested:
        lines += [f"<p>{values({key: value for key, value in schema.items() if key != 'description'}, shared)}</p>", ""]
    if nested:
        lines += [entries(nested, name, shared), ""]
    return "\n".join(lines)


def read(name):
    return json.loads((DOCS / f"{name}.schema.json").read_text(encoding="utf-8"))


def page(name):
    title, about = PAGES[name]
    schema = read(name)
    # a plan's parts are those of a task, with draws in them
    shared = [*read("task")["$defs"], "task"] if name == "plan" else []
    lead = [f"# {title}", "", about, "", f"The same as a [JSON schema](../{name}.schema.json), for editors and programs.", ""]
    sections = [section(f"The {name}", name, schema, shared)]
    sections += [section(part, part, inner, shared) for part, inner in schema.get("$defs", {}).items() if part not in shared]
    return "\n".join(lead) + "\n" + "\n".join(sections)


def main():
    for name in PAGES:
        Path(sys.argv[1], f"{name}.md").write_text(page(name), encoding="utf-8")


if __name__ == "__main__":
    main()
