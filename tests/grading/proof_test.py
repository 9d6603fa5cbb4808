"""./tumble grade proves itself first; what it writes is whole, safe and the same each time."""

import csv
import unittest

from class_kit import ALL, ClassTestCase, snapshot


class Proof(ClassTestCase):
    def fails(self, words: str) -> None:
        self.hand_in("all", ALL)
        done = self.grade()
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertRegex(done.stderr, r"\Atumble: the grader cannot be trusted[^\n]*" + words)
        self.assertFalse((self.out / "all").exists())
        self.assertFalse((self.out / "class.csv").exists())

    def test_a_reference_that_fails_stops_the_batch(self) -> None:
        self.kit.write("solutions/1_spin/spin.cpp", "// passes 1.1 1.2 1.3 1.4 1.6\n")
        self.fails("the reference has 85 points")

    def test_a_reference_without_the_bonus_stops_the_batch(self) -> None:
        self.kit.write("solutions/1_spin/spin.cpp", "// passes 1.1 1.2 1.3 1.4 1.5\n")
        self.fails("the reference has 100 points")

    def test_a_reference_with_undefined_behaviour_stops_the_batch(self) -> None:
        self.kit.write("solutions/1_spin/spin.cpp", ALL + "// says sanitizer\n")
        self.fails("the reference has 105 points")

    def test_a_stub_that_was_edited_stops_the_batch(self) -> None:
        self.kit.write("labs/1_spin/spin.cpp", "// passes 1.1\n")
        self.fails("the untouched stub has 10 points")

    def test_a_judge_that_fails_stops_the_batch(self) -> None:
        self.kit.write("solutions/1_spin/spin.cpp", ALL + "// says raise\n")
        self.fails("the reference has 0 points")

    def test_no_sandbox_no_grading(self) -> None:
        self.kit.write("no_sandbox", "")
        self.hand_in("all", ALL)
        self.assert_one_line(self.grade(), 3)
        self.assertEqual(self.grade("--no-sandbox").returncode, 0)
        self.assertFalse(self.results("all")["extra_data"]["labs"][0]["sandboxed"])
        self.assertIn("without the sandbox", self.page("all"))
        self.assertIn("not sandboxed", (self.out / "class.csv").read_text())

    def test_a_judge_that_disagrees_with_the_tests_grades_nobody(self) -> None:
        for says in ("raise", "unknown case", "twice"):
            self.hand_in(says.replace(" ", ""), ALL + f"// says {says}\n")
        self.hand_in("all", ALL)
        done = self.grade()
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"failed on 3 of them: raise, twice, unknowncase")
        self.assertEqual(self.results("all")["score"], 115)
        for student in ("raise", "twice", "unknowncase"):
            self.assertEqual(self.results(student)["score"], 0)
            self.assertIn("the grader failed on this file; this is not your mistake",
                          self.page(student))
        self.assertIn("the judge fell over", (self.out / "class.csv").read_text())

    def test_the_proof_alone_can_be_run_and_is_kept(self) -> None:
        check = ("grade", "--check", "--out", str(self.out), "--secret",
                 str(self.kit.root / "secret"))
        self.assertEqual(self.kit.tumble(*check).returncode, 0)
        self.assertEqual(self.judged(), 2)
        self.hand_in("all", ALL)
        self.assertEqual(self.grade("--resume").returncode, 0)
        self.assertEqual(self.judged(), 3)


class Files(ClassTestCase):
    def test_the_same_class_gives_the_same_bytes(self) -> None:
        for i in range(12):
            self.hand_in(f"s{i:02}", f"// passes 1.{1 + i % 6} 1.{1 + i // 2}\n")
        self.grade("--jobs", "8")
        first = snapshot(self.out)
        self.grade("--jobs", "1")
        self.assertEqual(snapshot(self.out), first)
        self.assertEqual([name for name in first if ".tmp" in name or "/." in name[1:]], [])

    def test_the_csv_has_a_row_a_student_and_no_formula(self) -> None:
        self.hand_in("=1+1", ALL)
        self.hand_in("-dash", ALL)
        self.hand_in("zoe", "// passes 1.5\n// says sanitizer\n")
        self.grade()
        with open(self.out / "class.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["total"] for row in rows], ["115", "115", "20"])
        self.assertEqual(rows[2]["1.5"], "30")
        self.assertEqual(rows[2]["out of"], "100")
        self.assertIn("uses fork()", rows[2]["remarks"])
        self.assertRegex(rows[0]["student"], r"^('|odd-name)")
        self.assertNotIn("uses fork()", self.page("zoe"))

    def test_odd_names_cannot_lead_out_or_break_a_page(self) -> None:
        names = ("<b>x", "a\nb", "..x", "index.html", "secret", "x" * 200, "'\"&")
        for name in names:
            self.hand_in(name, ALL)
        self.assertEqual(self.grade().returncode, 0)
        students = [path for path in self.out.iterdir() if path.is_dir()
                    and not path.name.startswith(".")]
        self.assertEqual(len(students), len(names) - 1)  # a leading dot is nobody's
        self.assertTrue((self.out / "index.html").is_file())

    def test_two_submissions_of_one_student_are_not_chosen_between(self) -> None:
        self.hand_in("ann", ALL)
        (self.folder / "ann.zip").write_bytes(b"PK\5\6" + bytes(18))
        self.grade()
        self.assertEqual(self.results("ann")["score"], 0)
        self.assertIn("'ann' and 'ann.zip': keep one of them", self.results("ann")["output"])

    def test_the_class_page_counts_and_links(self) -> None:
        for i in range(4):
            self.hand_in(f"s{i}", "// passes 1.5\n")
        self.hand_in("all", ALL)
        (self.folder / "absent").mkdir()
        self.grade()
        page = (self.out / "index.html").read_text(encoding="utf-8")
        self.assertIn("5 handed in, median 30, mean 47.0 of 100 points", page)
        self.assertIn("30 to 39: 4,", page)
        self.assertIn("90 to 100: 1", page)
        self.assertIn('<a href="s3/index.html">s3</a>', page)
        self.assertNotIn("<script", page)


if __name__ == "__main__":
    unittest.main()
