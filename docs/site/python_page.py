# SPDX-License-Identifier: MIT
"""python_page.py TARGET: writes the reference of the Python package from its sources, bindings/python/shigusa, without
loading it: signature and docstring of each public name. Fails on a public name without a docstring."""
import ast
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2] / "bindings/python/shigusa"


class Reference:
    def __init__(self):
        self.parts = ["# Python reference\n\n[In Python](../python.md) shows how it is used.\n"]
        self.missing = []

    def names(self, owner, tree, wanted, level=2):
        """The wanted classes and functions of a module, or methods of a class."""
        for node in tree.body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and wanted(node.name):
                self.entry(owner, node, level)

    def entry(self, owner, node, level):
        about = ast.get_docstring(node)
        if about is None:
            self.missing.append(f"{owner}.{node.name}")
        shown = class_lines(node) if isinstance(node, ast.ClassDef) else function_line(node)
        self.parts.append(f"{'#' * level} {owner}.{node.name}\n\n```python\n{shown}\n```\n\n{about}\n")
        if isinstance(node, ast.ClassDef):
            made = constructor(node)
            self.parts += [] if made is None else [ast.get_docstring(made) + "\n"]
            self.names(node.name, node, lambda own: not own.startswith("_"), level + 1)


def constructor(node):
    """The constructor that users call, which has a docstring."""
    found = [own for own in node.body if getattr(own, "name", "") == "__init__" and ast.get_docstring(own)]
    return found[0] if found else None


def class_lines(node):
    made = constructor(node)
    fields = ["    " + ast.unparse(own) for own in node.body if isinstance(own, ast.AnnAssign)]
    bases = ", ".join(ast.unparse(base) for base in node.bases)
    first = f"class {node.name}" + (f"({bases})" if bases else "")
    return "\n".join([first, *fields] if made is None else [f"{node.name}({arguments(made)})"])


def function_line(node):
    kinds = {ast.unparse(line) for line in node.decorator_list}
    if "property" in kinds:
        return f"{node.name}: {ast.unparse(node.returns)}"
    return f"{node.name}({arguments(node)}) -> {ast.unparse(node.returns)}"


def arguments(node):
    told = [own for own in node.args.args if own.arg not in ("self", "cls")]
    return ast.unparse(ast.arguments(**{**dict(ast.iter_fields(node.args)), "args": told}))


def main():
    trees = {path.stem: ast.parse(path.read_text(encoding="utf-8")) for path in sorted(PACKAGE.glob("*.py"))}
    top = trees["__init__"]
    public = next(ast.literal_eval(line.value) for line in top.body
                  if isinstance(line, ast.Assign) and ast.unparse(line.targets[0]) == "__all__")
    taken = [one.name for line in top.body if isinstance(line, ast.ImportFrom) for one in line.names]
    reference = Reference()
    reference.parts.append(ast.get_docstring(top) + "\n")
    reference.names("shigusa", top, lambda name: name in public)
    reference.names("shigusa", trees["_library"], lambda name: name in public and name in taken)
    for module, tree in trees.items():
        if not module.startswith("_"):
            reference.parts.append(f"## shigusa.{module}\n\n{ast.get_docstring(tree)}\n")
            reference.names(f"shigusa.{module}", tree, lambda name: not name.startswith("_"), 3)
    if reference.missing:
        sys.exit("python_page: no docstring on " + ", ".join(reference.missing))
    Path(sys.argv[1]).write_text("\n".join(reference.parts), encoding="utf-8")


main()
