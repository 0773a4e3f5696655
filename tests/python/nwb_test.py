# SPDX-License-Identifier: BSD-3-Clause
"""NWB files by the rules of the published schema (NWB 2.6, HDMF Common 1.5) and the checks of nwbinspector, read by h5py."""
import datetime
import math
import sys
import unittest

from support import Systems, tolman as program

import numpy as np

try:
    import h5py
except ImportError:
    print("skipped: needs python3-h5py")
    sys.exit(77)

import tolman
from tolman import nwb

# From the schema: what an object of a type must have; "@" marks attributes.
REQUIRED = {
    "NWBFile": ["@nwb_version", "file_create_date", "identifier", "session_description", "session_start_time",
                "timestamps_reference_time", "acquisition", "analysis", "processing", "stimulus/presentation",
                "stimulus/templates", "general"],
    "ProcessingModule": ["@description"],
    "SpatialSeries": ["data", "data/@unit", "data/@conversion", "data/@resolution"],
    "TimeSeries": ["data", "data/@unit", "data/@conversion", "data/@resolution"],
    "Units": ["@colnames", "@description", "id"],
    "TimeIntervals": ["@colnames", "@description", "id", "start_time", "stop_time"],
    "VectorData": ["@description"],
    "VectorIndex": ["@description", "@target"],
    "ElementIdentifiers": [], "Position": [], "CompassDirection": [],
}  # yapf: disable
COMMON = ("VectorData", "VectorIndex", "ElementIdentifiers")


def objects(file):
    """Every object with a type, by its path."""
    found = {"/": file}
    file.visititems(lambda name, item: found.update({name: item}) if "neurodata_type" in item.attrs else None)
    return found


def has(item, path):
    place, mark, attribute = path.partition("@")
    owner = item[place.rstrip("/")] if place else item
    return attribute in owner.attrs if mark else path in item


class PiecesTest(unittest.TestCase):
    def test_spikes_have_the_rate_of_their_frames(self):
        seconds = 0.1 * np.arange(4000)
        rates = np.where(seconds < 200, 30.0, 5.0)
        times = nwb.spikes(rates, seconds, (1, 2))
        self.assertTrue((np.diff(times) >= 0).all())
        for low, high, rate in ((0, 200, 30), (200, 400, 5)):
            count = np.count_nonzero((times >= low) & (times < high))
            self.assertLess(abs(count - 200 * rate), 5 * math.sqrt(200 * rate))  # five standard deviations
        self.assertTrue(np.array_equal(times, nwb.spikes(rates, seconds, (1, 2))))
        self.assertFalse(np.array_equal(times, nwb.spikes(rates, seconds, (1, 3))))

    def test_no_spikes_without_rate_nor_in_gaps(self):
        seconds = np.concatenate([0.1 * np.arange(100), 1000 + 0.1 * np.arange(100)])
        self.assertEqual(len(nwb.spikes(np.zeros(200), seconds, 1)), 0)
        times = nwb.spikes(np.full(200, 50.0), seconds, 1)
        self.assertFalse(np.any((times > 10.5) & (times < 1000)))

    def test_frames_that_are_hours_apart_have_few_spikes(self):
        seconds = 36000.0 * np.arange(50)
        times = nwb.spikes(np.full(50, 20.0), seconds, 1)
        self.assertTrue(8000 < len(times) < 12000)  # 20 Hz for 10 s at each frame
        self.assertTrue(np.all(times % 36000 < 10.001))

    def test_laps_begin_and_end_at_the_start(self):
        angle = np.linspace(0, 6 * math.pi, 3001)
        found = nwb.laps(np.sin(angle), 1 - np.cos(angle), np.arange(3001.0))
        self.assertEqual(len(found), 3)
        self.assertTrue(all(start < stop for start, stop in found))
        self.assertAlmostEqual(found[1][0], 1000, delta=60)
        self.assertEqual(nwb.laps(np.arange(9.0), np.zeros(9), np.arange(9.0)), [])  # it never returns

    def test_no_lap_leads_from_one_session_to_the_next(self):
        angle = np.linspace(0, 4 * math.pi, 2001)
        poses = {"x": np.sin(angle), "y": 1 - np.cos(angle), "session": (angle > 3 * math.pi).astype(int)}
        found = nwb._laps_of_sessions(poses, np.arange(2001.0))
        self.assertEqual(len(found), 1)  # the second begins in one session and ends in the other
        self.assertLess(found[0][1], 1100)

    def test_rates_are_in_hertz_and_never_negative(self):
        def rates(values, unit):
            array = tolman.cells.Array(tolman.ArrayInfo("a", unit=unit), np.arange(2), np.arange(2), np.array(values))
            return nwb._rates(array, 20)
        self.assertEqual(rates([[1.0, 2.0]], "Hz").tolist(), [[1, 2]])
        self.assertEqual(rates([[1.0, 2.0]], "1/s").tolist(), [[1, 2]])
        self.assertEqual(rates([[0.5, 2.0]], "kHz").tolist(), [[500, 2000]])
        self.assertEqual(rates([[1.0, 2.0]], "").tolist(), [[10, 20]])
        self.assertIsNone(rates([[1.0, -0.1]], "Hz"))


