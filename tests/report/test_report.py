# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report: what it shows of a whole results directory, and that it says what a broken one lacks.

Run with: /usr/bin/python3 -m unittest discover -s tests/report
"""
import base64
import json
import re
import shutil
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

import h5py
import numpy as np

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "scripts")]

from report import events, loop, models, picture, surface, units, viewer  # noqa: E402  (after the search path)
from report.answer import headline  # noqa: E402
from report.curves import path_axis  # noqa: E402
from report.data import read_results  # noqa: E402
from report.history import History, marked, read_history  # noqa: E402
from report.page import page  # noqa: E402
from synthetic_results import STEPS, grid_faces, write_results  # noqa: E402

VOID = {"meta", "img", "input", "br", "link"}


class Nesting(HTMLParser):
    """Collects elements that are closed in the wrong order or not at all."""

    def __init__(self):
        super().__init__()
        self.open, self.wrong = [], []

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append(tag)


class WithResults(unittest.TestCase):
    """A fresh invented results directory for every test."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = write_results(Path(temporary.name) / "invented")

    def page(self) -> str:
        return page(read_results(self.folder))


class WholePage(unittest.TestCase):
    """Made once: the tests only read it."""

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.results = read_results(write_results(Path(folder) / "invented"))
            cls.text = page(cls.results)

    def page(self) -> str:
        return self.text

    def test_shows_every_section_that_has_data(self):
        text = self.page()
        for anchor in ("shape", "curve", "path", "gaps", "expansion", "stress", "force", "loop", "all"):
            self.assertIn(f'<section id="{anchor}">', text)
        self.assertEqual(text.count("<img "), 10)

    def test_the_answer_comes_first_and_the_full_table_last(self):
        text = self.page()
        self.assertIn("Best: evaluation 5 with angle 40kPa 200, the largest found.", text)
        self.assertIn("<td>limit pressure 1</td><td>36.98 kPa</td>", text)
        places = [text.index(words) for words in ("Best: evaluation", "<nav>", 'id="shape"', 'id="loop"',
                                                  'id="reproduce"', "<summary>All 2 numbers")]
        self.assertEqual(places, sorted(places))

    def test_needs_no_other_file(self):
        text = self.page()
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:|#)', text), [])
        self.assertNotRegex(text, r"https?://(?!www\.w3\.org)")

    def test_is_well_formed(self):
        nesting = Nesting()
        nesting.feed(self.page())
        self.assertEqual((nesting.wrong, nesting.open), ([], []))

    def test_headline_names_best_design_with_unit(self):
        self.assertRegex(self.page(), r"actuator\.balloon\.diameter</td><td class=\"number\">7\.25</td><td>mm")

    def test_marks_the_best_and_the_failed(self):
        self.assertRegex(self.page(), '<tr class="best"><td>5</td>')
        self.assertRegex(self.page(), '<tr class="failed"><td>3</td>')
        self.assertEqual(self.page().count('<tr class="best">'), 1)

    def test_words_of_the_user_are_escaped(self):
        text = self.page()
        self.assertIn("invented &lt;arm&gt;", text)
        self.assertIn("&amp; &lt;less&gt;", text)
        self.assertNotIn("<arm>", text)

    def test_counts_iterations_and_cuts(self):
        cuts = int(self.results.best.history.numbers["cuts"].sum())
        self.assertIn(f"<td>Newton iterations</td><td>{6 * STEPS}</td>", self.page())
        self.assertIn(f"<td>cut steps</td><td>{cuts}</td>", self.page())


