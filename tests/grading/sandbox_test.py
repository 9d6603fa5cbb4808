"""The limits of processes, beside many others of the same user."""

import subprocess
import tempfile
import unittest
from pathlib import Path

from tumble.grading.sandbox import COMPILER, Sandbox

from box import box_or_skip


class Processes(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="tumble-")))
        self.folder.chmod(0o755)
        self.user = Sandbox(False).as_user()

    def crowd(self) -> None:
        """More processes than a compiler may have, of the user of the sandbox."""
        for _ in range(COMPILER.processes + 8):
            process = subprocess.Popen([*self.user, "sleep", "60"])
            self.addCleanup(process.wait)
            self.addCleanup(process.kill)

    def compile(self, sandbox: Sandbox) -> int:
        command = sandbox.compile_command(self.folder, self.folder, ["/bin/sh", "-c", "true | cat"])
        return subprocess.run(command, stderr=subprocess.DEVNULL).returncode

    def test_a_compiler_does_not_share_its_limit(self) -> None:
        self.crowd()
        self.assertEqual(self.compile(Sandbox(False)), 0)
        self.assertEqual(self.compile(box_or_skip()), 0)

    def test_a_compiler_in_the_box_has_one(self) -> None:
        sleepers = "for i in $(seq 40); do sleep 1 & done"
        command = box_or_skip().compile_command(self.folder, self.folder,
                                                ["/bin/sh", "-c", sleepers])
        self.assertNotEqual(subprocess.run(command, stderr=subprocess.DEVNULL).returncode, 0)

    def test_a_worker_begins_no_process(self) -> None:
        script = self.folder / "driver"
        script.write_text("#!/bin/sh\ntrue | cat\n", encoding="ascii")
        script.chmod(0o755)
        command = Sandbox(False).worker_command(script, False)
        self.assertNotEqual(subprocess.run(command, stderr=subprocess.DEVNULL).returncode, 0)


if __name__ == "__main__":
    unittest.main()
