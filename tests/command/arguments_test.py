"""Every bad argument gets one clear line and exit code 2, before anything is built."""

import os
import shutil
import unittest
from pathlib import Path

from fake_kit import LAB, ROOT, KitTestCase

HERE = Path(__file__).resolve().parent
COMMANDS = ("demo", "verify", "test", "watch", "hint", "frames", "chart", "doctor", "handout",
            "grade")

BAD = (
    [], ["nonsense"], ["--nonsense"], ["tes", "1"], ["\n"],
    ["test"], ["test", "9"], ["test", "x"], ["test", ""], ["test", "-1"], ["test", "01"],
    ["test", "1.2"], ["test", "1", "2"], ["test", "1", "--al"], ["test", "9" * 5000],
    ["test", "a\nb"], ["test", "\udcff"],
    ["watch"], ["watch", "7"],
    ["frames"], ["frames", "x"], ["chart", "x"], ["chart", "1", "--size", "640x480"],
    ["frames", "1", "--fps", "-1"], ["frames", "1", "--fps", "0"], ["frames", "1", "--fps", "nan"],
    ["frames", "1", "--fps", "inf"], ["frames", "1", "--fps", "241"], ["frames", "1", "--fps", "x"],
    ["frames", "1", "--fps"], ["frames", "1", "--size", "640"], ["frames", "1", "--size", "0x0"],
    ["frames", "1", "--size", "640x"], ["frames", "1", "--size", "-640x480"],
    ["frames", "1", "--size", "99999x99999"], ["frames", "1", "--size", "640x480x3"],
    ["frames", "1", "--from", "-1"], ["frames", "1", "--to", "x"],
    ["frames", "1", "--from", "2", "--to", "1"], ["frames", "1", "--quality", "best"],
    ["hint"], ["hint", "1"], ["hint", "x"], ["hint", "1.2.3"], ["hint", "9.1"], ["hint", "1.99"],
    ["hint", "1.1", "--again", "--reset"],
    ["demo", "1"], ["verify", "all"], ["doctor", "1"],
    ["handout"], ["handout", "x.zip"], ["handout", ""], ["grade"], ["grade", "/no/such"],
    ["grade", "."], ["grade", ".", "--shard", "0/2"], ["grade", ".", "--jobs", "-1"],
)


class Arguments(KitTestCase):
    def test_a_bad_argument_gets_one_line_and_code_2(self) -> None:
        for arguments in BAD:
            with self.subTest(arguments=[argument[:40] for argument in arguments]):
                self.assert_one_line(self.kit.tumble(*arguments), 2)
        self.assertEqual(self.kit.calls("cmake"), [])

    def test_a_bad_lab_number_lists_the_labs(self) -> None:
        self.assertIn("1 (spin & <turn>)", self.kit.tumble("test", "9").stderr)

    def test_an_unknown_command_lists_the_commands(self) -> None:
        line = self.kit.tumble("nonsense").stderr
        for command in COMMANDS:
            self.assertIn(command, line)

    def test_every_command_explains_itself(self) -> None:
        overview = self.kit.tumble("--help")
        self.assertEqual(overview.returncode, 0)
        for command in COMMANDS:
            done = self.kit.tumble(command, "--help")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(f"usage: tumble {command}", done.stdout)
            self.assertIn(f"    {command} ", overview.stdout)

    def test_the_help_of_a_handout_offers_only_what_it_has(self) -> None:
        (self.kit.root / "solutions" / LAB / "spin.cpp").unlink()
        told = [self.kit.tumble("--help").stdout, self.kit.tumble("frames", "--help").stdout,
                self.kit.tumble("chart", "--help").stdout]
        for command in ("demo", "test", "hint"):
            self.assertIn(f"    {command} ", told[0])
        for word in ("    verify ", "    grade ", "    handout ", "--solution"):
            self.assertNotIn(word, "".join(told))
        self.assertIn("this is a hand-out", self.kit.tumble("verify").stderr)


