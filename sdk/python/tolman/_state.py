# SPDX-License-Identifier: BSD-3-Clause
"""The state of a Python plugin as bytes: a digest, then a pickle that may only hold data.

A saved session may come from elsewhere, and a pickle can call any function. So only arrays, numbers, texts,
containers, random streams, records and classes of the plugin's own file are read.
"""
import hashlib
import io
import pickle

_MAGIC = b"tolman python state 1\n"
_DIGEST = hashlib.sha256().digest_size
_LEGAL = {
    ("numpy.core.multiarray", "_reconstruct"), ("numpy.core.multiarray", "scalar"), ("numpy", "ndarray"),
    ("numpy", "dtype"), ("numpy.random._pickle", "__generator_ctor"), ("numpy.random._pickle", "__bit_generator_ctor"),
    ("collections", "deque"), ("collections", "OrderedDict"), ("collections", "defaultdict"),
    ("builtins", "set"), ("builtins", "frozenset"), ("builtins", "complex"), ("builtins", "bytearray"),
    ("builtins", "list"), ("builtins", "dict"), ("builtins", "int"), ("builtins", "float"),
    ("pathlib", "Path"), ("pathlib", "PosixPath"), ("copyreg", "_reconstructor"), ("builtins", "object"),
}  # yapf: disable


class Damaged(Exception):
    """The bytes are no state of this plugin."""


class _Reader(pickle.Unpickler):
    def __init__(self, stream, module):
        super().__init__(stream)
        self._module = module

    def find_class(self, module, name):
        if (module, name) in _LEGAL:
            return super().find_class(module, name)
        found = super().find_class(module, name) if module in ("tolman.records", self._module) else None
        if isinstance(found, type) and found.__module__ == module:
            return found
        raise Damaged(f"the saved state holds a {module}.{name}, which is neither data nor of the plugin's file")


def _unsaved(values):
    """The name of the first attribute that cannot be saved, and why."""
    for name, value in values.items():
        try:
            pickle.dumps(value, protocol=4)
        except Exception as error:
            return name, error
    return "", "together they cannot"


def dump(values):
    try:
        content = pickle.dumps(values, protocol=4)
    except Exception as error:
        name, why = _unsaved(values)
        raise TypeError(f"the attribute '{name}' cannot be saved ({why}): it must hold data, such as arrays, numbers and texts; "
                        "or save() and load() leave it out") from error
    return _MAGIC + hashlib.sha256(content).digest() + content


def load(content, module):
    head = len(_MAGIC) + _DIGEST
    if len(content) < head or not content.startswith(_MAGIC):
        raise Damaged("these are not the bytes of a saved Python plugin")
    if hashlib.sha256(content[head:]).digest() != content[len(_MAGIC):head]:
        raise Damaged("the saved state is damaged: its digest differs")
    try:
        values = _Reader(io.BytesIO(content[head:]), module).load()
    except Damaged:
        raise
    except Exception as error:
        raise Damaged(f"the saved state cannot be read: {error}") from error
    if not isinstance(values, dict):
        raise Damaged("the saved state is no set of attributes")
    return values
