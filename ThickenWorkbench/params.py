# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a Thicken feature: their table, what they mean to the library, migrations.

Documents store these names: renaming or removing one needs a migration and a new SCHEMA_VERSION.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Iterable

from .sources import DEFAULT_DEFLECTION, face_names, kind_of

if TYPE_CHECKING:
    from thicken.arrays import ThickenedMesh

SCHEMA_VERSION = 3

# App::PropertyType by value: FreeCAD has no names for it in Python.
_READ_ONLY = 1
_HIDDEN = 4
_OUTPUT = 8  # changing it does not touch the document

# The first choice is the one a new feature has. Lower-case, they are the library's own words.
SIDES = ["Negative", "Positive", "Both"]
METHODS = ["Auto", "Sweep", "Reconstruct"]
SIMPLIFY = ["Auto", "Off", "Shell"]

# What the shell is like outside of convex edges, as FreeCAD's own Thickness calls it, and the library's word.
JOIN_WORD = {"Automatic": None, "Intersection": "mitre", "Arc": "round"}
JOINS = list(JOIN_WORD)

# The lengths of the profile of the rim, in the library's words, and their properties.
RIM = {"rim_thickness": "RimThickness", "rim_width": "RimWidth", "rim_round": "RimRound"}

# What decides how fine the result is, and the property that holds the number for it.
QUALITY_NUMBER = {"Standard": None, "Draft": None, "Fine": None, "Cell": "Cell", "Resolution": "Resolution",
                  "Tolerance": "Tolerance"}  # fmt: skip

# The cells of a quality that is a word, as a share of the thickness; without one the library chooses. Below 1/2
# is what it allows. Chosen by a bone of 8,900 triangles at 3 mm (docs/freecad.md has what they give).
QUALITY_CELL = {"Draft": 0.4, "Fine": 1 / 12}
QUALITIES = [word.lower() for word in QUALITY_NUMBER if QUALITY_NUMBER[word] is None]


@dataclass(frozen=True)
class Property:
    """One property: FreeCAD's type, its place in the editor, the value that it starts with."""

    name: str
    type: str
    group: str
    doc: str
    start: Any = None  #: None: FreeCAD's own; a list: the choices of an enumeration
    attributes: int = 0
    report: str = ""  #: a result: the path of its value in the report (docs/report.md)


def _input(name: str, kind: str, group: str, doc: str, start: Any = None) -> Property:
    return Property(name, "App::Property" + kind, group, doc, start)


def _hidden(name: str, kind: str, doc: str) -> Property:
    """An input that only commands and macros set."""
    return Property(name, "App::Property" + kind, "Internal", doc, (), _HIDDEN)


def _result(name: str, kind: str, report: str, doc: str, start: Any = 0) -> Property:
    return Property(name, "App::Property" + kind, "Result", doc, start, _READ_ONLY | _OUTPUT, report)


INPUTS = [
    _input("Source", "Link", "Thicken", "The mesh or shape to thicken; every triangle of it is kept"),
    _input("SourceFaces", "LinkSub", "Thicken", "The faces of the Source to thicken; none: all of them"),
    _input("Facets", "IntegerList", "Thicken", "The facets of the Source to thicken; none: all of them"),
    _input("Thickness", "Length", "Thicken", "How thick the solid is", 1.0),
    _input("Gap", "Length", "Thicken", "The solid begins so far from the surface; 0: at the surface itself", 0.0),
    _input("RimThickness", "Length", "Rim", "How thick the solid is at the rim of the surface; 0: as elsewhere", 0.0),
    _input("RimWidth", "Length", "Rim", "How far from the rim the solid is as thick as elsewhere; together with RimThickness", 0.0),
    _input("RimRound", "Length", "Rim", "The radius of the edge between shell and wall; 0: sharp", 0.0),
    _input("Side", "Enumeration", "Thicken", "Where the material lies; normals point to the positive side", SIDES),
    _input("Method", "Enumeration", "Thicken", "How the solid is computed", METHODS),
    _input("Join", "Enumeration", "Thicken", "Outside of convex edges: planes that meet (Intersection) or a rounding (Arc)", JOINS),
    _input("Repair", "Bool", "Thicken", "Mend a defective mesh first", False),
    _input("Quality", "Enumeration", "Quality", "How fine the result is: a word, or the number that decides it", list(QUALITY_NUMBER)),
    _input("Cell", "Length", "Quality", "Cell width, below half the thickness", 0.25),
    _input("Resolution", "Integer", "Quality", "Cells along the longest side of the bounding box", 128),
    _input("Tolerance", "Length", "Quality", "The farthest that the inner shell may be from its definition", 0.05),
    _input("Smooth", "Integer", "Quality", "Rounds of smoothing of the inner shell; -1: as many as it takes", -1),
    _input("Simplify", "Enumeration", "Quality", "Which of the new triangles are merged into fewer", SIMPLIFY),
    _input("Deflection", "Length", "Quality", "The farthest that the triangles of a shape may be from it",
           DEFAULT_DEFLECTION),
    _input("RegionThickness", "FloatList", "Thickness regions", "The thickness of each region of facets with one of its own, mm", ()),
    _input("Transition", "Length", "Thickness regions", "The thickness changes linearly over this distance around the regions", 5.0),
    _hidden("RegionSizes", "IntegerList", "How many facets each region has"),
    _hidden("RegionCorners", "VectorList", "The corners of these facets, in the coordinates of the Source without its Placement"),
]

