"""./tumble demo: a lab's film is drawn as soon as it is built, the charts last and in short."""

import unittest

from fake_kit import LAB, KitTestCase

OTHER = "2_other"

# A program notes its call, and what had been built when it began.
_PROGRAM = """
echo "$*" >> "$FAKE/calls/program"
cp "$FAKE/calls/ninja" "$FAKE/calls/built before {name}"
mkdir -p "$2"
echo "frame 1 of 2" >&2
{body}
touch "$2/frame_0000.png" "$2/chart.csv"
"""

# The build of the second lab ends when the first lab's film is on the page, and fails without it.
_NINJA = """
echo "$*" >> "$FAKE/calls/ninja"
case "$*" in
  *other_reference_scene*)
    for turn in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
      [ -f out/1_spin/reference/film-command.txt ] && [ -f out/index.html ] && exit 0
      sleep 0.2
    done
    echo "no film yet"; exit 1 ;;
  *broken*) echo "error: no such thing"; exit 1 ;;
esac
"""


class Demo(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        self.kit.write(f"labs/{OTHER}/README.md", "# Lab 2: other\n")
        self.kit.write(f"solutions/{OTHER}/other.cpp", "")
        self.kit.add_tool("ninja", _NINJA)
        self.names = [f"{lab}_reference_{kind}" for kind in ("scene", "chart")
                      for lab in ("spin", "other")]
        self.kit.write("fake/targets", "".join(f"{name}: phony\n" for name in self.names))
        for name in self.names:
            self.add_program(name)

    def add_program(self, name: str, body: str = "") -> None:
        folder = LAB if name.startswith("spin") else OTHER
        self.kit.add_program(self.kit.root / "build" / "release" / "labs" / folder / name,
                             _PROGRAM.format(name=name, body=body))

    def built_before(self, name: str) -> str:
        return "\n".join(self.kit.calls(f"built before {name}"))

    def test_the_first_film_is_on_the_page_before_the_second_is_built(self) -> None:
        done = self.kit.tumble("demo")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(f"Open {self.kit.root / 'out' / 'index.html'} now", done.stdout)
        self.assertNotIn("spin_reference_chart", self.built_before("spin_reference_scene"))

    def test_charts_come_last_and_short_but_their_command_makes_the_full_one(self) -> None:
        self.assertEqual(self.kit.tumble("demo").returncode, 0)
        calls = self.kit.calls("program")
        self.assertEqual([" --short" in call for call in calls], [False, False, True, True])
        for name in self.names:
            self.assertIn(f"{name}", self.built_before("spin_reference_chart"))
        page = (self.kit.root / "out" / "index.html").read_text(encoding="utf-8")
        self.assertIn("<code>./tumble chart 1 --solution</code>", page)
        self.assertNotIn("--short", page)

    def test_a_picture_that_fails_stops_no_other(self) -> None:
        self.add_program("spin_reference_scene", 'echo "error: no GL" >&2\nexit 1\n')
        self.kit.write(f"out/{LAB}/reference/film-command.txt", "old\n")
        self.kit.write("out/index.html", "old\n")
        done = self.kit.tumble("demo")
        self.assertEqual(done.returncode, 1)
        self.assertIn("Not drawn: spin_reference_scene.", done.stdout)
        self.assertIn("error: no GL", done.stderr)
        self.assertEqual(len(self.kit.calls("program")), 4)

    def test_when_a_build_fails_what_is_built_is_still_drawn(self) -> None:
        self.kit.add_tool("ninja", _NINJA.replace("*broken*", "*_chart*"))
        done = self.kit.tumble("demo")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the build of build/release failed", done.stderr)
        self.assertIn("Lab 2: other: film", done.stdout)

    def test_the_counter_of_a_film_moves_where_no_terminal_is(self) -> None:
        self.add_program("other_reference_scene", "sleep 6.5\n")
        done = self.kit.tumble("demo")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"lab 2's film: frame 1 of 2 \(\d s\)")


if __name__ == "__main__":
    unittest.main()
