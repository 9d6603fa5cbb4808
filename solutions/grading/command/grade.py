"""./tumble grade DIR: a folder of submissions in, results, a page a student and a class out."""

from __future__ import annotations

import argparse
import os
import signal
import time
from pathlib import Path
from typing import Sequence

from .console import BAD_USAGE, FAILED, Failure, say
from .labs import Lab, printable

_WARNING = ("No secret was given (--secret FILE or TUMBLE_SECRET), so a random one is kept in {}. "
            "Keep that folder from students, and use the same secret each time you grade.")


def run(root: Path, options: argparse.Namespace) -> int:
    from .grading import points
    labs = _chosen(points.graded_labs(root), options.labs)
    folder = _folder(options)
    out = Path(options.out) if options.out else folder.with_name(f"{folder.name}-graded")
    _require_apart(folder, out)
    return _run(root, options, labs, folder, out.absolute())


def _run(root: Path, options: argparse.Namespace, labs: Sequence[Lab], folder: Path,
         out: Path) -> int:
    from .grading import batch, intake, seeds, summary
    from .grading.sandbox import Sandbox
    submissions = [] if options.check else _shard(intake.submissions(folder), options.shard)
    sandbox = Sandbox.find(options.no_sandbox)
    _prepare(out)
    secret = seeds.course_secret(options.secret, out, os.environ)
    if not seeds.is_given(options.secret, os.environ):
        say(_WARNING.format(out / seeds.OWN_SECRET))
    boxed = "no sandbox" if options.no_sandbox else "sandbox"
    exams = [batch.make_exam(root, lab, secret, boxed) for lab in labs]
    setting = batch.Setting(root, out, exams, sandbox, options.resume)
    batch.prove(setting)
    say("The reference has every point and the untouched stub none, in lab"
        f"{'s' if len(labs) > 1 else ''} {', '.join(str(lab.number) for lab in labs)}.")
    if options.check:
        return 0
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # a cluster's way to interrupt
    begun = time.monotonic()
    failed = batch.grade_class(setting, submissions, options.jobs)
    summary.write_summary(out, labs)
    say(f"{len(submissions)} submissions in {time.monotonic() - begun:.0f} s: "
        f"{out / 'index.html'}, {out / 'class.csv'}")
    if failed:
        raise Failure(f"the grader failed on {len(failed)} of them: {', '.join(failed[:10])} "
                      "(see the remarks in class.csv; --resume tries these again)", FAILED)
    return 0


def _folder(options: argparse.Namespace) -> Path:
    if options.check != (options.folder is None):
        raise Failure("give a folder of submissions, or --check and no folder", BAD_USAGE)
    if options.check and not options.out:
        raise Failure("--check needs --out DIR, the folder for secret and results", BAD_USAGE)
    if options.folder == "":
        raise Failure("the folder's name is empty", BAD_USAGE)
    return Path(options.folder or options.out).absolute()


def _require_apart(folder: Path, out: Path) -> None:
    """Results among the submissions would be graded as a student the next time."""
    if folder.resolve() in out.resolve().parents:
        raise Failure(f"--out {out} is inside the folder of submissions: choose another", BAD_USAGE)


def _chosen(labs: Sequence[Lab], numbers: str | None) -> list[Lab]:
    if not labs:
        raise Failure("no lab has a table of points, solutions/N_name/points.json", BAD_USAGE)
    if numbers is None:
        return list(labs)
    known = {str(lab.number): lab for lab in labs}
    chosen = []
    for number in numbers.split(","):
        if number not in known:
            raise Failure(f"--labs: {printable(number)} has no table of points; these have one: "
                          f"{', '.join(known)}", BAD_USAGE)
        chosen.append(known[number])
    return sorted(set(chosen))


def _shard(submissions: list, shard: tuple[int, int]) -> list:
    """Every n-th, so that shards are alike whatever the names."""
    number, count = shard
    return submissions[number - 1::count]


def _prepare(out: Path) -> None:
    try:
        out.mkdir(parents=True, exist_ok=True)
        trial = out / f".trial-{os.getpid()}"
        trial.touch()
        trial.unlink()
    except OSError as error:
        raise Failure(f"cannot write to {out}: {error.strerror}") from error