class Launcher(KitTestCase):
    def test_it_works_from_another_folder_and_through_symlinks(self) -> None:
        away = self.kit.root / "away"
        away.mkdir()
        os.symlink("../tumble", away / "near")
        os.symlink(away / "near", away / "far")
        for program in (self.kit.root / "tumble", away / "near", away / "far"):
            done = self.kit.tumble("test", "9", program=program, cwd=away)
            self.assertIn("1 (spin", done.stderr)

    def test_files_in_the_users_folder_cannot_get_in_between(self) -> None:
        for name in ("argparse.py", "json.py", "tumble.py"):
            self.kit.write(f"away/{name}", "raise SystemExit('shadowed')\n")
        done = self.kit.tumble("--help", cwd=self.kit.root / "away",
                               settings={"PYTHONPATH": str(self.kit.root / "away")})
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_it_leaves_no_compiled_python_behind(self) -> None:
        self.kit.tumble("--help")
        self.assertEqual(list(self.kit.root.rglob("__pycache__")), [])

    def test_without_python_nothing_is_installed_unasked(self) -> None:
        (self.kit.tools / "python3").unlink()
        for arguments in (["test", "1"], ["demo", "--no-install"], []):
            done = self.kit.tumble(*arguments)
            self.assert_cause_and_remedy(done)
            self.assertIn("apt-get install --no-install-recommends python3\n", done.stderr)
        self.assertIn("./tumble demo, which installs it", self.kit.tumble("test", "1").stderr)
        self.assertEqual(self.kit.calls("apt-get"), [])

    def test_without_python_demo_installs_it_or_says_why_it_cannot(self) -> None:
        (self.kit.tools / "python3").unlink()
        real = Path(shutil.which("id") or "")
        before = real.read_bytes()
        self.kit.add_tool("id", "echo 1000\n")
        self.assertEqual(real.read_bytes(), before)
        done = self.kit.tumble("demo")
        self.assert_cause_and_remedy(done)
        self.assertIn("python3 is missing; installing it needs root, and there is no sudo",
                      done.stderr)
        self.assertIn("as root, type: apt-get install", done.stderr)
        self.kit.add_tool("sudo", 'exec "$@"\n')
        self.kit.add_tool("apt-get", """echo "$*" >> "$FAKE/calls/apt-get"
echo "E: Failed to fetch http://x  Temporary failure resolving 'x'"
exit 100
""")
        done = self.kit.tumble("demo")
        self.assert_cause_and_remedy(done)
        self.assertIn("apt-get failed: Failed to fetch http://x  Temporary failure", done.stderr)
        self.assertIn("or: sudo apt-get install", done.stderr)
        self.assertEqual(len(self.kit.calls("apt-get")), 1)
        (self.kit.tools / "apt-get").unlink()
        done = self.kit.tumble("demo")
        self.assert_cause_and_remedy(done)
        self.assertIn("there is no apt-get", done.stderr)

    def test_a_reader_that_has_seen_enough_is_no_error(self) -> None:
        self.kit.add_tool("head_of_help", '"$1" --help 2>"$FAKE/stderr" | read -r line\n')
        self.kit.tumble(str(self.kit.root / "tumble"), program=self.kit.tools / "head_of_help")
        self.assertEqual((self.kit.fake / "stderr").read_text(encoding="utf-8"), "")


class Sources(unittest.TestCase):
    def test_no_file_is_longer_or_wider_than_agreed(self) -> None:
        for path in [*(ROOT / "common" / "command").rglob("*.py"),
                     *(ROOT / "solutions" / "grading").rglob("*.py"), *HERE.glob("*.py"),
                     *HERE.with_name("grading").glob("*.py")]:
            lines = path.read_text(encoding="utf-8").splitlines()
            self.assertLessEqual(len(lines), 200, path)
            self.assertLessEqual(max(map(len, lines), default=0), 100, path)


if __name__ == "__main__":
    unittest.main()
