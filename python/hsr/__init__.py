"""What is visible, exactly: drawings of polygon scenes with hidden lines removed, as files and as arrays.

Every function takes a scene and a view. A scene is the path of a file, arrays (V, F), an object with such arrays, or a list of
these (`scene` lists them all); a view is a name such as "iso", or a `View`. Every decision about what hides what is exact; numbers in
results are rounded once, correctly, and are the same for any number of threads.

    threads: at most so many [all]
    progress: a function of the share done, 0 ... 1, called now and then on the caller's thread; what it raises ends the work
    coplanar: of faces that coincide the "first" in the scene is on top, or the "last" ["first"]
    edges: "all", or classes of edges, as a list or with commas ["outline,sharp,boundary,intersection,wire,material,section,hatching"]
    crease: degrees; edges that deviate more from flat are sharp; or two, such as (30, 25) [30]
    tolerance: noise of the scene, in its units, that classes of edges pass over [0]

Ctrl-C ends the work. Errors are a `ValueError` (`InputError`, `PreconditionError`), a `MemoryError` (`MemoryLimit`) or, a defect of hsr,
`InvariantError`; each says in one line what was found and what was expected.
"""

from . import _core
from ._arguments import arguments, paths
from ._core import InputError, InvariantError, MemoryLimit, PreconditionError
from ._numbers import doubles as _doubles
from ._results import CLASS_NAMES as edge_class_names
from ._results import Check, Drawing, Fragments, Order, Section, Tree, Verdict, VisibleLines
from ._scene import Scene, scene
from ._scene import scene_data as _scene_data
from ._view import View
from ._viewport import project_to_viewport

__version__ = _core.version
__all__ = [
    "Check",
    "Drawing",
    "Fragments",
    "InputError",
    "InvariantError",
    "MemoryLimit",
    "Order",
    "PreconditionError",
    "Scene",
    "Section",
    "Tree",
    "Verdict",
    "View",
    "VisibleLines",
    "cast",
    "check",
    "draw",
    "edge_class_names",
    "fragments",
    "hidden",
    "order",
    "project_to_viewport",
    "scene",
    "section",
    "sheet",
    "tree",
    "verify",
    "visible_lines",
]


