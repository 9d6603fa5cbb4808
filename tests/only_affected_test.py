"""What is compiled for a mistake: all that it can reach, and not the rest of the answer."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "common" / "cmake"))

from only_affected import only_affected, parts  # noqa: E402

RIGHT = """#include "lab.hpp"

namespace lab::spin {
namespace {

constexpr double half = 0.5;

/// Named by turned alone: f(
double helper(double x) { return x * half; }

double other_helper(double x) {
  return helper(x) + 1.0;
}

template <int i>
double third_helper(double x) {
  return x + i;
}

}  // namespace

double turned(double x) {
  if (x > 0.0) {
    return helper(x);
  }
  return 0.0;
}

double spin(double x) { return turned(x) + 2.0; }

[[nodiscard]] double counted(double x) { return other_helper(x) + third_helper<2>(x); }

}  // namespace lab::spin
"""


def names(text: str) -> set[str]:
    return {part.name for part in parts(text) if part.name}


class OnlyAffected(unittest.TestCase):
    def after(self, find: str, replace: str) -> set[str]:
        self.assertIn(find, RIGHT)
        return names(only_affected(RIGHT, RIGHT.replace(find, replace)))

    def test_all_functions_are_found(self) -> None:
        self.assertEqual(names(RIGHT), {"helper", "other_helper", "third_helper", "turned", "spin",
                                        "counted"})

    def test_the_edited_function_and_what_it_needs_is_kept(self) -> None:
        self.assertEqual(self.after("return 0.0;", "return 1.0;"), {"turned", "helper"})
        self.assertEqual(self.after("x + i", "x - i"),
                         {"third_helper", "counted", "other_helper", "helper"})

    def test_an_edited_helper_keeps_all_that_rests_on_it(self) -> None:
        self.assertEqual(self.after("x * half", "x / half"),
                         {"helper", "other_helper", "third_helper", "turned", "counted"})

    def test_what_is_compiled_into_its_callers_keeps_them(self) -> None:
        right = RIGHT.replace("double turned(", "inline double turned(")
        kept = only_affected(right, right.replace("return 0.0;", "return 1.0;"))
        self.assertEqual(names(kept), {"turned", "spin", "helper"})

    def test_an_edit_between_functions_keeps_the_file(self) -> None:
        wrong = RIGHT.replace("= 0.5", "= 0.25")
        self.assertEqual(only_affected(RIGHT, wrong), wrong)

    def test_a_function_that_is_left_out_leaves_no_comment(self) -> None:
        kept = only_affected(RIGHT, RIGHT.replace("+ 2.0", "- 2.0"))
        self.assertEqual(names(kept), {"spin"})
        self.assertNotIn("Named by turned", kept)
        self.assertIn("constexpr double half", kept)

    def test_the_references_are_read_whole(self) -> None:
        """Each function of a contract is found in its reference, and nothing is lost."""
        references = sorted(ROOT.glob("solutions/[1-9]_*/mistakes.cmake"))
        self.assertTrue(references)
        for bank in references:
            lab = bank.parent.name
            name = lab.split("_", 1)[1]
            text = (bank.parent / f"{name}.cpp").read_text(encoding="utf-8")
            self.assertEqual("".join(part.text for part in parts(text)), text)
            stub = (ROOT / "labs" / lab / f"{name}.cpp").read_text(encoding="utf-8")
            self.assertLessEqual(names(stub), names(text), lab)


if __name__ == "__main__":
    unittest.main()