class FileTest(Systems):
    def exported(self):
        ran = self.run_system()
        self.assertEqual(ran.returncode, 0, ran.stderr)
        done = program("export", self.folder / "run", "--nwb")
        self.assertEqual(done.returncode, 0, done.stderr)
        file = h5py.File(self.folder / "run/run.nwb")
        self.addCleanup(file.close)
        return file

    def test_types_have_what_the_schema_requires(self):
        file = self.exported()
        found = objects(file)
        identities = [item.attrs["object_id"] for item in found.values()]
        self.assertEqual(len(set(identities)), len(identities))
        for name, item in found.items():
            kind = item.attrs["neurodata_type"]
            self.assertEqual(item.attrs["namespace"], "hdmf-common" if kind in COMMON else "core", name)
            for part in REQUIRED[kind]:
                self.assertTrue(has(item, part), f"{name} ({kind}) has no {part}")
        kinds = {item.attrs["neurodata_type"] for item in found.values()}
        self.assertEqual(kinds, set(REQUIRED))
        start = datetime.datetime.fromisoformat(file["session_start_time"][()].decode())
        self.assertIsNotNone(start.tzinfo)

    def test_series_are_in_si_units_with_ascending_times(self):
        file = self.exported()
        series = [item for item in objects(file).values() if item.attrs["neurodata_type"].endswith("Series")]
        self.assertGreaterEqual(len(series), 3)
        for item in series:
            self.assertIn(item["data"].attrs["unit"], ("meters", "radians", "hertz"))
            self.assertNotEqual(item["data"].attrs["resolution"], 0)
            self.assertTrue(item["data"].shape[0] == 25 and np.isfinite(item["data"][()]).all(), item.name)
            if "timestamps" in item:
                self.assertTrue((np.diff(item["timestamps"][()]) > 0).all())
            else:
                self.assertAlmostEqual(item["starting_time"].attrs["rate"], 10)
                self.assertEqual(item["starting_time"].attrs["unit"], "seconds")
        heading = file["processing/behavior/CompassDirection/head_direction/data"][()]
        self.assertTrue(((heading >= 0) & (heading < 2 * math.pi)).all())

    def test_tables_have_columns_of_one_length(self):
        file = self.exported()
        for item in objects(file).values():
            if "colnames" not in item.attrs:
                continue
            for name in item.attrs["colnames"]:
                rows = item[f"{name}_index"] if f"{name}_index" in item else item[name]
                self.assertEqual(len(rows), len(item["id"]), f"{item.name}/{name}")
        for name in ("trials", "views"):
            table = file["intervals"][name]
            self.assertTrue((table["stop_time"][()] > table["start_time"][()]).all())
            self.assertTrue((np.diff(table["start_time"][()]) > 0).all())

    def test_units_have_phase_module_and_ascending_spikes(self):
        file = self.exported()
        units, run = file["units"], tolman.Run(self.folder / "run")
        activity = [name for name, info in run.descriptions.items() if info.kind == "activity"]
        self.assertEqual(len(units["id"]), sum(run.array(name).values[0].size for name in activity))
        self.assertEqual(file[units["spike_times_index"].attrs["target"]], units["spike_times"])
        self.assertEqual(units["spike_times"].attrs["resolution"], nwb.SPIKE_RESOLUTION_S)
        ends = np.concatenate([[0], units["spike_times_index"][()]]).astype(int)
        times = units["spike_times"][()]
        self.assertGreater(len(times), 0)
        self.assertTrue((times >= 0).all())
        for begin, end in zip(ends[:-1], ends[1:]):
            self.assertTrue((np.diff(times[begin:end]) >= 0).all())
        kinds = {kind.decode() for kind in units["kind"][()]}
        self.assertEqual(kinds, {"head direction", "grid"})

    def test_the_same_run_gives_the_same_values(self):
        file = self.exported()
        again = h5py.File(nwb.export(tolman.Run(self.folder / "run"), self.folder / "again.nwb"))
        self.addCleanup(again.close)
        for name in ("units/spike_times", "processing/behavior/Position/position/data", "identifier"):
            self.assertTrue(np.array_equal(file[name][()], again[name][()]), name)

    def test_rates_need_a_positive_peak(self):
        self.exported()
        for peak_hz in (0, -20, float("nan"), float("inf")):
            with self.assertRaisesRegex(ValueError, "peak_hz is"):
                nwb.export(tolman.Run(self.folder / "run"), self.folder / "none.nwb", peak_hz)
        self.assertFalse((self.folder / "none.nwb").exists())

    def test_a_file_that_is_too_large_is_told_as_such(self):
        import subprocess

        from support import BUILD

        self.exported()
        for kind in ("nwb", "npz"):
            line = f"ulimit -f 20; exec '{BUILD}/bin/tolman' export '{self.folder}/run' --{kind} --out '{self.folder}/{kind}'"
            done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 8, done.stderr)
            self.assertRegex(done.stderr, rf"run\.{kind}: cannot be written \(File too large\); look for .*ulimit -f")
            self.assertNotIn("it needs", done.stderr)
            self.assertNotIn("Traceback", done.stderr)
            self.assertEqual([file.name for file in (self.folder / kind).iterdir() if file.name.startswith("run.")], [])


if __name__ == "__main__":
    unittest.main()
