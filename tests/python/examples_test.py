# SPDX-License-Identifier: Apache-2.0
"""Runs each script of docs/python in an empty folder. Compares its output with its last lines, and checks its picture."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(__file__).parents[2] / "docs/python"
EXAMPLES = sorted(FOLDER.glob("*.py"))


def stated(script: pathlib.Path) -> str:
    """The output that the comment at the end states."""
    _, _, lines = script.read_text().partition("\n# Output:\n")
    return "".join(line[4:] + "\n" if len(line) > 1 else "\n" for line in lines.splitlines())


class Examples(unittest.TestCase):
    def test_each_is_on_the_page(self) -> None:
        self.assertEqual(len(EXAMPLES), 12)
        page = (FOLDER / "README.md").read_text()
        for script in EXAMPLES:
            self.assertIn(f"]({script.name})", page)

    def test_each(self) -> None:
        import matplotlib.image

        environment = dict(os.environ, MPLBACKEND="Agg")
        environment["PATH"] = str(pathlib.Path(os.environ["JOUNCE"]).parent) + os.pathsep + environment["PATH"]
        for script in EXAMPLES:
            with self.subTest(script.name), tempfile.TemporaryDirectory() as folder:
                run = subprocess.run([sys.executable, script], cwd=folder, env=environment, text=True,
                                     capture_output=True, timeout=100)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertTrue(stated(script), "states no output")
                self.assertEqual([line.rstrip() for line in run.stdout.splitlines()],
                                 [line.rstrip() for line in stated(script).splitlines()])
                picture = matplotlib.image.imread(pathlib.Path(folder) / (script.stem + ".png"))
                self.assertGreater(picture[..., :3].std(), 0.02)  # curves, not an empty page


if __name__ == "__main__":
    unittest.main()