class MissingData(WithResults):
    def test_empty_directory_gives_a_page(self):
        empty = self.folder / "empty"
        empty.mkdir()
        text = page(read_results(empty))
        self.assertIn("no readable summary.json", text)
        self.assertIn("the journal holds no evaluation", text)
        self.assertNotIn("<img ", text)

    def test_every_file_may_be_missing(self):
        for name in ("evaluations/0005/history.h5", "evaluations/0005/history.csv", "summary.json", "resolved.toml",
                     "journal.jsonl"):
            (self.folder / name).unlink()
            with self.subTest(missing=name):
                self.assertIn("</html>", self.page())

    def test_missing_columns_are_named(self):
        path = self.folder / "evaluations" / "0005" / "history.csv"
        path.write_text("step,control,r_rib\n0,0,0\n1,0.5,2\n2,1,3\n")
        text = self.page()
        self.assertIn("no numbers in pressure_kPa, bending_angle_deg", text)
        (self.folder / "resolved.toml").write_text('[[response]]\nname = "r_rib"\n')
        self.assertIn('<section id="responses">', self.page())

    def test_torn_files_are_read_as_far_as_they_go(self):
        with open(self.folder / "journal.jsonl", "a") as file:
            file.write('{"id": 9, "hash": "0')
        history = self.folder / "evaluations" / "0005" / "history.csv"
        history.write_text(history.read_text()[:-30])
        (self.folder / "evaluations" / "0005" / "history.h5").write_bytes(b"\x89HDF")
        results = read_results(self.folder)
        self.assertEqual((len(results.evaluations), results.unreadable_lines), (8, 1))
        self.assertEqual(len(results.best.history), STEPS - 1)
        self.assertIn("no readable history.h5", self.page())

    def test_an_unfinished_evaluation_is_listed(self):
        (self.folder / "evaluations" / "0009").mkdir()
        self.assertIn("<td>9</td><td>unfinished</td>", self.page())

    def test_without_a_best_the_last_that_worked_is_shown(self):
        summary = json.loads((self.folder / "summary.json").read_text())
        (self.folder / "summary.json").write_text(json.dumps(summary | {"best": None, "objective": None}))
        self.assertEqual(read_results(self.folder).best.id, 8)

    def test_numbers_may_be_missing_anywhere(self):
        history = self.folder / "evaluations" / "0005" / "history.csv"
        lines = [line.split(",") for line in history.read_text().splitlines()]
        for i, cells in enumerate(lines[1:]):
            cells[i % (len(cells) - 1)] = ("nan", "", "inf")[i % 3]
        for kept in (len(lines), 2, 1):
            history.write_text("".join(",".join(cells) + "\n" for cells in lines[:kept]))
            with self.subTest(lines=kept):
                words = re.sub(r"<(style|script).*?</\1>|<img [^>]*>", "", self.page(), flags=re.S)
                self.assertNotRegex(words, r"\bnan\b")


class Endings(WithResults):
    """What the page says of runs that did not end well."""

    def rewrite(self, changed: dict, **summary):
        """Changes all lines of the journal and the summary."""
        journal = self.folder / "journal.jsonl"
        entries = [json.loads(line) | changed for line in journal.read_text().splitlines()]
        journal.write_text("".join(json.dumps(entry) + "\n" for entry in entries))
        path = self.folder / "summary.json"
        path.write_text(json.dumps(json.loads(path.read_text()) | summary))

    def test_an_interrupted_run_shows_the_best_so_far(self):
        self.rewrite({}, status="running", best=None, counts={})
        self.assertEqual(read_results(self.folder).best.id, 5)
        text = headline(read_results(self.folder))
        self.assertIn("Still running, or interrupted", text)
        self.assertIn("Evaluations: 8 (ok 7, diverged 1).", text)
        self.assertIn("Best so far: evaluation 5", text)

    def test_the_best_so_far_keeps_the_constraints(self):
        self.rewrite({}, status="running", best=None)
        (self.folder / "resolved.toml").write_text('[[constraint]]\nresponse = "angle_40kPa"\nmax = 180\n')
        self.assertEqual(read_results(self.folder).best.id, 8)

    def test_the_class_of_a_path_comes_with_its_criteria(self):
        criterion = {"name": "bulge_limit", "class": "interaction_failure", "what": "bulge of the balloon",
                     "value": 4.2, "limit": 3.5, "unit": "mm", "at_most": True, "margin": -0.2}
        self.rewrite({"judgement": {"class": "interaction_failure", "reason": "it bulges out", "stage": "excessive",
                                    "criteria": [criterion], "snap_throughs": []}})
        text = self.page()
        self.assertIn("<td>class of the path</td><td>interaction failure</td><td>it bulges out</td>", text)
        self.assertIn('<tr class="failed"><td>bulge of the balloon</td><td class="number">4.2</td>', text)

    def test_without_success_the_longest_path_is_shown_with_every_reason(self):
        self.rewrite({"status": "diverged", "reason": "too <small> a step", "responses": {}}, status="no_result",
                     reason="no design worked", best=None)
        text = self.page()
        self.assertIn("No evaluation has worked. Shown is number 1: 60 steps, to 40 kPa", text)
        self.assertEqual(text.count("at the smallest step: too &lt;small&gt; a step</td>"), 8)

    def test_one_simulation_has_no_loop(self):
        journal = self.folder / "journal.jsonl"
        journal.write_text(journal.read_text().splitlines()[0] + "\n")
        for number in (2, 4, 5, 6, 7, 8):
            shutil.rmtree(self.folder / "evaluations" / f"{number:04d}")
        self.rewrite({"design": {}}, best={"id": 1}, objective=None)
        text = self.page()
        self.assertNotIn('<section id="loop">', text)
        self.assertIn('<section id="curve">', text)


