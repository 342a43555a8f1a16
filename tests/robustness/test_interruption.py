# SPDX-License-Identifier: LGPL-2.1-or-later
"""A path killed at random moments ends as one that was left alone.

The program is that of the environment variable BALLONET. Three more choose what is interrupted, for longer runs by hand:
STUDY (a study file), SETTINGS (KEY=VALUE, separated by semicolons), INTERRUPTIONS (their number).
"""
import csv
import os
import random
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
BALLONET = os.environ.get("BALLONET", str(SOURCE / "build/studies/ballonet"))
STUDY = os.environ.get("STUDY", str(SOURCE / "studies/balloon_alone/study.toml"))
SMALL = "mesh.balloon_around=8;mesh.balloon_per_pitch=2;actuator.balloon.length=24 mm;path.step_max=0.05 s"
SETTINGS = os.environ.get("SETTINGS", SMALL).split(";")
INTERRUPTIONS = int(os.environ.get("INTERRUPTIONS", "4"))
COUNTERS = {"newton_iterations", "factorisations", "cuts"}  # of attempts, which a killed one has made in vain
TOLERANCE = 1e-8


def start(directory: Path, *more: str) -> subprocess.Popen:
    settings = [word for setting in SETTINGS for word in ("--set", setting)]
    command = [BALLONET, "run", STUDY, "-o", str(directory), *settings, "--set", "path.checkpoint_every=1", *more]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)


def finish(process: subprocess.Popen) -> None:
    text, _ = process.communicate()
    if process.returncode != 0:
        raise AssertionError(f"exit code {process.returncode}: {text}")


def rows(directory: Path) -> list:
    with open(directory / "evaluations/0001/history.csv") as file:
        return list(csv.DictReader(file))


def differences(row: dict, other: dict) -> list:
    """Columns of two rows that differ by more than the tolerance of their own size."""
    def differ(a: str, b: str) -> bool:
        try:
            return abs(float(a) - float(b)) > TOLERANCE * max(1.0, abs(float(a)))
        except ValueError:
            return a != b
    return [key for key in row if key not in COUNTERS and differ(row[key], other[key])]


class Interruption(unittest.TestCase):
    def test_a_killed_path_ends_as_one_left_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            whole, killed = Path(folder, "whole"), Path(folder, "killed")
            began = time.monotonic()
            finish(start(whole))
            seconds = time.monotonic() - began
            kills = self.interrupt(killed, seconds)
            finish(start(killed, "--resume") if killed.exists() else start(killed))
            self.compare(rows(whole), rows(killed))
            print(f"killed {kills} times; {len(rows(whole))} steps, {seconds:.1f} s without")

    def interrupt(self, directory: Path, seconds: float) -> int:
        moment = random.Random(1)
        kills = 0
        for _ in range(INTERRUPTIONS):
            process = start(directory, *(["--resume"] if directory.exists() else []))
            time.sleep(moment.uniform(0.1, 1.5) * max(seconds / INTERRUPTIONS, 1))
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
                kills += 1
            process.communicate()
        self.assertGreater(kills, 0, "every run was over before it could be killed")
        return kills

    def compare(self, whole: list, killed: list) -> None:
        self.assertEqual(len(whole), len(killed))
        for row, other in zip(whole, killed):
            self.assertEqual(differences(row, other), [], f"step {row['step']}")


if __name__ == "__main__":
    unittest.main()
