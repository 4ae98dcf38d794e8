import os
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str
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
    "tree",
    "verify",
    "visible_lines",
]

_Path = str | os.PathLike[str]
# A path, (V, F), (V, F, offsets), an object with such arrays, a Scene, or a list of these: see scene().
_Scene = Any
_View = str | View
_Progress = Callable[[float], object]
_Coplanar = Literal["first", "last"]
_Shade = Literal["slope", "none"]
_Unit = Literal["mm", "cm", "m", "in"]
_Pen = str | Sequence[str] | Mapping[str, float | str]

edge_class_names: tuple[str, ...]

class InputError(ValueError): ...
class PreconditionError(ValueError): ...
class InvariantError(RuntimeError): ...
class MemoryLimit(MemoryError): ...

class View:
    def with_section(self, *sections: str | tuple[ArrayLike, ArrayLike], depth: float | None = None) -> View: ...
    @staticmethod
    def named(
        name: str | None = None,
        *,
        target: ArrayLike | None = None,
        up: ArrayLike | None = None,
        up_axis: Literal["y", "z"] | None = None,
        oblique: tuple[float, float] | None = None,
    ) -> View: ...
    @staticmethod
    def parallel(
        direction: ArrayLike,
        *,
        up: ArrayLike | None = None,
        target: ArrayLike | None = None,
        up_axis: Literal["y", "z"] | None = None,
        oblique: tuple[float, float] | None = None,
    ) -> View: ...
    @staticmethod
    def perspective(
        eye: ArrayLike,
        *,
        target: ArrayLike | None = None,
        up: ArrayLike | None = None,
        fov: float | None = None,
        near: float | None = None,
        up_axis: Literal["y", "z"] | None = None,
    ) -> View: ...
    def __init__(self, options: dict[str, Any], text: str) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...

class Scene:
    def __init__(self, data: Any) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def format(self) -> str: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def objects(self) -> list[str]: ...
    @property
    def points(self) -> NDArray[numpy.float64]: ...
    @property
    def faces(self) -> tuple[NDArray[numpy.uint32], NDArray[numpy.uint32]]: ...

class VisibleLines:
    class_names: tuple[str, ...]
    edge: NDArray[numpy.int64]
    edge_class: NDArray[numpy.uint8]
    faces: NDArray[numpy.int64]
    faces_offsets: NDArray[numpy.int64]
    t: NDArray[numpy.float64]
    visible: NDArray[numpy.bool_]
    behind: NDArray[numpy.bool_]
    points: NDArray[numpy.float64]
    image: NDArray[numpy.float64]
    line: NDArray[numpy.int64]
    def __init__(self, data: Any) -> None: ...
    def __len__(self) -> int: ...
    def occluders(self, i: int) -> NDArray[numpy.int64]: ...
    def exact(self, i: int) -> tuple[Fraction, Fraction]: ...
    def exact_points(self, i: int) -> tuple[tuple[Fraction, Fraction, Fraction], tuple[Fraction, Fraction, Fraction]]: ...
    def polylines(self, visible: bool = True, join: bool = True) -> list[NDArray[numpy.float64]]: ...
    def json(self, exact: bool = False) -> str: ...

class Fragments:
    face: NDArray[numpy.int64]
    area: NDArray[numpy.float64]
    ring_offsets: NDArray[numpy.int64]
    offsets: NDArray[numpy.int64]
    points: NDArray[numpy.float64]
    image: NDArray[numpy.float64]
    def __init__(self, arrays: dict[str, Any]) -> None: ...
    def __len__(self) -> int: ...
    def polygons(self) -> list[list[NDArray[numpy.float64]]]: ...

class Section:
    object: NDArray[numpy.int64]
    face: NDArray[numpy.int64]
    plane: NDArray[numpy.int64]
    ring_offsets: NDArray[numpy.int64]
    offsets: NDArray[numpy.int64]
    points: NDArray[numpy.float64]
    image: NDArray[numpy.float64]
    open_outlines: int
    def __init__(self, arrays: dict[str, Any]) -> None: ...
    def __len__(self) -> int: ...
    def polygons(self) -> list[list[NDArray[numpy.float64]]]: ...
    def exact_points(self, ring: int) -> list[tuple[Fraction, ...]]: ...