class Events(WithResults):
    def test_limit_points_are_maxima_before_a_real_drop(self):
        pressure = np.array([0, 10, 20, 19.9, 21, 30, 25, 26, 35, 34.9])
        self.assertEqual(events.limit_points(pressure), [5])
        self.assertEqual(events.limit_points(np.array([0.0, 1, 2, 3])), [])
        self.assertEqual(events.limit_points(np.array([])), [])

    def test_slow_rise_jumps_from_a_limit_point_to_the_next_state_of_its_pressure(self):
        self.assertEqual(events.jumps(np.array([0.0, 3, 1, np.nan, 2, 5])), [(1, 5)])
        self.assertEqual(events.jumps(np.array([0.0, 3, 1, 2, 1])), [])

    def test_stages_and_loss_of_stability(self):
        history = read_history(self.folder / "evaluations" / "0005" / "history.csv")
        runs = events.stages(history)
        self.assertEqual([name for name, _, _ in runs], ["separation", "insufficient", "sufficient", "excessive"])
        self.assertEqual((runs[0][1], runs[-1][2]), (0, STEPS - 1))
        self.assertEqual([e.name for e in events.events(history)].count("stability lost"), 1)

    def test_located_critical_points_are_events_of_their_steps(self):
        history = History({"step": np.array([1.0, 2, 3]), "pressure_kPa": np.array([1.0, 2, 2.1])})
        points = [{"kind": "bifurcation", "step": 2.0}, {"kind": "eigenvalue_jump", "step": 3.0},
                  {"kind": "limit_point", "step": 9.0}]
        self.assertEqual([(e.index, e.name) for e in events.events(marked(history, points))],
                         [(1, "bifurcation, located")])


class Axes(unittest.TestCase):
    def test_a_free_motion_runs_in_time_a_driven_path_in_its_control(self):
        time, steps = np.array([0.1, 0.3, 0.4]), np.arange(3.0)
        released = History({"step": steps, "control": time, "time_s": time})
        self.assertEqual(path_axis(released)[1], "time (s)")
        np.testing.assert_array_equal(path_axis(released)[0], time)
        driven = History({"step": steps, "control": 2 * time, "time_s": time})
        self.assertEqual(path_axis(driven)[1], "step")
        self.assertEqual(path_axis(History({"step": steps, "control": time}))[1], "step")


