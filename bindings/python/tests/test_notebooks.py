# SPDX-License-Identifier: MIT
"""The notebooks of the folder SHIGUSA_NOTEBOOKS run to their ends. Their plots and SVG files are kept in SHIGUSA_PICTURES."""
import base64
import os
import pathlib
import shutil
import tempfile
import unittest

import nbclient
import nbformat

NOTEBOOKS = sorted(pathlib.Path(os.environ["SHIGUSA_NOTEBOOKS"]).resolve().glob("*.ipynb"))
PICTURES = pathlib.Path(os.environ["SHIGUSA_PICTURES"])


class Notebooks(unittest.TestCase):
    def test_there_are_some(self):
        self.assertGreater(len(NOTEBOOKS), 2)

    def test_run_to_their_ends_and_show_figures(self):
        for path in NOTEBOOKS:
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder:
                book = nbformat.read(path, as_version=4)
                self.assertFalse([cell for cell in book.cells if cell.get("outputs")], "written with outputs")
                nbclient.NotebookClient(book, timeout=60, resources={"metadata": {"path": folder}}).execute()
                shown = [output.get("data", {}) for cell in book.cells for output in cell.get("outputs", [])]
                plots = [data["image/png"] for data in shown if "image/png" in data]
                self.assertTrue(plots, "no plot")
                self.assertTrue(any("<iframe" in data.get("text/html", "") for data in shown), "no moving figure")
                for number, plot in enumerate(plots, 1):
                    (PICTURES / f"{path.stem}-{number}.png").write_bytes(base64.b64decode(plot))
                for drawn in pathlib.Path(folder).glob("*.svg"):
                    shutil.copy(drawn, PICTURES)


if __name__ == "__main__":
    unittest.main()
