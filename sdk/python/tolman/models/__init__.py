# SPDX-License-Identifier: BSD-3-Clause
"""Models that come with Tolman, each a plugin in one file: `{plugin: python, file: FOLDER/ssp.py}`."""
import pathlib


def path(name):
    """The file of a model, for `file:` of a configuration."""
    return pathlib.Path(__file__).parent / f"{name}.py"
