"""The commands and their arguments. A command's module is imported only when it runs."""

from __future__ import annotations

import argparse
import importlib
import os
import re
import sys
from pathlib import Path
from typing import Callable, NoReturn, Sequence

from .console import BAD_USAGE, FAILED, Failure
from .labs import is_handout, printable, require_solutions

ROOT = Path(__file__).resolve().parents[3]

_OF_THE_KIT = ("verify", "handout", "grade")  # not of a hand-out

_SIZE = re.compile(r"([0-9]{1,5})x([0-9]{1,5})")


class Parser(argparse.ArgumentParser):
    """argparse, with one line for what is wrong."""

    def error(self, message: str) -> NoReturn:
        message = re.sub(r"^argument ([A-Z]\S*|--\S+): ", r"\1: ", " ".join(message.split()))
        raise Failure(f"{message} (see ./{self.prog} --help)", BAD_USAGE)


def number_in(low: float, high: float, what: str, above_low: bool = False) -> Callable[[str], str]:
    """Checks a number and keeps it as typed, so that nothing is lost on the way to the program."""

    def check(text: str) -> str:
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not (low < value <= high if above_low else low <= value <= high):
            raise argparse.ArgumentTypeError(f"{printable(text)} is not {what}")
        return text

    return check


def size(text: str) -> str:
    match = _SIZE.fullmatch(text)
    if not match or not all(16 <= int(side) <= 8192 for side in match.groups()):
        raise argparse.ArgumentTypeError(
            f"{printable(text)} is not a size: give WIDTHxHEIGHT, sides from 16 to 8192")
    return text


def count(text: str) -> int:
    if not re.fullmatch(r"[1-9][0-9]{0,3}", text):
        raise argparse.ArgumentTypeError(f"{printable(text)} is not a number from 1 to 9999")
    return int(text)


def shard(text: str) -> tuple[int, int]:
    parts = re.fullmatch(r"([1-9][0-9]{0,4})/([1-9][0-9]{0,4})", text)
    if not parts or int(parts.group(1)) > int(parts.group(2)):
        raise argparse.ArgumentTypeError(f"{printable(text)} is not a part: give i/n as in 3/8")
    return int(parts.group(1)), int(parts.group(2))


def make_parser() -> argparse.ArgumentParser:
    parser = Parser(prog="tumble", allow_abbrev=False, description=(
        "Tumble: labs on rigid bodies and collisions. Exit codes: 0 success, 1 failure, 2 bad "
        "usage, 3 the grader failed its own check, so nobody was graded."))
    commands = parser.add_subparsers(metavar="COMMAND", required=True, parser_class=Parser)

    def command(name: str, module: str, text: str) -> argparse.ArgumentParser:
        description = text[0].upper() + text[1:] + "."
        shown = {} if name in _OF_THE_KIT and is_handout(ROOT) else {"help": text}
        new = commands.add_parser(name, description=description, allow_abbrev=False, **shown)
        new.set_defaults(module=module, command=name)
        return new

    def lab_command(name: str, module: str, text: str) -> argparse.ArgumentParser:
        new = command(name, module, text)
        new.add_argument("lab", metavar="N", help="number of the lab")
        return new

    for name, text in (
            ("demo", "install missing packages, build, draw every reference scene and chart"),
            ("verify", "install missing packages, then check the kit and its tests")):
        new = command(name, name, text)
        new.add_argument("--no-install", action="store_true", help="install no packages")
        if name == "verify":
            new.add_argument("--all", action="store_true", help=(
                "also run the slow checks: attacks on the grader, its judge, a class, other "
                "seeds, Slurm, sanitizers"))
    _add_test(lab_command("test", "checklist", "test your answer to lab N and print a checklist"))
    lab_command("watch", "watch", "run lab N's tests again whenever you save; Ctrl-C ends it")
    _add_hint(command("hint", "hints", "show a step's next hint: idea, formula, line of code"))
    _add_frames(lab_command("frames", "pictures", "draw lab N's scene: frames and film strip"))
    _add_chart(lab_command("chart", "pictures", "measure lab N's methods: error against time"))
    command("doctor", "doctor", "list what is installed, and how to get what is missing")
    command("handout", "handout", "pack the files that students get").add_argument(
        "file", metavar="FILE.tar.gz")
    _add_grade(command("grade", "grade", "grade a folder of submissions"))
    return parser


