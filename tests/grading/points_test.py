"""./tumble grade with a stand-in judge: points by step, and what must not reach a student."""

import json
import unittest

from class_kit import ALL, ClassTestCase


class Points(ClassTestCase):
    def test_a_step_has_its_points_where_all_cases_pass_under_both_seeds(self) -> None:
        self.hand_in("all", ALL)
        self.hand_in("some", "// passes 1.1 1.5\n// passes_first_seed 1.2\n")
        self.hand_in("none", "// passes 0.0\n")
        done = self.grade()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([self.results(name)["score"] for name in ("all", "some", "none")],
                         [115, 40, 0])
        tests = {test["number"]: test for test in self.results("some")["tests"]}
        self.assertEqual([tests["1.2"]["score"], tests["1.2"]["max_score"]], [0, 20])
        self.assertEqual(tests["1.1"]["status"], "passed")
        self.assertIn("The cross product as a matrix", tests["1.1"]["name"])
        self.assertIn("(bonus)", tests["1.6"]["name"])

    def test_a_step_on_a_failing_one_is_blocked_and_a_wrong_one_is_not(self) -> None:
        self.hand_in("one", "// passes 1.2\n")
        self.hand_in("two", "// passes 1.1\n")
        self.grade()
        output = {student: {test["number"]: test["output"] for test in
                            self.results(student)["tests"]} for student in ("one", "two")}
        self.assertIn("blocked by step 1.1", output["one"]["1.4"])
        self.assertNotIn("blocked", output["two"]["1.4"])
        self.assertNotIn("blocked", output["one"]["1.5"])

    def test_undefined_behaviour_costs_what_the_table_says(self) -> None:
        self.hand_in("ub", ALL + "// says sanitizer\n")
        self.grade()
        self.assertEqual(self.results("ub")["score"], 105)
        self.assertIn("signed integer overflow, spin.cpp line 7", self.results("ub")["output"])

    def test_no_points_below_zero(self) -> None:
        self.hand_in("ub", "// passes 0.0\n// says sanitizer\n")
        self.grade()
        self.assertEqual(self.results("ub")["score"], 0)

    def test_missing_unreadable_and_uncompilable_files_say_so(self) -> None:
        (self.folder / "empty").mkdir()
        self.hand_in("broken", "// says compile error\n")
        (self.folder / "binary.zip").write_bytes(b"PK\3\4 nonsense")
        done = self.grade()
        self.assertEqual(done.returncode, 0, done.stderr)
        for student, words in (("empty", "not handed in: there is no spin.cpp in the submission"),
                               ("broken", "does not compile"), ("binary", "cannot be read")):
            self.assertEqual(self.results(student)["score"], 0)
            self.assertIn(words, self.results(student)["output"])
        self.assertIn("&lt;script&gt;alert(1)&lt;/script&gt;", self.page("broken"))
        self.assertNotIn("<script>", self.page("broken"))
        self.assertNotIn("\x1b", self.page("broken") + json.dumps(self.results("broken")))


class Secrets(ClassTestCase):
    def test_nothing_of_seeds_secret_or_hidden_inputs_reaches_a_student(self) -> None:
        self.hand_in("wrong", "// passes 1.1\n")
        self.hand_in("crash", "// passes 1.1\n// says crash\n")
        self.grade()
        seeds = (self.kit.root / "judged.log").read_text().split("[")[1].split("]")[0].split(", ")
        self.assertEqual(len(seeds), 2)
        for student in ("wrong", "crash"):
            given = self.page(student) + json.dumps(self.results(student))
            for word in (*seeds, "0123456789abcdef", "3.25", "secret input", "hidden input"):
                self.assertNotIn(word, given)
            self.assertEqual(sorted(path.name for path in (self.out / student).iterdir()),
                             ["index.html", "results.json"])
        self.assertIn("SIGSEGV", self.page("crash"))
        self.assertIn("the sign of &lt;omega&gt;", self.page("wrong"))

    def test_without_a_secret_a_random_one_is_kept_and_used_again(self) -> None:
        self.hand_in("all", ALL)
        grade = ("grade", str(self.folder), "--out", str(self.out))
        self.assertIn("No secret was given", self.kit.tumble(*grade).stdout)
        secret = self.out / "secret"
        self.assertEqual(secret.stat().st_mode & 0o777, 0o600)
        before = secret.read_bytes()
        self.kit.tumble(*grade)
        self.assertEqual(secret.read_bytes(), before)
        lines = (self.kit.root / "judged.log").read_text().splitlines()
        self.assertEqual(lines[:3], lines[3:])

    def test_another_secret_gives_other_seeds(self) -> None:
        self.hand_in("all", ALL)
        self.grade()
        self.kit.write("secret", "f123456789abcdef0123456789abcdef")
        self.grade()
        lines = (self.kit.root / "judged.log").read_text().splitlines()
        self.assertNotEqual(lines[0], lines[3])

    def test_the_environment_can_name_the_secret(self) -> None:
        self.hand_in("all", ALL)
        done = self.kit.tumble("grade", str(self.folder), "--out", str(self.out), settings={
            "TUMBLE_SECRET": str(self.kit.root / "secret")})
        self.assertEqual((done.returncode, (self.out / "secret").exists()), (0, False))

    def test_a_bad_secret_gets_one_line(self) -> None:
        self.hand_in("all", ALL)
        self.kit.write("secret", "short")
        self.assert_one_line(self.grade(), 2)
        (self.kit.root / "secret").unlink()
        self.assert_one_line(self.grade(), 2)


if __name__ == "__main__":
    unittest.main()
