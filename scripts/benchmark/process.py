# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a program on one thread and measures the processor time it takes."""
import os
import statistics
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


@dataclass
class Finished:
    """A program that has ended: exit code, user time of it and its children (s), wall time (s), standard output."""

    code: int
    user: float
    wall: float
    text: str


def finish(command: list, folder: Path, limit: float) -> Finished:
    """Runs the command in the folder; one that takes longer than the limit (s of wall time) ends with code -9."""
    with open(folder / "output.txt", "w+", encoding="utf-8", errors="replace") as output:
        start = time.monotonic()
        process = subprocess.Popen([str(word) for word in command], cwd=folder, stdin=subprocess.DEVNULL, stdout=output,
                                   stderr=subprocess.STDOUT, env={**os.environ, **ONE_THREAD})
        usage = wait(process, start + limit)
        wall = time.monotonic() - start
        output.seek(0)
        return Finished(process.returncode, usage.ru_utime, wall, output.read())


def wait(process: subprocess.Popen, deadline: float):
    """Resource usage of the process, which is killed at the deadline."""
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid:
            process.returncode = os.waitstatus_to_exitcode(status)
            return usage
        if time.monotonic() > deadline:
            process.kill()
        time.sleep(0.005)


@dataclass
class Times:
    """User times of the repetitions of one run, s."""

    seconds: list = field(default_factory=list)

    @property
    def median(self) -> float:
        return statistics.median(self.seconds)

    @property
    def spread(self) -> float:
        """Largest minus smallest, relative to the median."""
        return (max(self.seconds) - min(self.seconds)) / self.median
