"""The handouts' sketches: each has a script that draws it, and stands in its handout with words."""

import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
STYLE = Path("labs/sketch_style.gp")
PICTURE = re.compile(r"!\[([^\]]*)\]\(([^)\s]+)\)")
LEAST_WORDS = 3
MOST_LINES = 60


def pictures(handout: Path) -> list[tuple[str, str]]:
    """The alternative text and the target of every picture."""
    return PICTURE.findall(handout.read_text(encoding="utf-8"))


class Sketches(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.scripts = sorted(ROOT.glob("labs/*/sketches/*.gp"))
        cls.drawings = sorted(ROOT.glob("labs/*/sketches/*.svg"))
        cls.handouts = sorted(ROOT.glob("labs/*/README.md"))

    def test_there_are_some(self) -> None:
        self.assertGreater(len(self.scripts), 10)
        self.assertGreater(len(self.handouts), 5)

    def test_each_script_has_its_drawing_and_each_drawing_its_script(self) -> None:
        self.assertEqual([path.with_suffix("") for path in self.scripts],
                         [path.with_suffix("") for path in self.drawings])

    def test_nothing_else_lies_beside_them(self) -> None:
        for path in ROOT.glob("labs/*/sketches/*"):
            self.assertIn(path.suffix, (".gp", ".svg"), path)

    def test_each_is_shown_once_in_its_handout(self) -> None:
        for drawing in self.drawings:
            shown = [target for _, target in pictures(drawing.parents[1] / "README.md")]
            self.assertEqual(shown.count(f"sketches/{drawing.name}"), 1, drawing)

    def test_every_picture_of_a_handout_exists_and_has_alternative_text(self) -> None:
        for handout in self.handouts:
            self.assertEqual(handout.read_text(encoding="utf-8").count("!["),
                             len(pictures(handout)), handout)
            for words, target in pictures(handout):
                with self.subTest(handout=handout, picture=target):
                    self.assertTrue((handout.parent / target).is_file())
                    self.assertGreaterEqual(len(words.split()), LEAST_WORDS)

    def test_a_script_is_short(self) -> None:
        for script in self.scripts:
            lines = script.read_text(encoding="utf-8").splitlines()
            self.assertLessEqual(len(lines), MOST_LINES, script)
            self.assertLessEqual(max(map(len, lines)), 100, script)

    @unittest.skipUnless(shutil.which("gnuplot"), "gnuplot is not installed")
    def test_each_script_draws_its_drawing_without_a_word(self) -> None:
        """In a folder of its own, since versions of gnuplot draw with other bytes."""
        with tempfile.TemporaryDirectory(prefix="tumble sketches ") as name:
            folder = Path(name)
            for path in (STYLE, *(script.relative_to(ROOT) for script in self.scripts)):
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / path, folder / path)
            for script in (path.relative_to(ROOT) for path in self.scripts):
                with self.subTest(script=script):
                    done = subprocess.run(["gnuplot", script], cwd=folder, capture_output=True,
                                          text=True, timeout=60)
                    self.assertEqual((done.stdout, done.stderr, done.returncode), ("", "", 0))
                    drawing = (folder / script).with_suffix(".svg")
                    self.assertTrue(drawing.is_file())
                    self.assertTrue(drawing.read_text(encoding="utf-8").rstrip().endswith("</svg>"))
            drawn = {path.relative_to(folder) for path in folder.rglob("*.svg")}
            self.assertEqual(drawn, {path.relative_to(ROOT) for path in self.drawings})


if __name__ == "__main__":
    unittest.main()
