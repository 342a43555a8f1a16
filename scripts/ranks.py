#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints how many MPI ranks a study can use on this machine: scripts/ranks.py STUDY.toml

One simulation gains little beyond four ranks (the factorisation dominates); many simulations can use every core.
A file that cannot be read counts as one rank: the program itself says what is wrong with it.
"""
import os
import sys
import tomllib

RANKS_OF_ONE_SIMULATION = 4


def usable_ranks(study: dict) -> int:
    """The largest number of ranks that are of use to the study."""
    method = study.get("method", {})
    if method.get("kind", "solve") == "solve":
        return study.get("parallel", {}).get("ranks_per_evaluation", RANKS_OF_ONE_SIMULATION)
    return sys.maxsize


def main() -> None:
    try:
        with open(sys.argv[1], "rb") as file:
            usable = usable_ranks(tomllib.load(file))
    except (OSError, ValueError, AttributeError):
        usable = 1
    print(max(1, min(len(os.sched_getaffinity(0)), usable)))


if __name__ == "__main__":
    main()