RESULTS = [
    _result("Valid", "Bool", "audit.passed", "Whether there is a solid; it has been proved valid", False),
    _result("Volume", "Volume", "output.volume_mm3", "Volume of the solid"),
    _result("Area", "Area", "output.area_mm2", "Area of its whole boundary"),
    _result("ShellError", "Float", "shell_error.p99",
            "Deviation from the thickness, as a share of it, that 99 % of the inner shell stays below"),
    _result("ShellErrorMean", "Float", "shell_error.mean", "Mean deviation, as a share of the thickness"),
    _result("ShellErrorMax", "Float", "shell_error.max", "Largest deviation, as a share of the thickness"),
    _result("ThinnestWall", "Length", "thinnest_wall.mm", "Least distance between the surface and its shell"),
    _result("ThinnestPlace", "Vector", "thinnest_wall.place_mm", "That place, without the Placement", (0, 0, 0)),
    _result("ThinShare", "Float", "thin_share", "Share of the mesh's area with less than 0.9 of the thickness"),
    _result("TriangleCount", "Integer", "output.triangles", "Triangles of the solid"),
    _result("OriginalTriangles", "Integer", "output.original_triangles", "Triangles that are the mesh's own"),
    _result("ShellTriangles", "Integer", "output.shell_triangles", "Triangles of the inner shell"),
    _result("WallTriangles", "Integer", "output.wall_triangles", "Triangles of the wall at the rim"),
    _result("DroppedCopies", "Integer", "output.dropped_copies", "Points without a counterpart on the shell"),
    _result("UsedMethod", "String", "output.made_by", "The method that made the solid", ""),
    _result("Warnings", "StringList", "warnings", "What to know about the solid", ()),
]  # fmt: skip

# Lengths of the runs of triangles of one region: region, count, region, count, …
_REGION_RUNS = Property("RegionRuns", "App::PropertyIntegerList", "Internal", "Regions of the triangles", (),
                        _READ_ONLY | _HIDDEN | _OUTPUT)  # fmt: skip
# build.fingerprint() of the solid that is there.
_COMPUTED_FOR = Property("ComputedFor", "App::PropertyString", "Internal", "What the solid was made from", "",
                         _READ_ONLY | _HIDDEN | _OUTPUT)  # fmt: skip


def _name_qualities(obj: Any) -> None:
    """Schema 1 had no draft and no fine; what is the standard was called automatic."""
    chosen = obj.Quality
    obj.Quality = list(QUALITY_NUMBER)
    obj.Quality = "Standard" if chosen == "Automatic" else chosen


def _leave_join(obj: Any) -> None:
    """Schema 2 had no Join; the one that a new property starts with is what was done."""


# MIGRATIONS[n] turns a feature of schema n into one of schema n + 1.
MIGRATIONS: dict[int, Callable[[Any], None]] = {1: _name_qualities, 2: _leave_join}


def ensure_properties(obj: Any) -> None:
    """Add the properties that `obj` lacks; idempotent."""
    for prop in [*INPUTS, *RESULTS, _REGION_RUNS, _COMPUTED_FOR]:
        if prop.name not in obj.PropertiesList:
            obj.addProperty(prop.type, prop.name, prop.group, prop.doc, prop.attributes)
            if prop.start is not None:
                setattr(obj, prop.name, prop.start)
    obj.setEditorMode("Placement", 1)  # it follows the source's
    show_quality(obj)


def show_quality(obj: Any) -> None:
    """Show only the number that the chosen Quality uses."""
    chosen = QUALITY_NUMBER.get(obj.Quality)  # a document of an earlier schema may have another word still
    for name in filter(None, QUALITY_NUMBER.values()):
        obj.setEditorMode(name, 0 if name == chosen else 2)


