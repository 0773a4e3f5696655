# SPDX-License-Identifier: BSD-3-Clause
"""The models that come with the package: what their papers show, and runs on a random walk."""
import math
import unittest
import unittest.mock

from support import Systems, tolman as program

import numpy as np

import tolman
from tolman import models


def load(name):
    """The class of a model."""
    from tolman import _host

    return _host.open_program(str(models.path(name)))["class"]


class SspTest(unittest.TestCase):
    def setUp(self):
        self.ssp = load("ssp")(spacing=0.4)

    def test_binding_adds_positions(self):
        a, b = np.array([0.3, -0.1]), np.array([-0.75, 0.2])
        self.assertTrue(np.allclose(self.ssp.encode(a) * self.ssp.encode(b), self.ssp.encode(a + b)))

    def test_similarity_depends_on_the_distance_and_falls(self):
        def similarity(a, b):
            return np.mean(self.ssp.encode(a) * np.conj(self.ssp.encode(b))).real

        shift = np.array([0.7, -1.3])
        for length in (0.02, 0.05, 0.1):
            around = [length * np.array([math.cos(t), math.sin(t)]) for t in np.arange(0, 6.28, 0.1)]
            values = [similarity(shift, shift + step) for step in around]
            self.assertLess(np.ptp(values), 0.01)  # in all directions
            self.assertAlmostEqual(values[0], similarity(np.zeros(2), around[0]))
            # Waves of all directions: Bessel's J0, by its integral.
            waves = np.hypot(*self.ssp.phase_matrix.T)[:, None] * length
            expected = np.mean(np.cos(waves * np.sin(np.linspace(0, 2 * math.pi, 720, endpoint=False))))
            self.assertAlmostEqual(np.mean(values), expected, delta=0.005)

    def test_oscillators_integrate_a_path_and_views_correct_it(self):
        rng, at = np.random.default_rng(3), np.zeros(2)
        for _ in range(500):
            step = rng.normal(0, 0.03, 2)
            self.ssp.move(step)
            at = at + step
        self.assertLess(np.abs(self.ssp.position() - at).max(), 1e-9)
        self.ssp.learn(7)
        self.ssp.move(np.array([0.05, 0.02]))
        self.ssp.recall(7, np.zeros(2))
        self.assertLess(np.abs(self.ssp.position() - at - [0.025, 0.01]).max(), 1e-6)


