"""How mistakes are put together, and which names each gets back."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "common" / "cmake"))

from batch import batch, renamed  # noqa: E402

CONTRACT = """#pragma once

#include <vector>

namespace lab::spin {
double spin(double x);
}
"""

ANSWER = """#include "spin.hpp"

#include <cmath>
#include <vector>

namespace lab::spin {
double spin(double x) { return std::sin(x); }
}
"""


class Batch(unittest.TestCase):
    def setUp(self) -> None:
        self.text = batch(CONTRACT, "spin.hpp", {"first": ANSWER, "second": ANSWER})

    def test_all_includes_come_first_and_once(self) -> None:
        lines = [line for line in self.text.splitlines() if line.startswith("#include")]
        self.assertEqual(lines, ["#include <vector>", "#include <cmath>"])
        self.assertLess(self.text.index("#include <cmath>"), self.text.index("namespace"))
        self.assertNotIn("#pragma", self.text)

    def test_each_mistake_has_a_contract_of_its_own(self) -> None:
        for mistake in ("first", "second"):
            self.assertEqual(self.text.count(f"namespace mistake_{mistake} {{"), 1)
        self.assertEqual(self.text.count("double spin(double x);"), 2)

    def test_an_error_is_told_with_the_line_of_the_answer(self) -> None:
        after = self.text.split('#line 1 "first.cpp"\n', 1)[1].splitlines()
        self.assertEqual(after[6], ANSWER.splitlines()[6])


class Renamed(unittest.TestCase):
    REAL = {"lab::spin(double)": "_Zspin", "lab::turn(lab::Body)": "_Zturn"}

    def test_what_is_defined_and_what_is_called_get_their_real_names(self) -> None:
        found = [("T", "_Zm_spin", "mistake_first::lab::spin(double)"),
                 ("U", "_Zm_turn", "mistake_first::lab::turn(mistake_first::lab::Body)")]
        self.assertEqual(renamed("first", self.REAL, found),
                         {"_Zm_spin": "_Zspin", "_Zm_turn": "_Zturn"})

    def test_other_mistakes_and_other_symbols_keep_theirs(self) -> None:
        found = [("T", "_Zo", "mistake_first_of_all::lab::spin(double)"),
                 ("T", "_Zh", "mistake_first::lab::helper(double)"),
                 ("W", "_Zi", "mistake_first::lab::spin(double)"),
                 ("U", "_Zs", "sin")]
        self.assertEqual(renamed("first", self.REAL, found), {})

    def test_a_call_of_what_nobody_defines_is_refused(self) -> None:
        found = [("U", "_Zm", "mistake_first::lab::missing(double)")]
        with self.assertRaisesRegex(SystemExit, "first calls lab::missing"):
            renamed("first", self.REAL, found)


if __name__ == "__main__":
    unittest.main()
