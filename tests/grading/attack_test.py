"""The bank of attacks, each graded against lab 1: none earns, leaves a trace or touches another.

attacks/manifest.json says of each file: its family; its base; the words that its cases may get; the
steps that it solves honestly, if any; what the sanitizers must say; what graders are told. Bases:
    calls  every function of the stub calls the file's attack() first
    stub   the file stands before the stub
    own    the file has its own functions of steps 1.1 and 1.2, the others are the stub's
"""

import json
import re
import socket
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from unittest import mock

from tumble.grading import cases, sandbox
from tumble.grading.compiling import tools
from tumble.grading.judge import judge
from tumble.grading.verdicts import Judged
from tumble.labs import find_lab

from box import box_or_skip

ROOT = Path(__file__).resolve().parents[2]
ATTACKS = ROOT / "tests/grading/attacks"
STEPS = ("1.1",)
SECRET = "a secret of the neighbour"
SEEDS = (917465328104, 350912874663)

_OWN = re.compile(r"^\w+ (?:skew|world_point|body_point|point_velocity)\(.*?^}\n", re.M | re.S)
_THROW = "  throw common::NotImplemented("


class Attacks(unittest.TestCase):
    """All attacks are made once; the tests look at what came of them."""

    results: dict[str, Judged]

    @classmethod
    def setUpClass(cls) -> None:
        cls.manifest = json.loads((ATTACKS / "manifest.json").read_text(encoding="utf-8"))
        cls.lab = find_lab(ROOT, "1")
        cls.box = box_or_skip()
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="tumble-")))
        cls.folder.chmod(0o755)
        cls.neighbour = cls.folder / "neighbour"
        cls.neighbour.mkdir()
        cls.neighbour.chmod(0o777)  # only the box is in the way
        (cls.neighbour / "secret.txt").write_text(f"#error {SECRET}\n", encoding="utf-8")
        cls.listener = cls.enterClassContext(socket.create_server(("127.0.0.1", 0)))
        cls.listener.setblocking(False)
        quick = sandbox.COMPILER._replace(cpu=20)
        cls.enterClassContext(mock.patch.object(sandbox, "COMPILER", quick))
        cls.enterClassContext(mock.patch.object(cases, "PATIENCE", 1))
        right = (ROOT / "solutions" / cls.lab.folder / cls.lab.stub.name).read_bytes()
        cls.alone = cls.judged(right, False)
        with ThreadPoolExecutor(2) as pool:
            futures = {name: pool.submit(cls.judged, cls.source(name), "solves" in entry)
                       for name, entry in cls.manifest.items()}
            beside = pool.submit(cls.judged, right, False)
            cls.results = {name: future.result() for name, future in futures.items()}
            cls.beside = beside.result()

    @classmethod
    def judged(cls, source: bytes, sanitize: bool) -> Judged:
        with tempfile.TemporaryDirectory(dir=cls.folder) as work:
            return judge(ROOT, cls.lab, source, Path(work), SEEDS, cls.box, sanitize, STEPS)

    @classmethod
    def source(cls, name: str) -> bytes:
        text = (ATTACKS / f"{name}.cpp").read_text(encoding="utf-8")
        stub = cls.lab.stub.read_text(encoding="utf-8")
        for mark, value in (("ROOT", ROOT), ("NEIGHBOUR", cls.neighbour),
                            ("PROGRAM", tools(ROOT, cls.lab).test),
                            ("PORT", cls.listener.getsockname()[1])):
            text = text.replace(f"@{mark}@", str(value))
        base = cls.manifest[name]["base"]
        if base == "calls":
            stub = stub.replace(_THROW, f"  attack();\n{_THROW}")
        elif base == "own":
            stub = _OWN.sub("", stub)
        return f"{text}\n{stub}".encode()

    def test_the_manifest_is_the_folder(self) -> None:
        self.assertEqual(set(self.manifest), {path.stem for path in ATTACKS.glob("*.cpp")})
        self.assertGreaterEqual(len(self.manifest), 30)

    def test_no_attack_earns_a_step(self) -> None:
        for name, result in self.results.items():
            with self.subTest(name):
                self.assertTrue(result.sandboxed)
                for step in STEPS:
                    words = {case.word for case in result.cases if case.step == step}
                    solved = words == {"pass"}
                    self.assertEqual(solved, step in self.manifest[name].get("solves", []), words)

    def test_each_attack_gets_a_word_for_what_it_did(self) -> None:
        for name, result in self.results.items():
            with self.subTest(name):
                words = {case.word for case in result.cases} or {"does not compile"}
                self.assertEqual(words - set(self.manifest[name]["words"]), set(),
                                 (result.cases[:1], result.diagnostics[:600]))

    def test_undefined_behaviour_is_found_or_told(self) -> None:
        for name, entry in self.manifest.items():
            with self.subTest(name):
                self.assertRegex(self.results[name].sanitizer, entry.get("sanitizer", "^$"))
                notes = "\n".join(self.results[name].notes)
                self.assertIn(entry.get("note", ""), notes)

    def test_nothing_secret_is_told(self) -> None:
        for name, result in self.results.items():
            with self.subTest(name):
                self.assertLess(len(result.diagnostics), 4200)
                said = repr(result)
                for secret in (SECRET, "root:", "TEST_CASE", str(SEEDS[0]), str(SEEDS[1])):
                    self.assertNotIn(secret, said)

    def test_the_neighbour_has_the_same_result_and_files(self) -> None:
        def without_times(result: Judged) -> Judged:
            return result._replace(cases=[case._replace(seconds=0.0) for case in result.cases])
        self.assertEqual({case.word for case in self.alone.cases}, {"pass"})
        self.assertEqual(without_times(self.beside), without_times(self.alone))
        self.assertEqual([path.name for path in self.neighbour.iterdir()], ["secret.txt"])
        self.assertFalse((ROOT / "new.txt").exists())

    def test_nobody_came_by_the_network(self) -> None:
        with self.assertRaises(BlockingIOError):
            self.listener.accept()

    def test_no_process_is_left(self) -> None:
        """A worker that another grader on this machine runs ends within its time."""
        left = workers()
        deadline = time.monotonic() + 40.0
        while left and time.monotonic() < deadline:
            time.sleep(0.2)
            left &= workers()
        self.assertEqual(left, set())


def workers() -> set[tuple[str, str]]:
    """Process and time of its start, of all that are workers by their command line."""
    found = set()
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if (folder / "cmdline").read_bytes().split(b"\0")[0] == b"/driver":
                status = (folder / "stat").read_text().rsplit(")", 1)[1].split()
                found.add((folder.name, status[19]))
        except OSError:
            continue
    return found


if __name__ == "__main__":
    unittest.main()
