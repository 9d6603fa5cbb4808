"""./tumble hint: one more each time; and every step of every handout has its three hints."""

import unittest

from fake_kit import LAB, ROOT, KitTestCase
from tumble import hints, labs

HINTS = """# Hints

## 1.1 The cross product as a matrix
1. **Idea.** Write it by components.
   Each is a difference.
2. **Formula.** `w.y * u.z - w.z * u.y`
3. **Line.** The first row:
   ```cpp
   m.row(0) << 0.0, -w.z(), w.y();
   ```

## 1.2 Points of the body
1. **Idea.** Turn, then shift.
2. **Formula.** x + R p
"""


class Hints(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        self.kit.write(f"labs/{LAB}/hints.md", HINTS)

    def told(self, *arguments: str) -> str:
        done = self.kit.tumble("hint", "1.1", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_each_call_reveals_one_more_and_the_last_one_stays(self) -> None:
        first, second, third, fourth = (self.told() for _ in range(4))
        self.assertIn("Idea. Write it by components.\n   Each is a difference.\n", first)
        self.assertNotIn("Formula.", first)
        self.assertIn("1 of 3", first)
        self.assertIn("Idea.", second)
        self.assertIn("Formula. `w.y", second)
        self.assertIn("2 of 3", second)
        self.assertIn("m.row(0) << 0.0", third)
        self.assertIn("3 of 3", third)
        self.assertEqual(third, fourth)

    def test_again_reveals_nothing_new_and_reset_forgets(self) -> None:
        self.assertIn("0 of 3", self.told("--again"))
        first = self.told()
        self.assertEqual(self.told("--again"), first)
        self.told()
        self.told("--reset")
        self.assertEqual(self.told(), first)

    def test_a_broken_memory_counts_as_none(self) -> None:
        for memory in ("{", "[]", '{"1.1": "x"}', '{"1.1": -5}'):
            self.kit.write("build/hints.json", memory)
            self.assertIn("1 of 3", self.told())

    def test_where_nothing_can_be_noted_all_hints_are_shown(self) -> None:
        self.kit.write("build", "a file, which stands for a folder that cannot be written")
        told = self.told()
        for word in ("Idea.", "Formula.", "Line.", "build/ cannot be written"):
            self.assertIn(word, told)
        self.assert_one_line(self.kit.tumble("hint", "1.1", "--reset"), 1)

    def test_a_step_without_hints_is_bad_usage(self) -> None:
        self.assert_one_line(self.kit.tumble("hint", "1.6"), 2)

    def test_flaws_are_found(self) -> None:
        found = "\n".join(hints.flaws(labs.find_lab(self.kit.root, "1")))
        self.assertIn("no section for step 1.6", found)
        self.assertIn("step 1.2 has ('Idea', 'Formula')", found)
        self.assertNotIn("step 1.1", found)


class HintsOfTheKit(unittest.TestCase):
    def test_every_step_of_every_handout_has_an_idea_a_formula_and_a_line(self) -> None:
        for lab in labs.find_labs(ROOT):
            if lab.handout.exists():
                self.assertEqual(hints.flaws(lab), [])


if __name__ == "__main__":
    unittest.main()