class VectorHashTest(unittest.TestCase):
    def test_every_state_of_the_scaffold_is_a_fixed_point(self):
        memory = load("vector_hash")(hippocampal=400)
        wrong = 0
        for x in range(60):
            for y in range(60):  # 3600 states of 50 grid cells
                grid = memory.grid((x, y))
                wrong += not np.array_equal(memory.grid_of(memory.hippocampus(grid)), grid)
        self.assertEqual(wrong, 0)

    def test_the_scaffold_is_clean_after_noise(self):
        memory, rng = load("vector_hash")(hippocampal=400), np.random.default_rng(5)
        for _ in range(100):
            grid = memory.grid(rng.integers(0, 60, 2))
            hidden = memory.hippocampus(grid)
            noisy = hidden + rng.normal(0, hidden.std(), hidden.shape)
            self.assertTrue(np.array_equal(memory.grid_of(np.maximum(0, noisy)), grid))

    def test_recall_is_exact_up_to_the_cells_of_the_layer_and_then_fades_without_a_cliff(self):
        quality = {}
        for count in (50, 100, 200, 400):
            memory, rng = load("vector_hash")(hippocampal=100, sensory=400), np.random.default_rng(1)
            patterns = rng.choice([-1.0, 1.0], (count, 400))
            states = rng.permutation(3600)[:count]
            for pattern, state in zip(patterns, states):
                memory.store(pattern, (state % 60, state // 60))
            hidden = np.array(memory.hidden).T
            recalled = (patterns.T @ np.linalg.pinv(hidden)) @ hidden
            quality[count] = np.mean([np.corrcoef(a, b)[0, 1] for a, b in zip(recalled.T, patterns)])
        self.assertGreater(quality[50], 0.999)
        self.assertGreater(quality[100], 0.99)
        self.assertGreater(quality[200], 0.6)
        self.assertGreater(quality[400], 0.35)
        self.assertGreater(quality[200], quality[400])

    def test_a_spoilt_view_recalls_its_place(self):
        memory, rng = load("vector_hash")(hippocampal=300, sensory=300), np.random.default_rng(2)
        patterns = rng.choice([-1.0, 1.0], (40, 300))
        for i, pattern in enumerate(patterns):
            memory.store(pattern, (i, 2 * i))
        for i, pattern in enumerate(patterns):
            spoilt = np.where(rng.random(300) < 0.1, -pattern, pattern)
            grid, completed = memory.recalled(spoilt)
            self.assertTrue(np.array_equal(grid, memory.grid((i, 2 * i))))
            self.assertTrue(np.array_equal(np.sign(completed), pattern))


class PlaceCellsTest(unittest.TestCase):
    def peak(self, model, half):
        """Where along x the first cell fires most."""
        xs = np.linspace(-half + 0.01, half - 0.01, 400)
        return xs[np.argmax([model.drive(model.room(np.array([x, 0.0])))[0] for x in xs])]

    def test_a_field_keeps_its_distance_from_its_wall_when_the_room_is_stretched(self):
        for width in (1.0, 1.5, 3.0):
            model = load("place_cells")(width=width, depth=4, cells=1, inputs=1)
            model.preferred, model.distance = np.array([[0.0]]), np.array([[0.3]])
            self.assertAlmostEqual(width / 2 - self.peak(model, width / 2), 0.3, delta=0.05)

    def test_a_field_of_two_opposite_walls_divides(self):
        narrow, wide = (load("place_cells")(width=w, depth=4, cells=1, inputs=2) for w in (0.6, 2.4))
        for model in (narrow, wide):
            model.preferred, model.distance = np.array([[0.0, math.pi]]), np.array([[0.3, 0.3]])
        def drives(model, x):
            return model.drive(model.room(np.array([x, 0.0])))[0]

        self.assertGreater(drives(narrow, 0), drives(narrow, 0.2))  # one field in the middle
        self.assertLess(drives(wide, 0), 0.5 * drives(wide, 0.9))  # two, each at its wall
        self.assertAlmostEqual(drives(wide, 0.9), drives(wide, -0.9), places=6)


class TrajectoryTest(Systems):
    def poses(self, source):
        frames = []
        while (frame := source.next()) is not None:
            frames.append(frame)
        return frames

    def test_the_walk_stays_in_its_box_and_its_motions_add_up(self):
        source = load("trajectory")(duration=60, side=1.0)
        self.assertLessEqual(np.abs(source.poses[:, :2]).max(), 0.5 + 1e-9)
        at = (0.0, 0.0, 0.0)
        for frame in self.poses(source):
            at = tolman.compose(at, frame.sensors["motion.planar"])
            truth = tolman.to_planar(frame.T_world_camera_truth)
            self.assertLess(math.dist(at[:2], truth[:2]), 1e-9)
        self.assertEqual(len(source.poses), 601)

    def test_a_walk_through_rooms_is_carried_between_them(self):
        source = load("trajectory")(duration=90, side=1.0, rooms=2)
        frames = self.poses(source)
        room = [round(tolman.to_planar(frame.T_world_camera_truth)[0] / 2) for frame in frames]
        self.assertEqual(room, [0] * 300 + [1] * 300 + [0] * 301)
        for k in (300, 600):
            self.assertTrue(np.array_equal(frames[k].sensors["motion.planar"], np.zeros(3)))
            self.assertGreater(math.dist(source.poses[k, :2] % 2, source.poses[k - 1, :2] % 2), 0.05)  # to another place
        for frame in frames:
            for to, x, y, _ in frame.sensors["place.candidate"]:
                self.assertEqual(room[frame.frame], room[int(to)])
        self.assertTrue(any(frame.frame >= 600 and len(frame.sensors["place.candidate"]) for frame in frames))

    def test_views_are_of_near_places(self):
        source = load("trajectory")(duration=600, view_radius=0.1, view_angle=3.2)
        seen = 0
        for frame in self.poses(source):
            for to, x, y, turn in frame.sensors["place.candidate"]:
                seen += 1
                self.assertLess(math.hypot(x, y), 0.1)
                self.assertLess(to, frame.frame - 49)
        self.assertGreater(seen, 50)

    def test_a_csv_file_is_read_and_a_wrong_one_refused(self):
        file = self.folder / "rat.csv"
        file.write_text("t,x,y\n0,0,0\n1,1,0\n2,1,1\n")
        source = load("trajectory")(path=file, rate=2)
        self.assertTrue(np.allclose(source.poses[:, :2], [[0, 0], [0.5, 0], [1, 0], [1, 0.5], [1, 1]]))
        file.write_text("t,x\n0,0\n1,1\n")
        with self.assertRaises(tolman.InvalidInput):
            load("trajectory")(path=file)
        with self.assertRaises(tolman.InvalidInput):
            load("trajectory")(path=self.folder / "missing.csv")

    def test_a_csv_file_of_a_spreadsheet_is_read_and_its_gaps_are_told(self):
        file = self.folder / "rat.csv"
        file.write_text("t,x,y,heading\n0,0,0,0\n0.1,0,0,0\n0.2,1,0,0\n9.2,1,1,0\n", encoding="utf-8-sig")
        with unittest.mock.patch("tolman.plugins._NoLog.warning", create=True) as warning:
            source = load("trajectory")(path=file)
        self.assertEqual(len(source.poses), 93)
        self.assertIn("1 gaps without positions, the longest of 9 s at t = 0.2 s", warning.call_args.args[0])
        file.write_text("t,x,y,heading\n0,0,0,0\n1,1,0,nan\n")
        with self.assertRaises(tolman.InvalidInput):
            load("trajectory")(path=file)

    def test_nwb_of_an_animal_is_read(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("needs python3-h5py")
        def series(place, columns, **of):
            with h5py.File(self.folder / "rat.nwb", "a") as file:
                group = file.require_group(place)
                group.attrs["neurodata_type"] = "SpatialSeries"
                group["data"] = np.array([[0, 7, 0], [100, 7, 0], [np.nan, 7, 0], [300, 7, 0.0]])[:, :columns]
                group["data"].attrs.update(of)
                group["timestamps"] = 1000 * np.arange(4.0)
                group["timestamps"].attrs["unit"] = "milliseconds"

        def read(**values):
            return load("trajectory")(path=self.folder / "rat.nwb", rate=1, **values).poses[:, 0]

        for of in ({"conversion": 0.01}, {"unit": "cm"}, {"unit": "millimeters", "conversion": 10.0},
                   {"unit": "Meters", "conversion": 0.01, "offset": 2.0}):
            (self.folder / "rat.nwb").unlink(missing_ok=True)
            series("processing/behavior/Position/led", 2, **of)
            series("processing/behavior/Position/a_line", 1)  # is no series of positions
            self.assertTrue(np.allclose(read(), np.arange(4) + of.get("offset", 0)), of)
        series("processing/behavior/Position/another", 3, unit="pixels")
        with self.assertRaisesRegex(tolman.InvalidInput, "several series .* set series to one of: .*/another, .*/led"):
            read()
        with self.assertRaisesRegex(tolman.InvalidInput, "the unit 'pixels', which is not known; set metres"):
            read(series="another")
        self.assertTrue(np.allclose(read(series="another", metres=0.002), 0.2 * np.arange(4)))


class RunsTest(Systems):
    def test_every_model_runs_on_the_walk(self):
        for name in ("ssp", "vector_hash", "place_cells"):
            config = self.folder / f"{name}.yaml"
            config.write_text(f"source: {{plugin: python, file: {models.path('trajectory')}, duration: 120}}\n"
                              "odometry: {plugin: motion_replay}\nplace: {plugin: place_replay, relative_pose: true, view_step: 1000}\n"
                              f"cells: {{plugin: python, file: {models.path(name)}, agreement: 0.3, experience_spacing: 0.2,\n"
                              "        loop_minimum_travel: 2, loop_spacing: 0.2}\n"
                              "map: {plugin: experience_map}\nrecord: {report: false}\n")
            done = program("run", config, "--quiet", "--out", self.folder / name)
            self.assertEqual(done.returncode, 0, done.stderr)
            run = tolman.Run(self.folder / name)
            self.assertGreater(list(run.decisions["action"]).count("close_loop"), 3)
            self.assertLess(run.metrics["map"]["ate"]["rmse_m"], 0.1)


if __name__ == "__main__":
    unittest.main()