class Shapes(WithResults):
    def test_lexicographic_corners_are_put_in_order(self):
        points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])
        ordered = [[0, 1, 3, 2]]
        self.assertEqual(surface.cyclic(np.array([[0, 1, 2, 3]]), points).tolist(), ordered)
        self.assertEqual(surface.cyclic(np.array(ordered), points).tolist(), ordered)

    def test_half_model_is_mirrored(self):
        shape = read_results(self.folder).best.surface
        drawn = picture.corners(shape, shape.states[0])
        self.assertEqual(len(drawn), 2 * len(shape.faces))
        self.assertAlmostEqual(drawn[..., 1].min(), -drawn[..., 1].max())

    def test_packed_points_come_back(self):
        shape = read_results(self.folder).best.surface
        data = json.loads(viewer.packed(shape))
        levels = np.frombuffer(base64.b64decode(data["states"][-1]["points"]), "<u2").reshape(-1, 3)
        points = np.array(data["low"]) + levels / 65535 * data["extent"]
        self.assertEqual(data["bodies"], {"0": "balloon", "1": "backbone"})
        np.testing.assert_allclose(points, shape.states[-1].points[np.unique(shape.faces)], atol=data["extent"] / 65535)

    def test_without_stress_bodies_are_coloured(self):
        path = self.folder / "evaluations" / "0005" / "history.h5"
        with h5py.File(path, "a") as file:
            for state in file["states"].values():
                del state["stress"]
        self.assertIn("Colour: body.", self.page())

    def test_grid_of_the_invented_surface_is_cyclic(self):
        self.assertEqual(grid_faces(1, 1).tolist(), [[0, 1, 3, 2]])


class Numbers(unittest.TestCase):
    def test_best_so_far_goes_the_way_of_the_goal(self):
        values = np.array([np.nan, 3, 1, np.nan, 5])
        np.testing.assert_equal(loop.best_so_far(values, 1), [np.nan, 3, 3, 3, 5])
        np.testing.assert_equal(loop.best_so_far(values, -1), [np.nan, 3, 1, 1, 1])

    def test_labels_carry_units(self):
        self.assertEqual(units.label("balloon_stress_max_MPa"), "balloon stress max (MPa)")
        self.assertEqual(units.label("pressure_kPa_max"), "pressure max (kPa)")
        self.assertEqual(units.label("balloon_stress_max_MPa_max"), "balloon stress max (MPa)")
        self.assertEqual(units.unit_of("tip_x_mm_min"), "mm")
        self.assertEqual([units.duration(s) for s in (4.81, 217.2, 7500, None)],
                         ["4.8 s", "3 min 37 s", "2 h 5 min", "–"])
        self.assertEqual(units.label("N"), "N")
        self.assertEqual(units.label("rib_contact_fraction"), "rib contact fraction")
        self.assertEqual([units.number(v) for v in (1.23456, 200.0, None, float("nan"), "normal")],
                         ["1.235", "200", "–", "–", "normal"])


class TheReducedModel(WithResults):
    def resolve(self, model: str):
        (self.folder / "resolved.toml").write_text(f'[study]\nname = "invented"\n[method]\nmodel = "{model}"\n')

    def with_reduced_responses(self, offset: float):
        journal = self.folder / "journal.jsonl"
        entries = [json.loads(line) for line in journal.read_text().splitlines()]
        for entry in entries:
            for name, value in list(entry["responses"].items()):
                if name == "angle_40kPa":
                    entry["responses"]["reduced_" + name] = value + offset
        journal.write_text("".join(json.dumps(entry) + "\n" for entry in entries))

    def test_says_that_no_simulation_made_the_numbers(self):
        self.resolve("reduced")
        text = self.page()
        self.assertIn("reduced model, not of a simulation", text)
        self.assertNotIn("contact penetration", text)
        self.assertNotIn("Newton iterations", text)

    def test_shows_both_models_where_they_disagree(self):
        self.resolve("both")
        self.with_reduced_responses(50.0)
        section = models.models(read_results(self.folder))
        self.assertIn("200", section)
        self.assertIn("250", section)
        self.assertIn("7 of 8", section)
        self.with_reduced_responses(1.0)
        self.assertIn("agree within 5 %", models.models(read_results(self.folder)))


if __name__ == "__main__":
    unittest.main()