def set_inputs(
    obj: Any, *, side: str, method: str, join: str, repair: bool, smooth: int | None, simplify: str, quality: str,
    gap: Any = 0, rim: dict[str, Any] | None = None, **numbers: Any,
) -> None:
    """Set what make_thicken() takes of numbers; of `numbers` (cell, resolution, tolerance) at most one is not None."""
    given = {name.capitalize(): value for name, value in numbers.items() if value is not None}
    word = _choice("quality", quality, [q.capitalize() for q in QUALITIES])
    if given and word != "Standard":
        raise ValueError(f"give quality or {', '.join(given).lower()}, not both")
    if len(given) > 1:
        raise ValueError(f"give one of cell, resolution and tolerance, not {' and '.join(given).lower()}")
    obj.Side = _choice("side", side, SIDES)
    obj.Method = _choice("method", method, METHODS)
    obj.Join = _choice("join", join, JOINS)
    obj.Repair = bool(repair)
    obj.Gap = gap
    for of_rim, length in (rim or {}).items():
        setattr(obj, RIM[of_rim], length)
    obj.Simplify = _choice("simplify", simplify, SIMPLIFY)
    if smooth is not None:
        if not 0 <= smooth <= 100:
            raise ValueError(f"smooth must be 0 to 100 rounds, not {smooth}")
        obj.Smooth = smooth
    obj.Quality = next(iter(given), word)
    for name, value in given.items():
        setattr(obj, name, value)


def _choice(what: str, word: str, choices: list[str]) -> str:
    by_word = {choice.lower(): choice for choice in choices}
    if str(word).lower() not in by_word:
        raise ValueError(f"{what} must be one of {', '.join(by_word)}, not {word!r}")
    return by_word[str(word).lower()]


def arguments(obj: Any, thickness: Any = None) -> dict[str, Any]:
    """The arguments of thicken_mesh() that the inputs of `obj` stand for; `thickness`: for each vertex, in place of its Thickness."""
    result = {
        "thickness": obj.Thickness.Value if thickness is None else thickness,
        "side": obj.Side.lower(),
        "method": obj.Method.lower(),
        "repair": obj.Repair,
        "precision": "single",  # that of FreeCAD's meshes
    }
    if obj.Smooth >= 0:
        result["smooth"] = obj.Smooth
    result |= join_arguments(obj.Join)
    if obj.Gap.Value > 0:
        result["gap"] = obj.Gap.Value
    result |= {word: length.Value for word, name in RIM.items() if (length := getattr(obj, name)).Value > 0}
    if obj.Simplify != SIMPLIFY[0]:
        result["simplify"] = obj.Simplify.lower()
    chosen = QUALITY_NUMBER[obj.Quality]
    number = getattr(obj, chosen) if chosen is not None else None
    return {**result, **quality_arguments(obj.Quality, getattr(number, "Value", number), result["thickness"])}


def join_arguments(join: str) -> dict[str, Any]:
    """The argument of thicken_mesh() that a Join stands for, if it is not the library that chooses."""
    word = JOIN_WORD[join]
    return {} if word is None else {"join": word}


def quality_arguments(quality: str, number: Any, thickness: Any) -> dict[str, Any]:
    """The arguments of thicken_mesh() that a Quality with its number stands for; of many thicknesses the least decides."""
    chosen = QUALITY_NUMBER[quality]
    if chosen is not None:
        return {chosen.lower(): number}
    if quality not in QUALITY_CELL:
        return {}
    import numpy as np

    return {"cell": QUALITY_CELL[quality] * float(np.min(thickness))}


def set_choice(obj: Any, source: Any, faces: Iterable[Any], facets: Iterable[int], deflection: Any) -> None:
    """Set what of `source` is thickened, as make_thicken() takes it."""
    names = face_names(faces)
    indices = sorted({int(facet) for facet in facets})
    if names and kind_of(source) != "shape":
        raise ValueError(f"faces can be chosen of a shape, and “{source.Label}” is a mesh: give facets")
    if indices and kind_of(source) != "mesh":
        raise ValueError(f"facets can be chosen of a mesh, and “{source.Label}” is a shape: give faces")
    if indices and indices[0] < 0:
        raise ValueError(f"facets are counted from 0; {indices[0]} is none")
    obj.SourceFaces = (source, names) if names else None
    obj.Facets = indices
    if deflection is not None:
        obj.Deflection = deflection


def choice(obj: Any) -> dict[str, Any]:
    """What of the Source is thickened: the arguments of surface_arrays()."""
    linked, names = obj.SourceFaces or (None, ())
    # Faces of another object are left over from an earlier Source, and so are facets of a shape.
    return {
        "faces": [name for name in names if name] if linked == obj.Source else [],
        "facets": obj.Facets if kind_of(obj.Source) == "mesh" else [],
        "deflection": obj.Deflection.Value,
    }


def show_solid(obj: Any, solid: ThickenedMesh) -> None:
    """Set the results from the library's."""
    show_report(obj, solid.report)
    from .regions import runs_of

    obj.RegionRuns = runs_of(solid.region)


def show_report(obj: Any, report: dict[str, Any]) -> None:
    """Set the results from the library's report."""
    for prop in RESULTS:
        value: Any = report
        for key in prop.report.split("."):
            value = value[key]
        if value is None:  # how JSON says “not finite”
            value = prop.start
        setattr(obj, prop.name, tuple(value) if isinstance(prop.start, tuple) else value)


def clear_results(obj: Any) -> None:
    """Set the results to what a feature without a solid has."""
    for prop in [*RESULTS, _REGION_RUNS, _COMPUTED_FOR]:
        setattr(obj, prop.name, prop.start)