def draw(
    scene,
    output=None,
    *,
    view="iso",
    hidden="none",
    overhead="off",
    edges=None,
    crease=None,
    tolerance=None,
    fill=False,
    shade=None,
    merge=None,
    coplanar=None,
    page=None,
    scale=None,
    unit=None,
    margin=None,
    min_length=None,
    size=None,
    pen=None,
    pens=None,
    sort=None,
    fit_arcs=None,
    outline_only=False,
    dxf=None,
    id_prefix=None,
    exact=False,
    why=False,
    method=None,
    stages=None,
    arithmetic=None,
    threads=None,
    progress=None,
):
    """Draws the visible lines of a scene on a page, and writes them as the command `hsr draw` does, byte by byte.

    output: a path, or a list of them, all written or none; the ending chooses svg, pdf, eps, dxf, tex (TikZ), hpgl (or plt), png
    or json. Nothing: no file is written
    hidden: "none", "dashed" or "solid"; overhead: "dashed" shows what the section of the view takes away, or "off"
    fill: fill the visible parts of faces; shade: "slope" or "none"; merge: with fill, unite neighbours of one colour: "none",
    "coplanar" or "colour"
    page: "A0" ... "A6", "letter", "WIDTHxHEIGHTmm", (width, height) in mm, or "fit" ["A4"]; margin: mm [10]; scale: "1:5", a
    number, "standard", or "fit"; unit: of the scene, "mm", "cm", "m" or "in" [glTF: "m", else "mm"]; min_length: mm on paper, of what is left out
    pen: "visible=0.35,hidden-sharp=0.18:#555", a list of such, or a dict of widths; pens: a file of them; sort: "pen" for a plotter
    fit_arcs: mm on paper, within which edges that lie on one circle in space are drawn as arcs
    outline_only: the outline of everything alone, as closed rings; id_prefix: SVG, what each id begins with
    dxf: the release, "r12" or "2000", with line weights; a DXF is in units of the scene, whatever the page
    size: PNG, (width, height) in pixels; exact: JSON, numbers as "p/q"; why: JSON, which faces hide each part
    method: "auto", "appel" or "roberts"; stages: "STAGE=WHEN,..." or a dict, of frame, convex-body, back-faces, hidden-tiles,
    far-faces and all, each auto, always or never; the result is the same
    arithmetic: "staged", or for comparison "double" (may be wrong), "interval" or "rational". All others are said at the module.

    Returns a `Drawing`. Raises InputError for what cannot be drawn or written.

    >>> cube = ([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)],
    ...         [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    >>> drawing = draw(cube, scale="10:1", page="fit", margin=5)
    >>> drawing
    <hsr.Drawing: 24.143 x 26.33 mm>
    >>> sorted({name for points, hidden, name in drawing.polylines()})
    ['outline', 'sharp']
    """
    named = arguments(
        view,
        threads=threads,
        progress=progress,
        outputs=None if output is None else paths(output),
        hidden=hidden,
        overhead=overhead,
        edges=edges,
        crease=crease,
        tolerance=tolerance,
        fill=fill,
        shade=shade,
        merge=merge,
        coplanar=coplanar,
        page=page,
        scale=scale,
        unit=unit,
        margin=margin,
        min_length=min_length,
        size=size,
        pen=pen,
        pens=pens,
        sort=sort,
        fit_arcs=fit_arcs,
        outline_only=outline_only,
        dxf=dxf,
        id_prefix=id_prefix,
        exact=exact,
        why=why,
        method=method,
        stages=stages,
        arithmetic=arithmetic,
    )
    return Drawing(_core.draw(_scene_data(scene), named))


def sheet(
    scene,
    output=None,
    *,
    page=None,
    angle=None,
    scale=None,
    unit=None,
    up_axis=None,
    views=None,
    section=None,
    detail=None,
    title=None,
    title_block=None,
    dimensions=None,
    centre_lines=None,
    hidden=None,
    edges=None,
    crease=None,
    tolerance=None,
    coplanar=None,
    pen=None,
    fit_arcs=None,
    dxf=None,
    size=None,
    method=None,
    stages=None,
    threads=None,
    progress=None,
):
    """Draws several views on one sheet with frame and title block, and writes it as the command `hsr sheet` does, byte by byte.

    output: a path, or a list of them, all written or none; the ending chooses pdf, svg, eps, dxf, tex, hpgl (or plt), png, or json,
    which says where views and dimensions are. Nothing: no file is written
    page: "A0" ... "A4", "ANSI-A" or "ANSI-B" ["A3"]; angle: "first" or "third" [ANSI: third, else first]; scale: "1:5", a number, or
    "standard", the largest of 1:1, 1:2, 1:5, ..., 2:1, ... that fits; unit: of the scene; up_axis: "y" or "z"
    views: some of "front", "top", "side" and "iso" [all]; section: "x=12.5" or "NX,NY,NZ@X,Y,Z", or a list of them, each drawn as A-A,
    B-B, ...; detail: "front:X,Y,Z:RADIUS:SCALE", or a list of them
    title: a dict of texts: owner, title, subtitle, number, creator, approver, type, material, date, revision, language, sheet;
    title_block: a file of them, as JSON
    dimensions: overall ones [True]; centre_lines: of circles, and axes [True]; hidden: "dashed", "none" or "solid"
    All others as for draw().

    Returns a `Drawing`. Raises InputError for what cannot be drawn or written.

    >>> cube = ([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)],
    ...         [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    >>> sheet(cube, title={"title": "Cube"}, section="x=0.5")
    <hsr.Drawing: 420 x 297 mm>
    >>> import json
    >>> [view["name"] for view in json.loads(_.written("json"))["views"]]
    ['front', 'top', 'side', 'A-A', 'iso']
    """
    named = arguments(
        None,
        threads=threads,
        progress=progress,
        outputs=None if output is None else paths(output),
        page=page,
        angle=angle,
        scale=scale,
        unit=unit,
        up_axis=up_axis,
        views=views,
        section=section,
        detail=detail,
        title=title,
        title_block=title_block,
        dimensions=dimensions,
        centre_lines=centre_lines,
        hidden=hidden,
        edges=edges,
        crease=crease,
        tolerance=tolerance,
        coplanar=coplanar,
        pen=pen,
        fit_arcs=fit_arcs,
        dxf=dxf,
        size=size,
        method=method,
        stages=stages,
    )
    return Drawing(_core.sheet(_scene_data(scene), named))


