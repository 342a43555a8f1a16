# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts/bench concludes from measured times, on made-up ones."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from benchmark import page, pitches
from benchmark.process import Times, finish
from benchmark.programs import PROBLEMS, Run, read_status


def run(label: str, nodes: int, error: float, seconds: float) -> Run:
    return Run(label, nodes, nodes=nodes, error=error, times=Times([seconds]))


class Conclusions(unittest.TestCase):
    def test_same_mesh_takes_the_fastest_rival_that_is_as_accurate(self):
        own, runs = run("Ballonet", 8, 1e-3, 1), [run("a", 8, 1e-2, 2), run("b", 8, 1e-3, 12), run("c", 8, 1e-4, 20)]
        self.assertIn("**12.0** times less user time than b", page.same_mesh(PROBLEMS[0], own, runs))
        self.assertIn("aim: 10, met", page.same_mesh(PROBLEMS[0], own, runs))

    def test_without_such_a_rival_the_most_accurate_one_counts(self):
        own, runs = run("Ballonet", 8, 1e-5, 1), [run("a", 8, 1e-2, 2), run("b", 8, 1e-3, 4)]
        self.assertIn("**4.0** times less user time than b", page.same_mesh(PROBLEMS[0], own, runs))
        self.assertIn("**missed**", page.same_mesh(PROBLEMS[0], own, runs))

    def test_equal_error_is_the_smallest_both_reach(self):
        own, runs = [run("Ballonet", 8, 1e-4, 3), run("Ballonet", 4, 1e-2, 1)], [run("a", 8, 1e-2, 5), run("b", 4, 1e-1, 2)]
        self.assertIn("Ballonet 1.00 s on 4 nodes, a 5.00 s on 8 nodes, **5.0** times as long", page.equal_error(own, runs))

    def test_failed_runs_are_shown_and_not_compared(self):
        failed = Run("a", 8, failure="too many cutbacks")
        self.assertIn("too many cutbacks", page.run_row(failed, run("Ballonet", 8, 1e-3, 1)))
        self.assertIn("No comparison", page.same_mesh(PROBLEMS[0], run("Ballonet", 8, 1e-3, 1), [failed]))


class Readings(unittest.TestCase):
    def test_exponent_of_a_power_law(self):
        self.assertAlmostEqual(pitches.exponent({n: Times([0.1 * n**1.3]) for n in (5, 10, 20)}), 1.3)

    def test_iterations_of_all_attempts(self):
        log = "step 1  dt 1 s  negative pivots 0; 1 2 3\ncut  dt 2 s: too long; 1 2\nend of the path: done\n"
        self.assertEqual(pitches.iterations(log), 3)

    def test_status_file_of_calculix(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "a.sta"
            file.write_text("SUMMARY OF JOB INFORMATION\n  STEP INC ATT ITRS TOT STEP INC\n 1 1 1U 4 0 0 0.5\n 1 1 2 5 0.1 0.1 0.1\n 1 2 1 6 1 1 0.9\n")
            self.assertEqual(read_status(file), (2, 15))

    def test_user_time_and_exit_code(self):
        with tempfile.TemporaryDirectory() as folder:
            busy = finish([sys.executable, "-c", "sum(range(3000000)); print(7); raise SystemExit(3)"], Path(folder), 60)
        self.assertEqual((busy.code, busy.text), (3, "7\n"))
        self.assertGreater(busy.user, 0)

    def test_a_run_beyond_its_limit_is_killed(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(finish(["sleep", "60"], Path(folder), 0.1).code, -9)


if __name__ == "__main__":
    unittest.main()
