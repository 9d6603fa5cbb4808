"""./tumble frames, chart and demo: the programs run as they should and the page is renewed."""

import unittest

from fake_kit import LAB, KitTestCase

PROGRAM = """
echo "$*" >> "$FAKE/calls/program"
mkdir -p "$2"
for file in "$2"/*; do
  case "$file" in */frame_0000.png | */chart.csv | */"*") ;; *) exit 1 ;; esac
done
touch "$2/frame_0000.png" "$2/chart.csv"
"""


class Pictures(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        for variant in ("student", "reference"):
            for kind in ("scene", "chart"):
                self.add_program(f"spin_{variant}_{kind}", PROGRAM)

    def add_program(self, name: str, body: str) -> None:
        self.kit.add_program(self.kit.root / "build" / "release" / "labs" / LAB / name, body)

    def test_frames_passes_its_options_on_and_renews_the_page(self) -> None:
        done = self.kit.tumble("frames", "1", "--solution", "--size", "640x480", "--fps", "12.5",
                               "--from", "0.5", "--to", "2", "--quality", "draft", "--white")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        folder = self.kit.root / "out" / LAB / "reference" / "film"
        self.assertEqual(self.kit.calls("program"), [
            f"--out {folder} --size 640x480 --fps 12.5 --from 0.5 --to 2 --quality draft --white"])
        page = (self.kit.root / "out" / "index.html").read_text(encoding="utf-8")
        self.assertIn("./tumble frames 1 --solution --size 640x480 --fps 12.5", page)
        self.assertTrue(self.kit.calls("ninja")[-1].endswith(" spin_reference_scene"))

    def test_a_mesh_is_for_the_lab_that_has_meshes_and_two_at_most(self) -> None:
        for command in ("frames", "chart"):
            self.assert_one_line(self.kit.tumble(command, "1", "--mesh", "a.obj"), 2)
        self.kit.write(f"labs/{LAB}/own_meshes.hpp", "")
        self.assert_one_line(self.kit.tumble("frames", "1", *["--mesh", "a.obj"] * 3), 2)
        for command in ("frames", "chart"):
            done = self.kit.tumble(command, "1", "--mesh", "a.obj", "--mesh", "b.obj")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertTrue(self.kit.calls("program")[-1].endswith("--mesh a.obj --mesh b.obj"))

    def test_a_film_becomes_a_gif_and_an_mp4_where_ffmpeg_is(self) -> None:
        film = self.kit.root / "out" / LAB / "student" / "film"
        self.add_program("spin_student_scene",
                         PROGRAM + 'echo \'{"fps": 12.5}\' > "$2/film.json"\n')
        done = self.kit.tumble("frames", "1", "--gif")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("film.gif needs ffmpeg, which is missing: install the package ffmpeg",
                      done.stdout)
        self.assertIn("ffmpeg -nostdin", done.stdout)
        (film / "frame_0000.png").unlink()
        (film / "film.json").unlink()
        self.kit.add_tool("ffmpeg", 'echo "$*" >> "$FAKE/calls/ffmpeg"\n'
                          'for last; do :; done\necho film > "$last"\n')
        done = self.kit.tumble("frames", "1", "--gif", "--mp4")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("-framerate 12.5 ", self.kit.calls("ffmpeg")[0])
        self.assertEqual(sorted(file.name for file in film.parent.iterdir()),
                         ["film", "film-command.txt", "film.gif", "film.mp4"])

    def test_an_ffmpeg_that_fails_leaves_nothing_half_written(self) -> None:
        self.add_program("spin_student_scene", PROGRAM + "echo '{}' > \"$2/film.json\"\n")
        self.kit.add_tool("ffmpeg", 'for last; do :; done\necho half > "$last"\nexit 1\n')
        done = self.kit.tumble("frames", "1", "--mp4")
        self.assert_one_line(done, 1)
        film = self.kit.root / "out" / LAB / "student"
        self.assertEqual([file.name for file in film.glob("*mp4*")], [])

    def test_all_of_it_works_twice_in_a_row(self) -> None:
        for command in ("frames", "chart") * 2:
            self.assertEqual(self.kit.tumble(command, "1").returncode, 0)

    def test_out_is_seen_from_the_users_folder(self) -> None:
        away = self.kit.root / "away"
        away.mkdir()
        done = self.kit.tumble("chart", "1", "--out", "my pictures", cwd=away)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((away / "my pictures" / LAB / "student" / "chart" / "chart.csv").exists())
        page = (away / "my pictures" / "index.html").read_text(encoding="utf-8")
        self.assertIn("./tumble chart 1 --out &#x27;my pictures&#x27;", page)

    def test_the_programs_own_error_line_and_failure_come_through(self) -> None:
        self.add_program("spin_student_scene", 'echo "error: no GL" >&2\nexit 1\n')
        done = self.kit.tumble("frames", "1")
        self.assertEqual((done.returncode, done.stderr), (1, "error: no GL\n"))

    def test_peers_are_looked_for_again_and_passed_on(self) -> None:
        self.assertEqual(self.kit.tumble("chart", "1").returncode, 0)
        done = self.kit.tumble("chart", "1", "--peers")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        folder = self.kit.root / "out" / LAB / "student" / "chart"
        self.assertEqual(self.kit.calls("program"), [f"--out {folder}", f"--out {folder} --peers"])
        configured = [call for call in self.kit.calls("cmake") if call.startswith("--preset")]
        self.assertEqual(len(configured), 2)
        page = (self.kit.root / "out" / "index.html").read_text(encoding="utf-8")
        self.assertIn("./tumble chart 1 --peers", page)
        self.assert_one_line(self.kit.tumble("frames", "1", "--peers"), 2)

    def test_demo_never_asks_for_peers(self) -> None:
        self.kit.write("fake/targets", "spin_reference_scene: phony\nspin_reference_chart: phony\n")
        self.assertEqual(self.kit.tumble("demo").returncode, 0)
        self.assertNotIn("--peers", " ".join(self.kit.calls("program")))
        self.assertNotIn("bullet", " ".join(self.kit.calls("dpkg-query")))

    def test_a_crash_is_said(self) -> None:
        self.add_program("spin_student_scene", "kill -SEGV $$\n")
        self.assert_one_line(self.kit.tumble("frames", "1"), 1)

    def test_an_out_folder_that_cannot_be_written_is_found_before_the_build(self) -> None:
        self.kit.write("file", "")
        for out in ("file", "file/inside", "/proc/nowhere"):
            self.assert_one_line(self.kit.tumble("frames", "1", "--out", out), 1)
        self.assertEqual(self.kit.calls("cmake"), [])

    def test_a_scene_that_this_machine_cannot_build_is_said(self) -> None:
        self.kit.write("fake/build_error", "ninja: error: unknown target 'spin_student_scene'\n")
        done = self.kit.tumble("frames", "1")
        self.assert_one_line(done, 1)
        self.assertIn("./tumble doctor", done.stderr)

    def test_demo_draws_what_can_be_built_and_says_what_cannot(self) -> None:
        self.kit.write("fake/targets", "spin_reference_scene: phony\nspin_reference_chart: phony\n")
        done = self.kit.tumble("demo")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(self.kit.calls("program")), 2)
        self.kit.write("fake/targets", "spin_reference_chart: phony\n")
        done = self.kit.tumble("demo")
        self.assertEqual(done.returncode, 1)
        self.assertIn("Not drawn: spin_reference_scene", done.stdout)


if __name__ == "__main__":
    unittest.main()
