"""Checks that neither threads nor the GL library change a byte of a picture.

usage: render_determinism_test.py PROGRAM    (render_gallery_program)
"""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = ""


def picture(folder: Path, quality: str, **settings: str) -> bytes | None:
    """The gallery's PNG under these environment variables; None where that GL is not there."""
    path = folder / "gallery.png"
    path.unlink(missing_ok=True)
    result = subprocess.run([PROGRAM, str(path), "320", "180", quality],
                            env={**os.environ, **settings}, capture_output=True, text=True,
                            timeout=100, check=False)
    if result.returncode != 0:
        if "no off-screen GL" in result.stderr or "is not one of" in result.stderr:
            return None
        raise AssertionError(result.stderr)
    return path.read_bytes()


class Determinism(unittest.TestCase):
    def test_threads_and_backends(self) -> None:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for quality in ("draft", "film", "report"):
                first = picture(folder, quality)
                self.assertIsNotNone(first, "no GL at all")
                for backend in ("osmesa", "egl"):
                    for threads in ("0", "1", "2", "8"):
                        with self.subTest(quality=quality, backend=backend, threads=threads):
                            got = picture(folder, quality, TUMBLE_GL=backend,
                                          LP_NUM_THREADS=threads)
                            if got is None:
                                self.skipTest(f"{backend} is not here")
                            self.assertEqual(got, first)

    def test_unknown_backend(self) -> None:
        with tempfile.TemporaryDirectory() as name:
            result = subprocess.run([PROGRAM, str(Path(name) / "a.png"), "32", "18", "draft"],
                                    env={**os.environ, "TUMBLE_GL": "vulkan"},
                                    capture_output=True, text=True, timeout=100, check=False)
            self.assertEqual(result.returncode, 1)
            self.assertIn("TUMBLE_GL=vulkan is not one of", result.stderr)
            self.assertEqual(list(Path(name).iterdir()), [])


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
