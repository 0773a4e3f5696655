# SPDX-License-Identifier: BSD-3-Clause
"""Objects of Neurodata Without Borders (NWB 2.6, HDMF Common 1.5) in an HDF5 file: groups and datasets with their types."""
import uuid

import h5py
import numpy as np

_TEXT = h5py.string_dtype()
_COMMON = ("DynamicTable", "VectorData", "VectorIndex", "ElementIdentifiers")


class Writer:
    """Writes typed objects. `identity`: a text that the ids of all objects follow from, so that the same run gives the same."""

    def __init__(self, file, identity):
        self.file, self._space = file, uuid.uuid5(uuid.NAMESPACE_URL, identity)

    def mark(self, thing, kind, **attributes):
        """Gives an object its type, an id and more attributes."""
        thing.attrs["neurodata_type"] = kind
        thing.attrs["namespace"] = "hdmf-common" if kind in _COMMON else "core"
        thing.attrs["object_id"] = str(uuid.uuid5(self._space, thing.name))
        for name, value in attributes.items():
            thing.attrs[name] = value
        return thing

    def text(self, path, value):
        return self.file.create_dataset(path, data=str(value), dtype=_TEXT)

    def module(self, name, description):
        return self.mark(self.file.create_group(f"processing/{name}"), "ProcessingModule", description=description)

    def series(self, path, kind, data, unit, seconds, description):
        """A TimeSeries or a kind of it; with a rate where the times are even."""
        group = self.mark(self.file.create_group(path), kind, description=description, comments="no comments")
        options = {"compression": "gzip", "compression_opts": 4} if data.size > 1000 else {}
        values = group.create_dataset("data", data=data, **options)
        values.attrs.update({"unit": unit, "conversion": 1.0, "resolution": -1.0, "offset": 0.0})
        steps = np.diff(seconds)
        if len(steps) > 1 and np.ptp(steps) < 1e-6:
            start = group.create_dataset("starting_time", data=float(seconds[0]))
            start.attrs.update({"rate": 1 / float(steps.mean()), "unit": "seconds"})
        else:
            times = group.create_dataset("timestamps", data=seconds)
            times.attrs.update({"interval": np.int32(1), "unit": "seconds"})
        return group

    def table(self, path, kind, description, columns, lists=None):
        """A DynamicTable. `columns` and `lists` (one list a row): name to (values, description)."""
        lists = lists or {}
        names = np.array([*columns, *lists], dtype=object)
        group = self.mark(self.file.create_group(path), kind, description=description)
        group.attrs.create("colnames", names, dtype=_TEXT)
        rows = len(next(iter({**columns, **lists}.values()))[0])
        self.mark(group.create_dataset("id", data=np.arange(rows, dtype=np.int64)), "ElementIdentifiers")
        for name, (values, words) in columns.items():
            self._column(group, name, values, words)
        for name, (values, words) in lists.items():
            joined = np.concatenate([np.zeros(0), *values])
            column = self._column(group, name, joined, words)
            ends = np.cumsum([len(value) for value in values], dtype=np.uint64)
            index = group.create_dataset(f"{name}_index", data=ends)
            self.mark(index, "VectorIndex", description=f"Index for VectorData '{name}'", target=column.ref)
        return group

    def _column(self, group, name, values, words):
        is_text = len(values) > 0 and isinstance(values[0], str)
        made = group.create_dataset(name, data=np.array(values, dtype=object) if is_text else np.asarray(values),
                                    dtype=_TEXT if is_text else None)
        return self.mark(made, "VectorData", description=words)