class Order:
    face: NDArray[numpy.int64]
    offsets: NDArray[numpy.int64]
    points: NDArray[numpy.float64]
    image: NDArray[numpy.float64]
    original: NDArray[numpy.bool_]
    def __init__(self, data: Any) -> None: ...
    def __len__(self) -> int: ...
    def polygons(self) -> list[NDArray[numpy.float64]]: ...
    def exact_points(self, i: int) -> list[tuple[Fraction, Fraction, Fraction]]: ...
    def draw(
        self,
        output: _Path | Sequence[_Path] | None = None,
        *,
        opacity: float | None = None,
        shade: _Shade | None = None,
        edges: str | Sequence[str] | None = None,
        crease: float | None = None,
        page: str | tuple[float, float] | None = None,
        scale: str | float | None = None,
        unit: _Unit | None = None,
        margin: float | None = None,
        min_length: float | None = None,
        size: str | tuple[int, int] | None = None,
        pen: _Pen | None = None,
        pens: _Path | None = None,
        fit_arcs: float | None = None,
        id_prefix: str | None = None,
        exact: bool = False,
        threads: int | None = None,
        progress: _Progress | None = None,
    ) -> Drawing: ...
    def json(self, exact: bool = False) -> str: ...

class Tree:
    def __init__(self, data: Any) -> None: ...

class Drawing:
    def __init__(self, data: Any) -> None: ...
    def _repr_svg_(self) -> str: ...
    def svg(self) -> str: ...
    def png(self, size: tuple[int, int] | None = None) -> bytes: ...
    def written(self, format: Literal["svg", "pdf", "eps", "dxf", "tex", "hpgl", "plt", "png", "json"]) -> bytes: ...
    def polylines(self) -> list[tuple[NDArray[numpy.float64], bool, str]]: ...
    @property
    def width(self) -> float: ...
    @property
    def height(self) -> float: ...
    @property
    def scale(self) -> float: ...
    @property
    def fits(self) -> bool: ...
    @property
    def notes(self) -> list[str]: ...

class _Record:
    def __init__(self, fields: dict[str, Any]) -> None: ...
    def __bool__(self) -> bool: ...
    def __getattr__(self, name: str) -> Any: ...

class Verdict(_Record):
    ok: bool
    polygons: int
    overlapping: int
    wrong: int
    piercing: int
    covered_twice: int
    order_exists: bool
    cycle: list[int]
    cuts_that_suffice: int | None
    first: list[dict[str, Any]]

class Check(_Record):
    ok: bool
    samples: int
    covered: int
    wrong: int
    overlapping: int
    first_wrong: list[tuple[int, int, int, int]]

