# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of classes: the schema that the host gets, and the values that an object gets."""
import math
import pathlib
import typing
import unittest

import support  # noqa: F401: skips without NumPy

import tolman
from tolman import parameters


class Base(tolman.Observer):
    """A base."""

    every: int = tolman.parameter(3, range=(1, 9), unit="frames", doc="How often.")


class Mine(Base):
    """A class with all types."""

    scale: float = tolman.parameter(2, doc="A scale.")
    loud: bool = tolman.parameter(False, doc="A flag.")
    title: str = tolman.parameter("a", doc="A text.")
    table: pathlib.Path = tolman.parameter(doc="A file.")
    periods: list[float] = tolman.parameter([1, 2], range=(0, 5), doc="A list.")
    mode: typing.Literal["fast", "exact"] = tolman.parameter("fast", doc="A choice.")
    plain = 7


class ParametersTest(unittest.TestCase):
    def test_schema_has_all_in_order(self):
        schema = parameters.schema(Mine)
        self.assertEqual([(info["name"], info["type"]) for info in schema],
                         [("every", "integer"), ("scale", "real"), ("loud", "bool"), ("title", "text"),
                          ("table", "path"), ("periods", "list"), ("mode", "choice")])
        every, scale, *_, table, periods, mode = schema
        self.assertEqual((every["min"], every["max"], every["unit"], every["doc"]), (1, 9, "frames", "How often."))
        self.assertEqual((scale["min"], scale["max"], scale["default"]), (-math.inf, math.inf, 2.0))
        self.assertIsInstance(scale["default"], float)
        self.assertTrue(table["required"])
        self.assertEqual(periods["default"], [1.0, 2.0])
        self.assertEqual(mode["choices"], ["fast", "exact"])

    def test_objects_have_defaults_and_given_values(self):
        mine = Mine(table="/tmp/a", scale=5)
        self.assertEqual((mine.every, mine.scale, mine.table, mine.plain), (3, 5.0, pathlib.Path("/tmp/a"), 7))

    def test_wrong_values_and_names_are_refused(self):
        for wrong in ({"every": 2.5}, {"every": True}, {"loud": 1}, {"mode": "slow"}, {"unknown": 1}, {"title": 3}):
            with self.assertRaises(TypeError, msg=wrong):
                Mine(**wrong)

    def test_wrong_declarations_are_refused(self):
        class Untyped(tolman.Cells):
            spacing = tolman.parameter(1)

        class Complex(tolman.Cells):
            spacing: complex = tolman.parameter(1j)

        class Default(tolman.Cells):
            spacing: int = tolman.parameter(0.5)

        for cls, words in ((Untyped, "has no type"), (Complex, "legal types"), (Default, "no integer")):
            with self.assertRaisesRegex(TypeError, words):
                parameters.schema(cls)


if __name__ == "__main__":
    unittest.main()
