#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks the layers of the source tree: who may include what, and which words and file names are kept out.

Usage: check_layers.py [ROOT]        exit 1 and one line per violation (file:line: reason)
       check_layers.py --self-test   plants every kind of violation and looks whether it is found
"""

import re
import sys
import tempfile
from pathlib import Path

FOLDERS = ["geometry", "solver/reduced", "solver", "optimize", "studies"]

# Project folders whose headers a folder may include.
ARROWS = {
    "geometry": {"geometry"},
    "solver/reduced": {"solver/reduced"},
    "solver": {"solver"},
    "optimize": {"optimize"},
    "studies": {"studies", "geometry", "solver", "solver/reduced", "optimize"},
}

# Libraries by the look of their headers, and the folders that may include them.
LIBRARIES = [
    ("gmsh", re.compile(r"gmsh\.h"), {"geometry"}),
    ("deal.II", re.compile(r"deal\.II/"), {"solver", "studies"}),
    ("PETSc", re.compile(r"petsc\w*\.h"), {"solver"}),
    ("SLEPc", re.compile(r"slepc\w*\.h"), {"solver"}),
    ("HDF5", re.compile(r"(hdf5|H5\w+)\.h"), {"solver"}),
    ("MPI", re.compile(r"mpi\.h"), {"solver", "studies"}),
    ("NLopt", re.compile(r"nlopt\.(hpp|h)"), {"optimize"}),
    ("toml++", re.compile(r"toml\+\+/"), {"studies"}),
    ("CLI11", re.compile(r"CLI/"), {"studies"}),
    ("nlohmann-json", re.compile(r"nlohmann/"), {"studies"}),
    ("udunits2", re.compile(r"udunits2"), {"studies"}),
]

# Headers that only one file may include.
SINGLE_PLACES = {"petscsnes.h": "solver/snes_iteration.h", "nlopt.hpp": "optimize/optimizer.cc"}

MAINS = {"studies/main.cc"}
STANDARD = re.compile(r"[a-z0-9_]+$")  # <vector>, <cmath>: no suffix, no folder
SYSTEM = re.compile(r"(unistd|fcntl|spawn|sys/\w+)\.h$")
FORBIDDEN_NAME = re.compile(r"^(util|helper|common|misc|manager)", re.IGNORECASE)
# Whole words, and words inside snake_case and CamelCase names.
FORBIDDEN_WORD = re.compile(r"((?<![A-Za-z])(?:rib|balloon|design)s?(?![a-z])|(?:Rib|Balloon|Design)s?(?![a-z]))")
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path):
    """The layer a path (relative, with slashes) belongs to, or None."""
    return next((folder for folder in FOLDERS if path.startswith(folder + "/")), None)


def check_library(folder, header):
    for name, pattern, allowed in LIBRARIES:
        if pattern.match(header):
            return None if folder in allowed else f"{folder} may not include {name} ({header})"
    if STANDARD.match(header) or SYSTEM.match(header):
        return None
    return f"{folder} may not include the unknown header {header}"


def check_include(path, bracket, header):
    """Reason why a file may not include a header, or None."""
    folder = folder_of(path)
    place = SINGLE_PLACES.get(header)
    if place and path != place:
        return f"{header} belongs to {place} only"
    if bracket == "<":
        return check_library(folder, header)
    target = folder_of(header)
    if target is None:
        return f"{header} is not a path of the project from its root"
    return None if target in ARROWS[folder] else f"{folder} may not include {target} ({header})"


def check_line(path, line):
    include = INCLUDE.match(line)
    if include:
        reason = check_include(path, *include.groups())
        if reason:
            yield reason
    if "MPI_COMM_WORLD" in line and path not in MAINS:
        yield "MPI_COMM_WORLD belongs to main programs only; take a communicator"
    if folder_of(path) == "solver":
        for word in FORBIDDEN_WORD.findall(re.sub(r"ballonet", "", line)):
            yield f"the solver does not know the word {word}"


def violations(root):
    """All violations below root as lines of text."""
    files = {file for folder in FOLDERS for ending in ("*.h", "*.cc") for file in (root / folder).rglob(ending)}
    for file in sorted(files):
        path = file.relative_to(root).as_posix()
        if FORBIDDEN_NAME.match(file.stem):
            yield f"{path}:1: a file name that says nothing"
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            for reason in check_line(path, line):
                yield f"{path}:{number}: {reason}"


PLANTED = [
    ("geometry/a.h", "#include <deal.II/base/point.h>"),
    ("geometry/a.h", '#include "solver/mesh.h"'),
    ("solver/a.h", '#include "geometry/mesh.h"'),
    ("solver/a.h", '#include "solver/reduced/hinge.h"'),
    ("solver/a.cc", "#include <gmsh.h>"),
    ("solver/a.cc", "#include <petscsnes.h>"),
    ("solver/a.cc", "const int n_ribs = 20;"),
    ("solver/a.cc", "class RibPattern;"),
    ("solver/a.cc", "// the balloon"),
    ("solver/a.cc", "auto c = MPI_COMM_WORLD;"),
    ("solver/reduced/a.cc", "#include <mpi.h>"),
    ("optimize/a.cc", "#include <nlopt.hpp>"),
    ("optimize/a.cc", '#include "studies/study.h"'),
    ("studies/a.cc", "#include <petscmat.h>"),
    ("studies/a.cc", "#include <nlopt.hpp>"),
    ("studies/a.cc", '#include "study.h"'),
    ("geometry/helpers.h", "// nothing"),
]

ALLOWED = [
    ("geometry/a.cc", "#include <gmsh.h>"),
    ("solver/snes_iteration.h", "#include <petscsnes.h>"),
    ("solver/reduced/a.cc", "// a balloon behind a rib"),
    ("solver/a.h", "namespace ballonet::solver // describe contributions"),
    ("optimize/optimizer.cc", "#include <nlopt.hpp>"),
    ("studies/a.cc", '#include "solver/mesh.h"'),
    ("studies/main.cc", "run(MPI_COMM_WORLD);"),
]


def found_in(path, line):
    """Violations of a tree that holds one file with one line."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / path
        file.parent.mkdir(parents=True)
        file.write_text("\n" + line + "\n", encoding="utf-8")
        return list(violations(Path(folder)))


def self_test():
    missed = [f"not found: {path}: {line}" for path, line in PLANTED if not found_in(path, line)]
    wrong = [f"wrongly found: {path}: {line}" for path, line in ALLOWED if found_in(path, line)]
    return missed + wrong


def main(arguments):
    if arguments == ["--self-test"]:
        problems = self_test()
    else:
        problems = list(violations(Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent))
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
