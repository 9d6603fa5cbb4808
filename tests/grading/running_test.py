"""./tumble grade: jobs, shards, interrupts, resuming, bad arguments, wrong tables."""

import json
import os
import signal
import subprocess
import time
import unittest

from class_kit import ALL, ClassTestCase, snapshot


class Running(ClassTestCase):
    def test_resume_grades_what_is_new_or_changed(self) -> None:
        self.hand_in("ann", ALL)
        self.hand_in("bob", ALL)
        self.grade()
        self.hand_in("bob", "// passes 1.1\n")
        self.hand_in("cec", "// passes 1.2\n")
        before = self.judged()
        self.grade("--resume")
        self.assertEqual(self.judged() - before, 2)
        self.assertEqual(self.results("bob")["score"], 10)
        self.grade()
        self.assertEqual(self.judged() - before, 2 + 2 + 3)

    def test_a_change_of_tests_secret_or_points_is_graded_again(self) -> None:
        self.hand_in("ann", ALL)
        self.grade()
        for path, text in (("tests/spin/other.hpp", "//"), ("secret", "x" * 20)):
            before = self.judged()
            self.kit.write(path, text)
            self.grade("--resume")
            self.assertEqual(self.judged() - before, 3, path)

    def test_an_interrupted_batch_resumes(self) -> None:
        for number, sign in enumerate((signal.SIGINT, signal.SIGTERM)):
            with self.subTest(signal=sign.name):
                self.out = self.kit.root / f"results{number}"
                self._interrupt_and_resume(sign)

    def _interrupt_and_resume(self, sign: signal.Signals) -> None:
        for i in range(8):
            self.hand_in(f"s{i}", ALL + "// waits 0.3\n")
        command = [self.kit.root / "tumble", "grade", self.folder, "--out", self.out, "--secret",
                   self.kit.root / "secret", "--jobs", "1"]
        process = subprocess.Popen(command, text=True, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, start_new_session=True)
        while not (self.out / "s1" / "index.html").exists():
            time.sleep(0.02)
        os.killpg(process.pid, sign)
        said = process.communicate(timeout=20)[1]
        self.assertEqual(process.returncode, 130, said)
        self.assertNotIn("Traceback", said)
        done_before = len(list(self.out.glob("s*/results.json")))
        self.assertLess(done_before, 8)
        before = self.judged()
        self.assertEqual(self.grade("--resume").returncode, 0)
        self.assertLess(self.judged() - before, 8)
        self.assertEqual([self.results(f"s{i}")["score"] for i in range(8)], [115] * 8)

    def test_an_interrupt_does_not_wait_for_an_endless_loop(self) -> None:
        self.hand_in("s0", ALL)
        self.hand_in("s1", ALL + "// runs 3600.25\n")
        command = [self.kit.root / "tumble", "grade", self.folder, "--out", self.out, "--secret",
                   self.kit.root / "secret", "--jobs", "1"]
        process = subprocess.Popen(command, text=True, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE)
        while self.judged() < 4:  # the proof, s0, and s1 that has begun
            time.sleep(0.02)
        time.sleep(0.3)
        process.send_signal(signal.SIGTERM)
        self.assertIn("stopped", process.communicate(timeout=20)[1])
        self.assertEqual(process.returncode, 130)
        self.assertFalse((self.out / "s1").exists())
        running = subprocess.run(["ps", "-eo", "args"], text=True, capture_output=True).stdout
        self.assertNotIn("sleep 3600.25", running)

    def test_jobs_run_side_by_side(self) -> None:
        for i in range(6):
            self.hand_in(f"s{i}", ALL + "// waits 1\n")
        begun = time.monotonic()
        self.grade("--jobs", "6")
        self.assertLess(time.monotonic() - begun, 5.0)

    def test_shards_make_one_class(self) -> None:
        for i in range(7):
            self.hand_in(f"s{i}", ALL)
        self.grade()
        whole = snapshot(self.out)
        self.out = self.kit.root / "sharded"
        for i in (1, 2, 3):
            self.assertEqual(self.grade("--shard", f"{i}/3").returncode, 0)
        self.assertEqual(snapshot(self.out), whole)

    def test_bad_arguments_get_one_line(self) -> None:
        empty = self.kit.root / "empty"
        empty.mkdir()
        self.hand_in("ann", ALL)
        for arguments in (["/no/such"], [str(empty)], ["--labs", "9"], ["--labs", ""],
                          [str(self.folder), "--labs", "1,x"], [str(self.folder), "--jobs", "0"],
                          [str(self.folder), "--shard", "3/2"], [str(self.folder), "--shard", "1"],
                          [str(self.folder), "--out", str(self.folder / "out")], ["--check"],
                          [str(self.folder), "--check"], [""]):
            with self.subTest(arguments=arguments):
                self.assert_one_line(self.kit.tumble("grade", *arguments), 2)
        self.assertEqual(self.judged(), 0)

    def test_a_wrong_table_grades_nobody(self) -> None:
        self.hand_in("ann", ALL)
        for flaw in ({"1.1": {"points": 99}}, {"1.1": {"points": 11}}, {"1.1": {"points": True}},
                     {"1.1": {"points": 10, "bonus": True}}, {"1.4": {"points": 20, "depend": []}},
                     {"1.4": {"points": 20, "depends_on": ["1.5"]}}, {"1.7": {"points": 1}}):
            table = json.loads((self.kit.root / "solutions/1_spin/points.json").read_text())
            table["steps"].update(flaw)
            with self.subTest(flaw=flaw):
                original = (self.kit.root / "solutions/1_spin/points.json").read_text()
                self.write_table(table)
                self.assert_one_line(self.grade(), 1)
                self.kit.write("solutions/1_spin/points.json", original)
        self.kit.write("solutions/1_spin/points.json", "{")
        self.assert_one_line(self.grade(), 1)


if __name__ == "__main__":
    unittest.main()
