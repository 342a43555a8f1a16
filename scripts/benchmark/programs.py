# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ballonet and CalculiX on the same problems: user time, error and iterations of each, in turns."""
import json
from dataclasses import dataclass, field
from pathlib import Path

from .process import Times, finish

LIMIT = 300  # s of wall time


@dataclass(frozen=True)
class Problem:
    """A case of tests/benchmark, its mesh, coarser meshes, and how CalculiX is asked to solve it."""

    name: str
    title: str
    cells: int  # see tests/benchmark/benchmark_case.h
    coarser: tuple
    choices: tuple  # element type, bulk over shear modulus (0: the problem's own)
    aim: float  # how many times less user time than CalculiX


# Rubber of the walls is incompressible. CalculiX has no hybrid elements: the larger its bulk modulus, the smaller the error and the
# smaller the steps. Cook's membrane has a bulk modulus of its own.
WALL = (("C3D20R", 1e3), ("C3D20R", 1e5), ("C3D20", 1e3))
SOLID = (("C3D20R", 0), ("C3D20", 0))
PROBLEMS = (
    Problem("sphere", "thick sphere", 4, (3, 2, 1), WALL, 10),
    Problem("tube", "thick tube", 8, (4, 2, 1), WALL, 5),
    Problem("cook", "Cook's membrane", 16, (8, 4, 2), SOLID, 5),
    Problem("cantilever", "cantilever", 160, (80, 40, 20, 10), SOLID, 5),
)


@dataclass
class Run:
    """One program with one choice of its own on one mesh."""

    label: str
    cells: int
    nodes: int = 0
    steps: int = 0
    iterations: int = 0
    error: float = float("nan")
    times: Times = field(default_factory=Times)
    failure: str = ""

    @property
    def ok(self) -> bool:
        return not self.failure


class Programs:
    """The two programs, working in a scratch folder."""

    def __init__(self, bench: Path, ccx: str, folder: Path):
        self.bench, self.ccx, self.folder = bench, ccx, folder

    def ask(self, *words) -> str:
        """What `bench` says; an error of it is an error here."""
        answer = finish([self.bench, *words], self.folder, LIMIT)
        if answer.code:
            raise RuntimeError(answer.text)
        return answer.text

    def error(self, problem: Problem, cells: int, file: str) -> float:
        return abs(float(self.ask("error", problem.name, cells, file)))

    def start_up(self) -> float:
        """User time of `bench` when it has nothing to do, s."""
        return finish([self.bench], self.folder, LIMIT).user

    def ballonet(self, problem: Problem, run: Run) -> None:
        """Solves once more."""
        answer = finish([self.bench, "solve", problem.name, run.cells, "ballonet.txt"], self.folder, LIMIT)
        if answer.code:
            run.failure = answer.text.strip().splitlines()[-1]
            return
        said = json.loads(answer.text.splitlines()[-1])
        run.nodes, run.steps, run.iterations = said["nodes"], said["steps"], said["iterations"]
        run.times.seconds.append(answer.user)
        run.error = self.error(problem, run.cells, "ballonet.txt")

    def calculix(self, problem: Problem, choice: tuple, run: Run) -> None:
        """Solves once more."""
        run.nodes = int(self.ask("write", problem.name, run.cells, "calculix.inp", *choice).split()[-1])
        (self.folder / "calculix.dat").unlink(missing_ok=True)
        answer = finish([self.ccx, "-i", "calculix"], self.folder, LIMIT)
        if answer.code or "Job finished" not in answer.text:
            errors = [line.strip() for line in answer.text.splitlines() if "*ERROR" in line]
            run.failure = errors[0] if errors else f"ended with code {answer.code} after {answer.wall:.0f} s"
            return
        run.steps, run.iterations = read_status(self.folder / "calculix.sta")
        run.times.seconds.append(answer.user)
        run.error = self.error(problem, run.cells, "calculix.dat")


def read_status(file: Path) -> tuple:
    """Increments and iterations, rejected attempts included, of CalculiX's status file."""
    steps = iterations = 0
    for line in file.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if len(words) == 7 and words[0].isdigit():
            steps, iterations = int(words[1]), iterations + int(words[3])
    return steps, iterations


def label(choice: tuple) -> str:
    element, bulk = choice
    return f"CalculiX {element}" + (f", κ/μ = {bulk:.0e}".replace("e+0", "e") if bulk else "")


def measure(programs: Programs, problem: Problem, repetitions: int) -> tuple:
    """Ballonet's runs and CalculiX's, the finest mesh first; all take turns."""
    meshes = (problem.cells, *problem.coarser)
    own = [Run("Ballonet", cells) for cells in meshes]
    other = [(choice, Run(label(choice), cells)) for cells in meshes for choice in problem.choices]
    for _ in range(repetitions):
        for run in own:
            if run.ok:
                programs.ballonet(problem, run)
        for choice, run in other:
            if run.ok:
                programs.calculix(problem, choice, run)
    return own, [run for _, run in other]
