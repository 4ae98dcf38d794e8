"""From where a scene is looked at."""

from . import _core
from ._numbers import finite, number_text, point_text

_NAMES = ("front", "back", "left", "right", "top", "bottom", "iso")


class View:
    """From where a scene is looked at: made by `View.named`, `View.parallel` or `View.perspective`.

    A view belongs to no scene: what it leaves open, such as the point looked at, each scene fills in. Lengths are in units of the
    scene, angles in degrees.

    >>> View.parallel((1, -2, 3))
    View.parallel(direction=(1, -2, 3))
    """

    __slots__ = ("_options", "_text")

    def __init__(self, options, text):
        self._options = options
        self._text = text

    def __repr__(self):
        return self._text

    def __eq__(self, other):
        return isinstance(other, View) and self._options == other._options

    def __hash__(self):
        return hash(tuple(sorted(self._options.items())))

    def with_section(self, *sections, depth=None):
        """This view of what sections leave: what is in front of all planes is taken away, and closed bodies are cut to caps.

        sections: planes, "x=12.5", or (point, normal), numbers taken exactly. Of a plane that is seen edge-on say what is left,
        "x=..12.5" or "x=12.5..", or let the normal point there. depth: leave out what is farther than this behind the first plane.
        The drawing, lines, fragments, orders and hidden points follow.

        >>> View.named("top").with_section("z=1.2")
        View.named(name="top").with_section("z=1.2")
        """
        if not sections:
            raise _core.InputError('section: found no plane, expected one such as "x=12.5"')
        texts, shown = zip(*(_section_texts(section) for section in sections))
        options = {**self._options, "sections": texts}
        options.pop("depth", None)
        if depth is not None:
            options["depth"] = finite("depth", depth)
            shown = (*shown, f"depth={number_text(options['depth'])}")
        return View(options, f"{self._text}.with_section({', '.join(shown)})")

    @staticmethod
    def named(name=None, *, target=None, up=None, up_axis=None, oblique=None):
        """A view by name: front, back, left, right, top, bottom, iso, or "camera:NAME" of a glTF file ["iso"; oblique: "front"].

        target: the point in the middle, by default that of the scene's bounding box; up: what is up on the paper; up_axis: "y" or
        "z", the scene's, which turns the view, never the scene [glTF: y, else z]; oblique: (degrees, ratio): the front stays true,
        and what recedes is drawn at that angle from the horizontal and so many times as long: (45, 1) cavalier, (45, 0.5) cabinet,
        with "top" (270, 1) planometric.
        """
        name = str(name or ("iso" if oblique is None else "front"))
        if name not in _NAMES and not name.startswith("camera:"):
            raise _core.InputError(f'view: found "{name}", expected one of {", ".join(_NAMES)}, or camera:NAME')
        return _view("named", name=name, target=target, up=up, up_axis=up_axis, oblique=oblique)

    @staticmethod
    def parallel(direction, *, up=None, target=None, up_axis=None, oblique=None):
        """A parallel view; `direction` (x, y, z), taken exactly, points from the scene toward the viewer. oblique: as at `named`."""
        return _view("parallel", direction=direction, up=up, target=target, up_axis=up_axis, oblique=oblique)

    @staticmethod
    def perspective(eye, *, target=None, up=None, fov=None, near=None, up_axis=None):
        """A perspective view from the point `eye`.

        fov: degrees across the shorter side of the picture, which frames drawings; nothing: all beyond the near plane. near: the
        distance of the near plane [a thousandth of that of the target].
        """
        return _view("perspective", eye=eye, target=target, up=up, fov=fov, near=near, up_axis=up_axis)


def _view(kind, **given):
    options = {}
    texts = []
    for name, value in given.items():
        if value is None:
            continue
        if name in ("eye", "target", "direction", "up"):
            options[name] = point_text(name, value)
            texts.append(f"{name}=({options[name].replace(',', ', ')})")
        elif name == "oblique":
            options[name] = _pair(name, value)
            texts.append(f"{name}=({options[name].replace(',', ', ')})")
        elif name in ("fov", "near"):
            options[name] = finite(name, value)
            texts.append(f"{name}={number_text(options[name])}")
        else:
            options[name] = str(value)
            texts.append(f'{name}="{value}"')
    if options.get("up_axis", "z") not in ("y", "z"):
        raise _core.InputError(f'up_axis: found "{options["up_axis"]}", expected y or z')
    return View(options, f"View.{kind}({', '.join(texts)})")


def _section_texts(section):
    """A plane as the command has it, and as it was given."""
    if isinstance(section, str):
        return section, f'"{section}"'
    try:
        point, normal = section
    except (TypeError, ValueError):
        raise _core.InputError(f'section: found {section!r}, expected a plane such as "x=12.5", or (point, normal)') from None
    return f"{point_text('normal', normal)}@{point_text('point', point)}", repr(section)


def _pair(name, value):
    try:
        degrees, ratio = value
    except (TypeError, ValueError):
        raise _core.InputError(f"{name}: found {value!r}, expected (degrees, ratio)") from None
    return f"{number_text(finite(name, degrees))},{number_text(finite(name, ratio))}"


def view_options(view):
    """The options of a view, or of the name of one."""
    if isinstance(view, View):
        return view._options
    if isinstance(view, str):
        return View.named(view)._options
    raise _core.InputError(f"view: found {type(view).__name__}, expected a name or a View")
