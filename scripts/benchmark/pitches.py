# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the length of an actuator and a second rank do to the cost of its path."""
import math
import os
import re
import tempfile
from dataclasses import dataclass
from pathlib import Path

from .process import Times, finish

STUDY = Path(__file__).with_suffix(".toml")
PITCHES = (5, 10, 20, 40)
STEPS = (1, 4)  # the iterations between these two steps are counted: what is done once drops out
LIMIT = 600  # s of wall time
MPIRUN = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}


@dataclass
class Followed:
    """A finished path: user and wall time (s), Newton iterations of all attempts."""

    user: float
    wall: float
    iterations: int


def iterations(log: str) -> int:
    """Newton iterations of all attempts: each line of the log ends with the residuals of one."""
    attempts = re.findall(r"^(?:step|cut) .*;(.*)$", log, re.MULTILINE)
    return sum(len(residuals.split()) - 1 for residuals in attempts)


def follow(program: Path, pitches: int, steps: int, ranks: int = 1) -> Followed:
    """Runs so many steps of the path."""
    with tempfile.TemporaryDirectory() as scratch:
        settings = {"actuator.ribs.count": pitches, "actuator.balloon.length": f"{4.5 * pitches} mm", "path.max_steps": steps}
        command = [program, "run", STUDY, "-o", "results"]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        os.environ.update(MPIRUN)
        launch = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
        end = finish(launch + command, Path(scratch), LIMIT)
        log = Path(scratch) / "results/evaluations/0001/log.txt"
        if not log.exists():
            raise RuntimeError(end.text)
        return Followed(end.user, end.wall, iterations(log.read_text(encoding="utf-8")))


def seconds_per_iteration(program: Path, repetitions: int) -> dict:
    """User time of one iteration by the number of pitches; the lengths take turns."""
    times = {pitches: Times() for pitches in PITCHES}
    for _ in range(repetitions):
        for pitches in PITCHES:
            first, last = (follow(program, pitches, steps) for steps in STEPS)
            times[pitches].seconds.append((last.user - first.user) / (last.iterations - first.iterations))
    return times


def exponent(times: dict) -> float:
    """Slope of the least-squares line through log(time) over log(pitches)."""
    points = [(math.log(pitches), math.log(time.median)) for pitches, time in times.items()]
    mean = [sum(axis) / len(points) for axis in zip(*points)]
    return (sum((x - mean[0]) * (y - mean[1]) for x, y in points) / sum((x - mean[0]) ** 2 for x, _ in points))


def second_rank(program: Path, repetitions: int) -> tuple:
    """Wall times of a path of 20 pitches on one and on two ranks, in turns."""
    one, two = Times(), Times()
    for _ in range(repetitions):
        one.seconds.append(follow(program, 20, STEPS[1]).wall)
        two.seconds.append(follow(program, 20, STEPS[1], 2).wall)
    return one, two
