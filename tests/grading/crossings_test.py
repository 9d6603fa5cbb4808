"""What crosses to a worker is read off a contract: all its functions, and nothing else."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "solutions" / "grading"))

from crossings import Function, namespace_and_functions, proxy  # noqa: E402

CONTRACT = """#pragma once
#include <vector>

/// A lab; its functions are below.
namespace lab::spin {

using common::Vec3;
inline constexpr int most = 3;
enum class Rule { one, other };

/// A struct with a function: length();
struct Step {
  double dt = 0.1;
  [[nodiscard]] double length() const { return dt; }
};

/// Twice, e.g. double twice(double x);
Vec3 turned(const Vec3& axis, const std::vector<std::pair<int, Step>>& steps,
            double dt = twice(1.0, {2.0, 3.0}));
std::vector<double> times(Step by_value);

}  // namespace lab::spin
"""


class Crossings(unittest.TestCase):
    def test_functions_are_found_with_their_parameters(self) -> None:
        namespace, functions = namespace_and_functions(CONTRACT)
        self.assertEqual(namespace, "lab::spin")
        self.assertEqual(functions, [
            Function("Vec3", "turned", ("const Vec3& axis",
                                        "const std::vector<std::pair<int, Step>>& steps",
                                        "double dt")),
            Function("std::vector<double>", "times", ("Step by_value",))])

    def test_each_is_a_call_of_the_worker(self) -> None:
        text = proxy(*namespace_and_functions(CONTRACT))
        self.assertIn("  return remote<&lab::spin::turned>(axis, steps, dt);\n", text)
        self.assertIn("  return remote<&lab::spin::times>(by_value);\n", text)

    def test_every_function_that_a_stub_names_crosses(self) -> None:
        contracts = sorted(ROOT.glob("labs/[1-9]_*/"))
        self.assertTrue(contracts)
        for folder in contracts:
            name = folder.name.split("_", 1)[1]
            _, functions = namespace_and_functions((folder / f"{name}.hpp").read_text("utf-8"))
            stub = (folder / f"{name}.cpp").read_text("utf-8")
            for function in functions:
                self.assertIn(f" {function.name}(", stub)
            self.assertEqual(len(functions), stub.count("throw common::NotImplemented("), name)

    def test_what_is_no_contract_is_refused(self) -> None:
        for text in ("int x;", "namespace lab::spin {\nusing common::Vec3;\n}\n"):
            with self.assertRaises(SystemExit):
                namespace_and_functions(text)


if __name__ == "__main__":
    unittest.main()