def _add_grade(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("folder", metavar="DIR", nargs="?",
                        help="holds one folder or archive (zip, tar) for each student")
    parser.add_argument("--labs", metavar="N,N", help="the labs to grade (default: all)")
    parser.add_argument("--out", metavar="OUT", help="folder for results (default: DIR-graded)")
    parser.add_argument("--jobs", metavar="J", type=count, default=os.cpu_count() or 1,
                        help="grade J submissions at a time (default: one per processor)")
    parser.add_argument("--shard", metavar="i/n", type=shard, default=(1, 1), help="part i of n")
    parser.add_argument("--resume", action="store_true", help="keep results that are still valid")
    parser.add_argument("--secret", metavar="FILE", help=(
        "secret of the course; it seeds hidden inputs (default: the file TUMBLE_SECRET names)"))
    parser.add_argument("--check", action="store_true", help="grade only reference and stub")
    parser.add_argument("--no-sandbox", action="store_true", help="unprotected; results say so")


def _add_test(parser: argparse.ArgumentParser) -> None:
    _add_answers(parser, "test this correct answer of the kit, or several in turn")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--all", action="store_true", help="explain every failure")
    which.add_argument("--case", metavar="WORDS", help=(
        "run the one case whose title contains these words, and show what your code prints"))
    parser.add_argument("--debug", action="store_true",
                        help="with --case: run in gdb, and stop where your code is first called")


def _add_answers(parser: argparse.ArgumentParser, text: str) -> None:
    hidden = argparse.SUPPRESS if is_handout(ROOT) else None
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--answer", metavar="NAME[,NAME]", help=hidden or text)
    which.add_argument("--solution", dest="answer", action="store_const", const="reference",
                       help=hidden or "short for --answer reference")


def _add_hint(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("step", metavar="N.S", help="lab and step, as in 1.2")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--again", action="store_true", help="show the same hints, no new one")
    which.add_argument("--reset", action="store_true", help="hide the hints again")


def _add_pictures(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--mesh", metavar="FILE.obj", action="append", default=[],
                        help="lab 5 only: your own mesh; give one or two")
    _add_answers(parser, "draw this correct answer of the kit; if you name several, the first is "
                 "drawn in full and the others beside it")
    parser.add_argument("--out", metavar="DIR", help="folder for pictures (default: Tumble's out/)")


def _add_chart(parser: argparse.ArgumentParser) -> None:
    _add_pictures(parser)
    parser.add_argument("--peers", action="store_true", help=(
        "also measure other engines, if you have installed them (no command does it): lab 2 "
        "libbullet-dev, libode-dev; lab 5 libfcl-dev, libembree-dev, libcgal-dev"))


def _add_frames(parser: argparse.ArgumentParser) -> None:
    _add_pictures(parser)
    moment = number_in(0.0, 1e6, "a time in seconds, zero or more")
    parser.add_argument("--size", metavar="WxH", type=size, help="frame size (default 1280x720)")
    rate = number_in(0.0, 240.0, "a number above 0 and up to 240", above_low=True)
    parser.add_argument("--fps", metavar="F", type=rate, help="frames per second (default 25)")
    parser.add_argument("--from", metavar="S", dest="start", type=moment, help="first time [s]")
    parser.add_argument("--to", metavar="S", dest="end", type=moment, help="last time [s]")
    parser.add_argument("--quality", choices=("draft", "film", "report"), help="default: film")
    parser.add_argument("--gif", action="store_true", help="also write film.gif (needs ffmpeg)")
    parser.add_argument("--mp4", action="store_true", help="also write film.mp4 (needs ffmpeg)")
    parser.add_argument("--white", action="store_true", help="pure white background, for print")


def main(arguments: Sequence[str]) -> int:
    """Runs the command; whatever goes wrong becomes a line and an exit code, no traceback."""
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="replace")  # type: ignore[union-attr]
    code = FAILED
    try:
        options = make_parser().parse_args(arguments)
        if options.command in _OF_THE_KIT:
            require_solutions(ROOT, options.command)
        code = importlib.import_module(f"tumble.{options.module}").run(ROOT, options)
        sys.stdout.flush()
    except SystemExit as end:  # argparse: --help
        code = int(end.code or 0)
    except Failure as failure:
        sys.stdout.flush()
        print(failure, file=sys.stderr)
        code = failure.code
    except KeyboardInterrupt:
        print("tumble: stopped", file=sys.stderr)
        code = 130  # as a shell tells it
    except BrokenPipeError:  # the reader, such as head, has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        where = f": {error.filename}" if error.filename else ""
        print(f"tumble: {error.strerror or error}{where}", file=sys.stderr)
    return code
