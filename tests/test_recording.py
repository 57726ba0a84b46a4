"""The header in front of a run that grows."""

import io

import numpy as np

from screwgen.simulation.recording import npy_header

KIND = np.dtype([("t", "<f8", ()), ("q", "<f8", (3,)), ("wrench", "<f8", (2, 6))])


def test_header_is_as_long_for_any_count():
    """It is written again in its place when records have been appended."""
    assert len({len(npy_header(KIND, count)) for count in (0, 1, 9, 10, 99_999, 10**8)}) == 1


def test_numpy_reads_records_that_were_appended():
    file, records = io.BytesIO(), np.zeros(12, KIND)
    records["t"], records["q"] = np.arange(12), np.arange(36).reshape(12, 3)
    file.write(npy_header(KIND, 0))
    for count in (5, 12):
        file.seek(0, io.SEEK_END)
        file.write(records[count - (5 if count == 5 else 7) : count].tobytes())
        file.seek(0)
        file.write(npy_header(KIND, count))
        file.seek(0)
        found = np.load(file)
        assert found.dtype == KIND and np.array_equal(found, records[:count])
