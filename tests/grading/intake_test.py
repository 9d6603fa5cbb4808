"""What is taken from a submission: one file by exact name, and from hostile ones nothing."""

import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

from class_kit import ClassTestCase
from evil_archives import GOOD, NAME, write_zip
from evil_submissions import EVIL, write_all
from tumble.console import Failure
from tumble.grading.intake import Submission, checked, submissions, take


class Intake(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="tumble test "))
        self.addCleanup(shutil.rmtree, self.folder)

    def test_each_evil_submission_is_survived_and_named(self) -> None:
        for name, write, words in EVIL:
            with self.subTest(name=name):
                around = self.folder / f"around {name}"
                around.mkdir()
                path = around / name
                write(path)
                before = list(around.rglob("*"))
                taken = take(Submission("s", path), [NAME])[NAME]
                if words is None:
                    self.assertEqual((taken.text, taken.problem), (GOOD, ""))
                else:
                    self.assertIsNone(taken.text)
                    self.assertRegex(taken.problem, words)
                self.assertTrue((taken.problem + "".join(taken.notes)).isprintable())
                self.assertLess(len(taken.problem), 300)
                self.assertEqual(list(around.rglob("*")), before)

    def test_a_bomb_costs_little(self) -> None:
        path = self.folder / "bomb.zip"
        next(write for name, write, _ in EVIL if name == "bomb.zip")(path)
        before = os.times()
        take(Submission("s", path), [NAME])
        after = os.times()
        self.assertLess(after.children_user - before.children_user, 1.0)

    def test_a_byte_order_mark_is_noted(self) -> None:
        self.assertEqual(checked(b"\xef\xbb\xbfint x;").text, b"int x;")
        self.assertIn("byte-order mark", checked(b"\xef\xbb\xbfint x;").notes[0])

    def test_paths_that_lead_out_are_noted_and_never_written(self) -> None:
        outside = self.folder / "outside"
        path = self.folder / "in" / "x.zip"
        path.parent.mkdir()
        write_zip(path, [("../outside", b"x"), ("/outside", b"x"), (NAME, GOOD)])
        taken = take(Submission("s", path), [NAME])[NAME]
        self.assertEqual(taken.text, GOOD)
        self.assertIn("'../outside' and 1 more", taken.notes[0])
        self.assertFalse(outside.exists())

    def test_several_labs_are_taken_at_once(self) -> None:
        path = self.folder / "x.zip"
        write_zip(path, [("a.cpp", b"//a"), ("b.cpp", b"//b"), ("b/b.cpp", b"//c")])
        taken = take(Submission("s", path), ["a.cpp", "b.cpp", "c.cpp"])
        self.assertEqual(taken["a.cpp"].text, b"//a")
        self.assertIn("2 times", taken["b.cpp"].problem)
        self.assertTrue(taken["c.cpp"].missing)

    def test_students_are_named_by_folders_and_archives(self) -> None:
        for name in ("ann", ".hidden"):
            (self.folder / name).mkdir()
        for name in ("bob.zip", "cec.tar.gz", "dan.x.tgz", "Ünal Ö.zip", "eve.txt"):
            (self.folder / name).write_bytes(b"")
        self.assertEqual([submission.student for submission in submissions(self.folder)],
                         ["ann", "bob", "cec", "dan.x", "eve.txt", "Ünal Ö"])

    def test_a_name_that_is_not_text_is_a_students_too(self) -> None:
        (self.folder / os.fsdecode(b"\xff\xfe")).mkdir()
        self.assertRegex(submissions(self.folder)[0].student, r"\Aodd-name-[0-9a-f]{12}\Z")

    def test_no_folder_and_no_submission_are_told(self) -> None:
        for folder in (self.folder, self.folder / "none"):
            with self.assertRaises(Failure):
                submissions(folder)


class Batch(ClassTestCase):
    def test_a_class_of_evil_submissions_is_graded_to_its_end(self) -> None:
        write_all(self.folder)
        done = self.grade()
        self.assertEqual(done.returncode, 0, done.stderr)
        for submission in submissions(self.folder):
            results = self.results(submission.student)
            names = [name for name, _, _ in EVIL if re.sub(r"\.(zip|tar.*|tbz2)$", "", name)
                     == submission.student]
            words = [words for name, _, words in EVIL if name in names]
            if len(names) == 1:
                self.assertEqual(results["score"], 10 if words[0] is None else 0, names)
            else:
                self.assertEqual(results["score"], 0, names)
                self.assertIn("keep one of them", results["output"])


if __name__ == "__main__":
    unittest.main()