def scene(
    scene: _Scene,
    *,
    only: str | Sequence[str] | None = None,
    hide: str | Sequence[str] | None = None,
    ghost: str | Sequence[str] | None = None,
    chord: float | None = None,
    marks: _Path | None = None,
) -> Scene: ...
def draw(
    scene: _Scene,
    output: _Path | Sequence[_Path] | None = None,
    *,
    view: _View = "iso",
    hidden: Literal["none", "dashed", "solid"] = "none",
    overhead: Literal["dashed", "off"] = "off",
    edges: str | Sequence[str] | None = None,
    crease: float | tuple[float, float] | None = None,
    tolerance: float | None = None,
    fill: bool = False,
    shade: _Shade | None = None,
    merge: Literal["none", "coplanar", "colour"] | None = None,
    coplanar: _Coplanar | None = None,
    page: str | tuple[float, float] | None = None,
    scale: str | float | None = None,
    unit: _Unit | None = None,
    margin: float | None = None,
    min_length: float | None = None,
    size: str | tuple[int, int] | None = None,
    pen: _Pen | None = None,
    pens: _Path | None = None,
    sort: Literal["none", "pen"] | None = None,
    fit_arcs: float | None = None,
    outline_only: bool = False,
    dxf: Literal["r12", "2000"] | None = None,
    id_prefix: str | None = None,
    exact: bool = False,
    why: bool = False,
    method: Literal["auto", "appel", "roberts"] | None = None,
    stages: str | Mapping[str, Literal["auto", "always", "never"]] | None = None,
    arithmetic: Literal["staged", "double", "interval", "rational"] | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> Drawing: ...
def sheet(
    scene: _Scene,
    output: _Path | Sequence[_Path] | None = None,
    *,
    page: Literal["A0", "A1", "A2", "A3", "A4", "ANSI-A", "ANSI-B"] | None = None,
    angle: Literal["first", "third"] | None = None,
    scale: str | float | None = None,
    unit: _Unit | None = None,
    up_axis: Literal["y", "z"] | None = None,
    views: str | Sequence[Literal["front", "top", "side", "iso"]] | None = None,
    section: str | Sequence[str] | None = None,
    detail: str | Sequence[str] | None = None,
    title: dict[str, str] | None = None,
    title_block: _Path | None = None,
    dimensions: bool | None = None,
    centre_lines: bool | None = None,
    hidden: Literal["none", "dashed", "solid"] | None = None,
    edges: str | Sequence[str] | None = None,
    crease: float | tuple[float, float] | None = None,
    tolerance: float | None = None,
    coplanar: _Coplanar | None = None,
    pen: _Pen | None = None,
    fit_arcs: float | None = None,
    dxf: Literal["r12", "2000"] | None = None,
    size: str | tuple[int, int] | None = None,
    method: Literal["auto", "appel", "roberts"] | None = None,
    stages: str | dict[str, str] | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> Drawing: ...
def visible_lines(
    scene: _Scene,
    view: _View = "iso",
    *,
    edges: str | Sequence[str] | None = None,
    crease: float | tuple[float, float] | None = None,
    tolerance: float | None = None,
    coplanar: _Coplanar | None = None,
    method: Literal["auto", "appel", "roberts"] | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> VisibleLines: ...
def fragments(
    scene: _Scene,
    view: _View = "iso",
    *,
    coplanar: _Coplanar | None = None,
    method: Literal["auto", "roberts"] | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> Fragments: ...
def section(
    scene: _Scene, view: _View, *, threads: int | None = None, progress: _Progress | None = None
) -> Section: ...
def tree(
    scene: _Scene, *, seed: int | None = None, threads: int | None = None, progress: _Progress | None = None
) -> Tree: ...
def order(
    scene: _Scene | Tree,
    view: _View = "iso",
    *,
    method: Literal["depth-sort", "bsp", "z-sort", "naive"] | None = None,
    cuts: Literal["few", "classic"] | None = None,
    seed: int | None = None,
    coplanar: _Coplanar | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> Order: ...
def project_to_viewport(
    shape_mesh: _Scene,
    viewport_origin: ArrayLike,
    viewport_up: ArrayLike = (0, 0, 1),
    look_at: ArrayLike | None = None,
    focus: float | None = None,
    *,
    edges: str | Sequence[str] | None = None,
    crease: float | tuple[float, float] | None = None,
    tolerance: float | None = None,
    coplanar: _Coplanar | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> tuple[list[NDArray[numpy.float64]], list[NDArray[numpy.float64]]]: ...
def verify(
    order: Order | _Scene,
    view: _View = "iso",
    *,
    limit: int | None = None,
    coplanar: _Coplanar | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> Verdict: ...
def hidden(
    points: ArrayLike,
    scene: _Scene,
    view: _View = "iso",
    *,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> NDArray[numpy.bool_]: ...
def check(
    scene: _Scene,
    view: _View = "iso",
    *,
    size: str | tuple[int, int] | None = None,
    coplanar: _Coplanar | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> Check: ...
def cast(
    scene: _Scene,
    view: _View = "iso",
    *,
    size: str | tuple[int, int] | None = None,
    coplanar: _Coplanar | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> NDArray[numpy.int64]: ...
