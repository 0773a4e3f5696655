# SPDX-License-Identifier: BSD-3-Clause
"""Saved state: what goes in comes out; damaged and foreign bytes do neither run nor pass."""
import collections
import hashlib
import os
import pickle
import unittest

import support  # noqa: F401: skips without NumPy

import numpy as np

import tolman
from tolman import _state


class Own:
    def __init__(self, value):
        self.value = value


class Calls:
    def __reduce__(self):
        return os.system, ("touch /tmp/tolman-state-test-was-run",)


class Popen:  # as if imported from elsewhere
    pass


Popen.__module__ = "subprocess"


class StateTest(unittest.TestCase):
    def test_data_survive(self):
        rng = np.random.Generator(np.random.PCG64(3))
        rng.normal(size=7)
        values = {"array": np.arange(6.0).reshape(2, 3), "number": np.float32(2), "deque": collections.deque([1], 4),
                  "set": {1, 2}, "record": tolman.Decision(experience=4), "own": Own(5), "rng": rng, "none": None}
        read = _state.load(_state.dump(values), __name__)
        self.assertTrue(np.array_equal(read["array"], values["array"]))
        self.assertEqual((read["number"], read["deque"], read["set"], read["own"].value, read["record"].experience),
                         (2, values["deque"], {1, 2}, 5, 4))
        self.assertEqual(read["rng"].normal(), rng.normal())

    def test_damage_is_found(self):
        good = _state.dump({"a": np.zeros(10)})
        for bad in (b"", b"once upon a time", good[:-1], good[:40], good[:60] + b"x" + good[61:]):
            with self.assertRaises(_state.Damaged):
                _state.load(bad, __name__)

    def test_what_cannot_be_saved_is_named(self):
        for value in (lambda: 0, np.core.multiarray._ARRAY_API):  # the latter a PyCapsule
            with self.assertRaisesRegex(TypeError, "the attribute 'link' cannot be saved .*: it must hold data"):
                _state.dump({"a": np.zeros(3), "link": value})

    def test_nothing_is_called(self):
        for content in (pickle.dumps({"a": Calls()}), b"cbuiltins\neval\n(S'1'\ntR.", b"csubprocess\nPopen\n.",
                        b"c" + __name__.encode() + b"\nPopen\n."):
            signed = b"tolman python state 1\n" + hashlib.sha256(content).digest() + content
            with self.assertRaises(_state.Damaged):
                _state.load(signed, __name__)
        self.assertFalse(os.path.exists("/tmp/tolman-state-test-was-run"))


if __name__ == "__main__":
    unittest.main()
