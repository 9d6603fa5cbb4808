"""out/index.html: whatever the files say, it is text on the page; every file it names is there."""

import html.parser
import json
import unittest
import urllib.parse
from pathlib import Path

from fake_kit import LAB, KitTestCase
from tumble import page

NASTY = "</script><script>alert('1')</script>\"&' onload=x"


class Reader(html.parser.HTMLParser):
    """Notes every file that the page names, its tags and its text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.files: list = []
        self.tags: list = []
        self.text = ""
        self.without_alt = 0
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list) -> None:
        values = dict(attributes)
        self.tags.append(tag)
        self.files += [values[key] for key in ("src", "href")
                       if not values.get(key, "#").startswith("#")]
        self.files += json.loads(values.get("data-frames") or "[]")
        self.without_alt += tag == "img" and not values.get("alt")

    def handle_data(self, data: str) -> None:
        self.text += data


class Page(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        self.out = self.kit.root / "out"

    def add_film(self, variant: str, told: object, frames: int = 3) -> Path:
        folder = f"out/{LAB}/{variant}/film"
        for number in range(frames):
            self.kit.write(f"{folder}/frame_{number:04d}.png", "")
        self.kit.write(f"{folder}/strip.png", "")
        self.kit.write(f"{folder}/film.json", told if isinstance(told, str) else json.dumps(told))
        return self.kit.root / folder

    def add_chart(self, variant: str) -> None:
        for name in ("chart.svg", "chart.gp"):
            self.kit.write(f"out/{LAB}/{variant}/chart/{name}", "")
        self.kit.write(f"out/{LAB}/{variant}/chart/chart.csv", (
            "lab,method,parameter,error,error_unit,seconds,work_unit,evaluations,status\n"
            f"1,{NASTY},1,1,rad,1,step,1,ok\n1,implicit,1,,rad,,step,,not_implemented\n"))

    def read(self) -> Reader:
        text = page.write(self.kit.root, self.out).read_text(encoding="utf-8")
        reader = Reader(text)
        for file in reader.files:
            self.assertTrue((self.out / urllib.parse.unquote(file)).is_file(), file)
        self.assertEqual(reader.without_alt, 0)
        return reader

    def test_words_from_files_stay_words(self) -> None:
        film = self.add_film("student", {key: NASTY for key in (
            "title", "subtitle", "parameters", "measured")} | {"missing": [NASTY], "fps": NASTY})
        (film.parent / "film-command.txt").write_text(NASTY, encoding="utf-8")
        self.add_film("reference", {})
        self.add_chart("student")
        self.kit.write(f"labs/{LAB}/README.md", f"# Lab 1: {NASTY}\n")
        reader = self.read()
        self.assertEqual(reader.tags.count("script"), 1)
        self.assertGreaterEqual(reader.text.count("alert('1')"), 6)

    def test_every_frame_strip_and_chart_is_named(self) -> None:
        self.add_film("student", {"title": "Spin", "missing": ["1.3 net_wrench"]}, frames=2)
        self.add_film("reference", {"title": "Spin"}, frames=12)
        self.add_chart("reference")
        reader = self.read()
        self.assertEqual(len([file for file in set(reader.files) if "frame_" in file]), 14)
        self.assertTrue({f"{LAB}/{variant}/film/strip.png" for variant in ("student", "reference")}
                        <= set(reader.files))
        self.assertIn(f"{LAB}/reference/chart/chart.svg", reader.files)
        for words in ("Your answer", "Reference", "1.3 net_wrench",
                      "not written yet or broken: implicit",
                      "./tumble frames 1 --solution", "./tumble chart 1 --solution"):
            self.assertIn(words, reader.text)

    def test_all_charts_of_a_program_are_shown_in_its_order(self) -> None:
        for variant in ("student", "reference"):
            folder = f"out/{LAB}/{variant}/chart"
            self.kit.write(f"{folder}/charts.txt", "tumble\tA tumble\n" f"racket\t{NASTY}\n"
                           "ten_minutes\tTen minutes\nabsent\tAbsent\n../film/x\tAway\nnaked\n")
            for name in ("tumble", "racket", "ten_minutes", "naked"):
                self.kit.write(f"{folder}/{name}.png", "")
            self.kit.write(f"{folder}/ten_minutes.csv", (
                "lab,method,quantity,time,value,unit\n"
                "1,explicit,energy,0,1,J\n1,implicit,energy,,,J\n1,implicit,|L|,,,J\n"))
        reader = self.read()
        drawn = dict.fromkeys(file for file in reader.files if file.endswith(".png"))
        self.assertEqual(list(drawn), [
            f"{LAB}/{variant}/chart/{name}.png"
            for name in ("tumble", "racket", "ten_minutes", "naked")
            for variant in ("student", "reference")])
        self.assertEqual(reader.tags.count("h4"), 4)
        self.assertEqual(reader.tags.count("script"), 1)
        self.assertEqual(reader.text.count("not written yet or broken: implicit"), 2)
        self.assertEqual(reader.text.count("./tumble chart 1"), 2)

    def test_a_broken_film_json_costs_only_the_words(self) -> None:
        for told in ("", "{", "[]", '{"fps": 0, "from": -1, "missing": 3, "title": 7}',
                     '{"fps": 1e999}'):
            self.add_film("student", told)
            self.assertIn(f"{LAB}/student/film/frame_0002.png", self.read().files)

    def test_an_empty_folder_says_how_to_fill_it(self) -> None:
        self.out.mkdir()
        self.assertIn("./tumble frames 1", self.read().text)

    def test_nothing_on_the_page_comes_from_the_network(self) -> None:
        self.add_film("student", {})
        self.read()
        self.assertNotIn("://", (self.out / "index.html").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
