"""./tumble handout: what is in it, what must not be, the same bytes each time, bad paths."""

import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

from fake_kit import ROOT, KitTestCase
from leaks import answers, leaks

# The exponential map stands in common in finished form: every later lab turns bodies by it.
SUPPLIED = {"common/rotation/attitude.cpp", "common/contact/rigid_body.cpp"}


def handout(root: Path, file: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([root / "tumble", "handout", file], text=True, capture_output=True)


class Content(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = Path(tempfile.mkdtemp(prefix="tumble test "))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "kit.tar.gz"
        cls.said = handout(ROOT, cls.file)
        with tarfile.open(cls.file) as archive:
            cls.members = archive.getmembers()
            archive.extractall(cls.folder, members=cls.members)  # our own, checked below
        cls.names = {member.name for member in cls.members}
        cls.kit = cls.folder / "tumble"

    def test_it_holds_what_a_student_needs(self) -> None:
        for path in ROOT.glob("labs/*/"):
            name = path.name.split("_", 1)[1]
            for file in ("README.md", "CMakeLists.txt", f"{name}.hpp", f"{name}.cpp", "hints.md",
                         "scene.cpp", "chart.cpp"):
                self.assertIn(f"tumble/labs/{path.name}/{file}", self.names)
            for sketch in path.glob("sketches/*"):
                self.assertIn(f"tumble/labs/{path.name}/sketches/{sketch.name}", self.names)
            tests = list(ROOT.glob(f"tests/{name}/*_test.cpp"))
            self.assertTrue(tests)
            for test in tests:
                self.assertIn(f"tumble/tests/{name}/{test.name}", self.names)
        for name in ("tumble", "README.md", "CMakeLists.txt", "CMakePresets.json", "LICENSE",
                     "common/command/tumble/checklist.py", "render/CMakeLists.txt",
                     "labs/sketch_style.gp"):
            self.assertIn(f"tumble/{name}", self.names)

    def test_no_name_tells_of_solutions_mistakes_or_grading(self) -> None:
        for name in self.names:
            self.assertNotRegex(name, r"solutions|mistake|mutant|seeds_test|grading|\.\.|//")
            self.assertNotRegex(name, r"^(?!tumble/)|/\.(?!clang-format|clangd)")
            self.assertNotRegex(name, r"__pycache__|/build/|/out/")

    def test_no_file_holds_a_row_of_an_answer_or_a_mistake(self) -> None:
        found = leaks(self.kit, answers(ROOT))
        self.assertEqual(set(found) - SUPPLIED, set(), found)

    def test_a_row_of_an_answer_would_be_found(self) -> None:
        known = answers(ROOT)
        for answer in ROOT.glob("solutions/[0-9]*/*.cpp"):
            with self.subTest(answer=answer.name), tempfile.TemporaryDirectory() as folder:
                shutil.copy(answer, Path(folder) / "notes.hpp")
                self.assertTrue(leaks(Path(folder), known))

    def test_the_edits_that_make_mistakes_are_not_told(self) -> None:
        for path in self.kit.rglob("*"):
            if path.is_file() and path.suffix in (".cmake", ".txt", ".md", ".py"):
                text = path.read_text(encoding="utf-8")
                self.assertNotRegex(text, r"(?m)^ *add_mutant\([a-z_]+ ", path)

    def test_modes_times_and_owners_are_the_same_everywhere(self) -> None:
        for member in self.members:
            self.assertTrue(member.isreg())
            self.assertEqual((member.mtime, member.uid, member.gid, member.uname),
                             (946684800, 0, 0, ""))
            self.assertEqual(member.mode, 0o755 if member.name == "tumble/tumble" else 0o644)
        names = [member.name for member in self.members if member.name != "tumble/README.md"]
        self.assertEqual(names, sorted(names))

    def test_a_second_one_has_the_same_bytes(self) -> None:
        again = self.folder / "again.tar.gz"
        self.assertEqual(handout(ROOT, again).returncode, 0)
        self.assertEqual(again.read_bytes(), self.file.read_bytes())

    def test_its_own_readme_speaks_to_students(self) -> None:
        text = (self.kit / "README.md").read_text(encoding="utf-8")
        self.assertEqual(text, (ROOT / "labs" / "README.md").read_text(encoding="utf-8"))
        for word in ("verify", "solutions/", "./tumble grade", "./tumble handout", "--solution"):
            self.assertNotIn(word, text)

    def test_what_needs_solutions_says_that_this_is_a_handout(self) -> None:
        for arguments in (["verify"], ["frames", "1", "--solution"], ["chart", "1", "--solution"],
                          ["handout", "x.tar.gz"], ["grade", "."]):
            done = subprocess.run([self.kit / "tumble", *arguments], text=True, capture_output=True)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertRegex(done.stderr, r"\Atumble: [^\n]*this is a hand-out, which has none\n\Z")

    def test_hints_and_demo_work_without_solutions(self) -> None:
        hint = subprocess.run([self.kit / "tumble", "hint", "1.1"], text=True, capture_output=True)
        self.assertIn("Idea.", hint.stdout)
        demo = subprocess.run([self.kit / "tumble", "demo", "--no-install"], text=True,
                              capture_output=True)
        self.assertEqual(demo.returncode, 0)
        self.assertIn("Begin with ./tumble test 1", demo.stdout)


class BadInput(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        self.kit.write("labs/1_spin/spin.cpp", "// a stub\nWrench net_wrench() {\n"
                       '  throw common::NotImplemented("1.3 net_wrench");\n}\n')

    def test_a_bad_path_gets_one_line_and_leaves_nothing(self) -> None:
        (self.kit.root / "folder.tar.gz").mkdir()
        before = sorted(self.kit.root.iterdir())
        for path, code in (("x.zip", 2), (".tar.gz", 2), ("", 2), ("/no/such/x.tar.gz", 1),
                           ("folder.tar.gz", 1), ("README.tar.gz/x.tar.gz", 1)):
            with self.subTest(path=path):
                self.assert_one_line(self.kit.tumble("handout", path), code)
        self.assertEqual(sorted(self.kit.root.iterdir()), before)

    def test_an_answer_in_place_of_a_stub_is_not_handed_out(self) -> None:
        stub = self.kit.root / "labs" / "1_spin" / "spin.cpp"
        stub.write_text(stub.read_text() + "double skew() { /* ; */ return 1.0; }\n")
        done = self.kit.tumble("handout", "x.tar.gz")
        self.assert_one_line(done, 1)
        self.assertIn("labs/1_spin/spin.cpp is not the untouched stub: it contains "
                      "'double skew() {  return 1.0; }'; restore",
                      done.stderr)
        self.assertFalse((self.kit.root / "x.tar.gz").exists())

    def test_links_and_what_git_does_not_track_stay_out(self) -> None:
        self.kit.write("labs/1_spin/notes.md", "the answers")
        (self.kit.root / "labs" / "1_spin" / "link.md").symlink_to("/etc/passwd")
        self.kit.write("labs/1_spin/build/x.cpp~", "")
        if not shutil.which("git"):
            self.skipTest("no git")
        for command in (["init", "-q"], ["add", "labs/1_spin/README.md", "labs/1_spin/spin.cpp"]):
            subprocess.run(["git", *command], cwd=self.kit.root, check=True)
        (self.kit.tools / "git").symlink_to(shutil.which("git"))
        done = self.kit.tumble("handout", "x.tar.gz")
        self.assertIn("not track it: ", done.stdout)
        with tarfile.open(self.kit.root / "x.tar.gz") as archive:
            self.assertEqual(archive.getnames(), ["tumble/labs/1_spin/README.md",
                                                  "tumble/labs/1_spin/spin.cpp"])


if __name__ == "__main__":
    sys.exit(unittest.main())