def visible_lines(
    scene, view="iso", *, edges=None, crease=None, tolerance=None, coplanar=None, method=None, threads=None, progress=None
):
    """The visible and the hidden parts of edges, and of the lines where faces pierce each other: `VisibleLines`, arrays.

    Exact. Source: Roberts 1963, Appel 1967. Raises InputError.

    >>> floor, roof = [[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0]], [[1, -1, 1], [2, -1, 1], [2, 3, 1], [1, 3, 1]]
    >>> lines = visible_lines((floor + roof, [[0, 1, 2, 3], [4, 5, 6, 7]]), "top")
    >>> lines
    <hsr.VisibleLines: 10 visible parts, 2 hidden>
    >>> hidden = ~lines.visible
    >>> lines.edge[hidden].tolist(), lines.t[hidden].tolist()
    ([[0, 1], [2, 3]], [[0.25, 0.5], [0.5, 0.75]])
    >>> lines.exact(1), lines.occluders(1)
    ((Fraction(1, 4), Fraction(1, 2)), array([1]))
    """
    named = arguments(
        view,
        threads=threads,
        progress=progress,
        edges=edges,
        crease=crease,
        tolerance=tolerance,
        coplanar=coplanar,
        method=method,
    )
    return VisibleLines(_core.visible_lines(_scene_data(scene), named))


def fragments(scene, view="iso", *, coplanar=None, method=None, threads=None, progress=None):
    """The visible part of each face as polygons with holes: `Fragments`, arrays.

    method: "auto", or "roberts": by subtracting shadows, the reference, slower. Exact. Raises InputError.

    >>> floor, roof = [[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0]], [[1, 0, 1], [2, 0, 1], [2, 2, 1], [1, 2, 1]]
    >>> seen = fragments((floor + roof, [[0, 1, 2, 3], [4, 5, 6, 7]]), "top")
    >>> seen.face.tolist(), sorted(seen.area.tolist())
    ([0, 0, 1], [2.0, 2.0, 4.0])
    """
    named = arguments(view, threads=threads, progress=progress, coplanar=coplanar, method=method)
    return Fragments(_core.fragments(_scene_data(scene), named))


def section(scene, view, *, threads=None, progress=None):
    """What the section of a view, `View.with_section`, cuts closed bodies to: `Section`, arrays. Exact.

    >>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> cut = section((cube, faces), View.named("top").with_section("z=0.5"))
    >>> cut
    <hsr.Section: 1 caps, 1 rings>
    >>> len(cut.exact_points(0))
    4
    """
    return Section(_core.section(_scene_data(scene), arguments(view, threads=threads, progress=progress)))


def tree(scene, *, seed=None, threads=None, progress=None):
    """A tree of planes that orders the scene for any view: `order(tree, view)`. Source: Fuchs, Kedem & Naylor 1980.

    seed: of the planes that are tried [1]. Raises InputError beyond a million pieces, or 64 a face.
    """
    return Tree(_core.tree(_scene_data(scene), arguments("iso", threads=threads, progress=progress, seed=seed)))


