"""Arguments as the core takes them: one dict of words and numbers by name."""

import os

from . import _core
from ._numbers import count, finite, number_text
from ._view import view_options


def arguments(view, *, threads=None, progress=None, **others):
    """The arguments that are given, each checked and spelled as the command spells it. view: None where there is none."""
    named = {} if view is None else {"view": view_options(view)}
    if threads is not None:
        named["threads"] = count("threads", threads)
    if progress is not None:
        if not callable(progress):
            raise _core.InputError(f"progress: found {progress!r}, expected a function of one number")
        named["progress"] = progress
    for name, value in others.items():
        if value is not None:
            named[name] = _SPELLED.get(name, _word)(name, value)
    return named


def paths(output):
    """One path, or several, as a list of them."""
    several = output if isinstance(output, (list, tuple)) else [output]
    return [os.fspath(path) for path in several]


def _word(name, value):
    if not isinstance(value, str):
        raise _core.InputError(f"{name}: found {value!r}, expected a word")
    return value


def _flag(name, value):
    if value not in (True, False):
        raise _core.InputError(f"{name}: found {value!r}, expected True or False")
    return bool(value)


def _edges(name, value):
    return value if isinstance(value, str) else ",".join(_word(name, part) for part in value)


def _crease(name, value):
    angles = value if isinstance(value, (list, tuple)) else [value]
    return ",".join(number_text(finite(name, angle)) for angle in angles)


def _size(name, value):
    if isinstance(value, str):
        return value
    try:
        width, height = value
    except (TypeError, ValueError):
        raise _core.InputError(f"{name}: found {value!r}, expected (width, height)") from None
    return f"{count(name, width)}x{count(name, height)}"


def _scale(name, value):
    return value if isinstance(value, str) else f"{number_text(finite(name, value))}:1"


def _page(name, value):
    if isinstance(value, str):
        return value
    width, height = value
    return f"{number_text(finite(name, width))}x{number_text(finite(name, height))}mm"


def _number(name, value):
    return number_text(finite(name, value))


def _strings(name, value):
    return value


def _pen(name, value):
    if isinstance(value, dict):
        return [f"{pen}={setting if isinstance(setting, str) else number_text(finite(name, setting))}" for pen, setting in value.items()]
    return [_word(name, part) for part in ([value] if isinstance(value, str) else value)]


def _stages(name, value):
    if isinstance(value, dict):
        return ",".join(f"{_word(name, stage)}={_word(name, when)}" for stage, when in value.items())
    return _word(name, value)


def _list(name, value):
    return value if isinstance(value, str) else ",".join(_word(name, part) for part in value)


def _several(name, value):
    return [_word(name, part) for part in ([value] if isinstance(value, str) else value)]


def _title(name, value):
    if not isinstance(value, dict):
        raise _core.InputError(f"{name}: found {value!r}, expected a dict of texts")
    return [f"{_word(name, field)}={_word(name, text)}" for field, text in value.items()]


def _path(name, value):
    try:
        return os.fspath(value)
    except TypeError:
        raise _core.InputError(f"{name}: found {value!r}, expected a path") from None


_SPELLED = {
    "edges": _edges,
    "crease": _crease,
    "size": _size,
    "scale": _scale,
    "page": _page,
    "fill": _flag,
    "why": _flag,
    "outline_only": _flag,
    "in_frame_units": _flag,
    "pen": _pen,
    "pens": _path,
    "exact": _flag,
    "margin": finite,
    "min_length": finite,
    "tolerance": finite,
    "opacity": finite,
    "fit_arcs": _number,
    "stages": _stages,
    "views": _list,
    "section": _several,
    "detail": _several,
    "title": _title,
    "title_block": _path,
    "dimensions": _flag,
    "centre_lines": _flag,
    "seed": count,
    "limit": count,
    "outputs": _strings,
}
