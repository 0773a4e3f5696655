# SPDX-License-Identifier: BSD-3-Clause
"""What the library of the plugin `python` calls: opens a file, makes objects of its class, words of failures."""
import importlib.util
import inspect
import pathlib
import re
import sys
import sysconfig
import traceback
import types

import numpy as np

from tolman import _state, parameters, plugins

_MODULE = "tolman_program"
_SHOWN_FRAMES = 8


def open_program(file):
    """Imports a file. Gives its class, its role, version, summary and schema."""
    path = pathlib.Path(file)
    _require_text(path.read_bytes())
    sys.path.insert(0, str(path.parent))
    sys.argv = [file]
    spec = importlib.util.spec_from_file_location(_MODULE, path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[_MODULE] = module
    spec.loader.exec_module(module)
    cls, role = _plugin_class(module)
    summary = (cls.__doc__ or module.__doc__ or "").strip().split("\n")[0]
    if not summary:
        raise TypeError(f"class {cls.__name__} has no docstring; its first line is the summary of the plugin")
    return {"class": cls, "role": role, "version": str(cls.version), "summary": summary,
            "schema": parameters.schema(cls), "arrays": _has(cls, "arrays"), "describe": _has(cls, "describe"), "files": _files(path)}


def _require_text(source):
    """Of zero bytes Python says neither file nor encoding. Editors and PowerShell save UTF-16."""
    start = source[:4]
    if start in (b"\xff\xfe\0\0", b"\0\0\xfe\xff") or (len(start) == 4 and start.count(b"\0") == 3):
        raise plugins.InvalidInput("is UTF-32; save it as UTF-8")
    if start[:2] in (b"\xff\xfe", b"\xfe\xff") or (len(start) == 4 and start[::2] == b"\0\0") or start[1::2] == b"\0\0":
        raise plugins.InvalidInput("is UTF-16; save it as UTF-8")
    if b"\0" in source:
        line = source[:source.index(b"\0")].count(b"\n") + 1
        raise plugins.InvalidInput(f"has a zero byte in line {line}, so it is damaged or no text; restore it")


def _files(program):
    """What it imported from this package and from anywhere but the folders of Python and of installed packages."""
    own, package = program.resolve(), pathlib.Path(__file__).resolve().parent
    names = [vars(module).get("__file__") for module in list(sys.modules.values()) if isinstance(module, types.ModuleType)]
    files = {pathlib.Path(name).resolve() for name in names if isinstance(name, str) and "\0" not in name}

    installed = {pathlib.Path(folder).resolve() for folder in (sysconfig.get_path("stdlib"), sysconfig.get_path("platstdlib"))}

    def counts(file):
        foreign = not installed.isdisjoint(file.parents) or not {"site-packages", "dist-packages"}.isdisjoint(file.parts)
        return file.is_file() and file != own and (not foreign or package in file.parents)

    return sorted(str(file) for file in files if counts(file))


def _has(cls, name):
    return callable(getattr(cls, name, None))


def _plugin_class(module):
    """The one class of the file that has a role."""
    bases = tuple(plugins.ROLES.values())
    found = [item for item in vars(module).values()
             if inspect.isclass(item) and issubclass(item, bases) and item.__module__ == module.__name__]
    leaves = [cls for cls in found if not any(other is not cls and issubclass(other, cls) for other in found)]
    if len(leaves) != 1:
        named = ", ".join(cls.__name__ for cls in leaves) or "none"
        raise TypeError("a plugin is a file with exactly one class that derives from tolman.Source, Odometry, Place, "
                        f"Cells, Map or Observer; this one has {named}")
    roles = [role for role, base in plugins.ROLES.items() if issubclass(leaves[0], base)]
    if len(roles) != 1:
        raise TypeError(f"class {leaves[0].__name__} derives from several roles: {', '.join(roles)}")
    return leaves[0], roles[0]


def make(cls, services, values):
    """A new object, in the state before the first frame."""
    made = cls.__new__(cls)
    try:
        complete = parameters.bound(cls, values)
    except TypeError as error:
        raise plugins.InvalidParameter(str(error)) from None
    for name, value in complete.items():
        setattr(made, name, value)
    made.log, made.rig, made.seed, made.name = services["log"], services["rig"], services["seed"], services["name"]
    made.rng = np.random.Generator(np.random.PCG64(services["seed"]))
    made.write_artefact, made.add_finding = services["write_artefact"], services["add_finding"]
    made.start()
    return made


def save(made):
    return _state.dump({name: value for name, value in vars(made).items() if name not in _GIVEN})


def load(made, content):
    vars(made).update(_state.load(content, type(made).__module__))


_GIVEN = ("log", "rig", "seed", "name", "write_artefact", "add_finding")  # by the host, and no part of the state


def status_name(error):
    for cls, name in ((plugins.InvalidInput, "InvalidInput"), (plugins.InvalidParameter, "InvalidParameter"),
                      (plugins.Unsupported, "Unsupported"), (_state.Damaged, "InvalidInput")):
        if isinstance(error, cls):
            return name
    return "Failed"


def described(error, call):
    """(one line, the traceback): what was raised, where in the file, and in which call."""
    own = str(pathlib.Path(__file__).parent)
    frames = [frame for frame in traceback.extract_tb(error.__traceback__)
              if not frame.filename.startswith((own, "<frozen importlib"))]
    if isinstance(error, SyntaxError) and error.filename:
        place = f" ({pathlib.Path(error.filename).name}:{error.lineno})"
    else:
        place = f" ({pathlib.Path(frames[-1].filename).name}:{frames[-1].lineno}, in {frames[-1].name})" if frames else ""
    text = _message(error)
    kind = type(error).__name__
    if isinstance(error, ValueError) and "cannot contain null bytes" in text:  # open_program() has looked at the program itself
        text = "a file that is imported here is UTF-16 or damaged; save it as UTF-8"
    if isinstance(error, MemoryError):
        text = "out of memory (std::bad_alloc)"
    own_error = kind in ("InvalidInput", "InvalidParameter", "Unsupported", "Damaged")
    line = text if own_error else f"{kind}: {text}" + place
    listed = "".join(traceback.format_list(frames[-_SHOWN_FRAMES:])).rstrip()
    trace = f"traceback of {call}:\n{listed}\n{kind}: {text}" if frames else ""
    return _shown(" ".join(line.split())), _shown(trace)


def _message(error):
    try:
        return str(error) or "no message"
    except BaseException:  # also of sys.exit() in it
        return "its __str__ fails, so it has no message"


def _shown(text):
    """With U+FFFD for lone surrogates, which have no UTF-8."""
    return re.sub("[\ud800-\udfff]", "\ufffd", text)
