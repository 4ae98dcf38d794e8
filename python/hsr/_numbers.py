"""Numbers as they are given: exactly, or refused."""

import math
import operator

import numpy

from . import _core


def finite(name, value):
    """A finite double."""
    try:
        x = float(value)
    except (TypeError, ValueError):
        raise _core.InputError(f"{name}: found {value!r}, expected a number") from None
    if not math.isfinite(x):
        raise _core.InputError(f"{name}: found {x}, expected a finite number")
    return x


def number_text(x):
    """The shortest text of a double, as one would write it: 1, not 1.0."""
    text = repr(float(x))
    return text[:-2] if text.endswith(".0") else text


def point_text(name, value):
    """ "x,y,z" as the command reads it, exactly."""
    try:
        coordinates = [finite(name, x) for x in value]
    except TypeError:
        raise _core.InputError(f"{name}: found {value!r}, expected three numbers") from None
    if len(coordinates) != 3:
        raise _core.InputError(f"{name}: found {len(coordinates)} numbers, expected three")
    return ",".join(number_text(x) for x in coordinates)


def doubles(name, values):
    """Points as (n, 3) float64, each the very number that was given.

    Floats of up to 64 bits widen exactly, whole numbers must be doubles; anything else is refused, and what is not finite by its
    index.
    """
    try:
        given = numpy.asarray(values)
    except ValueError:  # rows of several lengths
        given = numpy.empty(0, dtype=object)
    if given.size == 0 and given.dtype.kind in "fiu":
        given = given.reshape(-1, 3) if given.ndim < 2 else given
    if given.ndim != 2 or given.shape[1] != 3 or given.dtype.kind not in "fiu" or given.dtype.itemsize > 8:
        raise _core.InputError(f"{name}: found an array of shape {given.shape} and type {given.dtype}, expected (n, 3) numbers")
    points = numpy.ascontiguousarray(given, dtype=numpy.float64)
    if given.dtype.kind in "iu" and given.dtype.itemsize == 8:
        for k in numpy.flatnonzero((abs(points) >= 2.0**53).any(axis=1)):
            if any(int(x) != int(y) for x, y in zip(points[k], given[k])):
                raise _core.InputError(f"{name}, row {k}: found {given[k].tolist()}, expected whole numbers that are doubles")
    if not numpy.isfinite(points).all():
        row, column = numpy.argwhere(~numpy.isfinite(points))[0]
        raise _core.InputError(f"{name}, row {row}: found {'xyz'[column]} = {points[row, column]}, expected a finite number")
    return points


def indices(name, values):
    """Whole numbers from 0 on in one row of uint32, and the shape that they had."""
    given = numpy.asarray(values)
    if given.size == 0:
        return numpy.zeros(0, dtype=numpy.uint32), given.shape
    if given.dtype.kind not in "iu":
        raise _core.InputError(f"{name}: found numbers of type {given.dtype}, expected whole ones")
    flat = given.reshape(-1)
    if flat.min() < 0 or flat.max() > 0xFFFFFFFE:
        k = int(numpy.argmax((flat < 0) | (flat > 0xFFFFFFFE)))
        raise _core.InputError(f"{name}, entry {k}: found {int(flat[k])}, expected a number from 0 on")
    return numpy.ascontiguousarray(flat, dtype=numpy.uint32), given.shape


def count(name, value):
    """A whole number."""
    try:
        return operator.index(value)
    except TypeError:
        raise _core.InputError(f"{name}: found {value!r}, expected a whole number") from None