def order(scene, view="iso", *, method=None, cuts=None, seed=None, coplanar=None, threads=None, progress=None):
    """The faces from far to near, cut where no order of whole ones is right: `Order`, arrays, and `Order.draw` for pages.

    scene: or a `tree` of one; method: "depth-sort" (few cuts; Newell, Newell & Sancha 1972) or "bsp" (a tree with this seed), which
    are exact; or what most software does and may be wrong, for comparison: "z-sort" (by the farthest vertex), "naive" (by the middle)
    cuts: "few", or "classic": every pair that no plane of the two separates. Raises InputError beyond the most pieces.

    >>> a, b = [[-2, -1, 0], [2, -1, 0], [0, 3, 0]], [[-2, 1, -1], [2, 1, -1], [0, -2, 2]]
    >>> pieces = order((a + b, [[0, 1, 2], [3, 4, 5]]), "top")
    >>> pieces
    <hsr.Order: 3 pieces of 2 faces>
    >>> verify(pieces).ok
    True
    """
    named = arguments(view, threads=threads, progress=progress, method=method, cuts=cuts, seed=seed, coplanar=coplanar)
    if isinstance(scene, Tree):
        return Order(scene._data.order(named))
    return Order(_core.order(_scene_data(scene), named))


def verify(order, view="iso", *, limit=None, coplanar=None, threads=None, progress=None):
    """Whether a painting order is right, far to near: a `Verdict`, with a witness where it is not.

    order: an `Order`; the path of an "hsr-order/1" file by anyone, which has its view; or any scene, whose faces are painted in
    their order, in `view`. limit: violations to describe [10]. Exact. Raises InputError.

    >>> low, high = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[1, 1, 1], [3, 1, 1], [3, 3, 1], [1, 3, 1]]
    >>> verdict = verify((high + low, [[0, 1, 2, 3], [4, 5, 6, 7]]), "top")
    >>> verdict.ok, verdict.wrong, verdict.first[0]["fault"]
    (False, 1, 'order')
    """
    named = arguments(view, threads=threads, progress=progress, limit=limit, coplanar=coplanar)
    if isinstance(order, Order):
        return Verdict(_core.verify_order(order._data, named))
    if isinstance(order, (str, bytes)) or hasattr(order, "__fspath__"):
        (path,) = paths(order)
        if path.lower().endswith(".json"):
            return Verdict(_core.verify_file(path, named))
    return Verdict(_core.verify_scene(_scene_data(order), named))


def hidden(points, scene, view="iso", *, threads=None, progress=None):
    """Of each point (n, 3), whether a face hides it: (n,) bool.

    A point on a face is not hidden by it; what the near plane cuts off is hidden by nothing. Exact. Raises InputError.

    >>> hidden([[0, 0, -1], [0, 0, 0], [9, 9, -1]], ([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], [[0, 1, 2]]), "top").tolist()
    [True, False, False]
    """
    named = arguments(view, threads=threads, progress=progress)
    return _core.hidden(_scene_data(scene), _doubles("points", points), named)


def check(scene, view="iso", *, size=None, coplanar=None, threads=None, progress=None):
    """The fragments of a scene compared with the nearest face at each of size (width, height) samples [(1024, 1024)]: a `Check`.

    >>> check(([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]]), "top", size=(64, 64)).ok
    True
    """
    found = _core.check(_scene_data(scene), arguments(view, threads=threads, progress=progress, size=size, coplanar=coplanar))
    return Check({"ok": found["wrong"] == 0 and found["overlapping"] == 0, **found})


def cast(scene, view="iso", *, size=None, coplanar=None, threads=None, progress=None):
    """The nearest face at each sample of a picture of size (width, height) [(1024, 1024)]: (height, width) int64, -1 for none.

    The picture shows all of the scene, or what the view's fov frames; row 0 is its top. Exact: no z-buffer.

    >>> cast(([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2, 3]]), "top", size=(2, 2)).tolist()
    [[0, 0], [0, 0]]
    """
    return _core.cast(_scene_data(scene), arguments(view, threads=threads, progress=progress, size=size, coplanar=coplanar))
