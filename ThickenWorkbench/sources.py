# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a feature can start from: a mesh, chosen facets of it, a Part shape, or chosen faces of it.

All of them become arrays in the object's own coordinates, without its Placement. A shape is
tessellated afresh: the triangles that FreeCAD keeps for the screen depend on whether there is one.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Sequence

import FreeCAD as App

if TYPE_CHECKING:
    from numpy.typing import NDArray

translate = App.Qt.translate

# Between the normals of neighbouring triangles of a tessellated shape, radians.
ANGULAR_DEFLECTION = 0.5
DEFAULT_DEFLECTION = 0.1

# Open CASCADE's triangles are farther from a curved face than the deflection that it is asked for, by
# up to 1.7 times on spheres: half of it is asked for.
_ASKED_SHARE = 0.5


class RefusedError(RuntimeError):
    """Why a feature has no solid: whole sentences, with the place."""


def kind_of(source: Any) -> str | None:
    """"mesh", "shape", or None for an object that is neither and has no surface."""
    if not hasattr(source, "isDerivedFrom"):
        return None
    if source.isDerivedFrom("Mesh::Feature"):
        return "mesh"
    if source.isDerivedFrom("Part::Feature") and source.Shape.Faces:
        return "shape"
    return None


def require_source(source: Any, feature: Any = None) -> None:
    """Raise RefusedError unless `source` has a surface and `feature` may depend on it."""
    if source is None:
        raise RefusedError(
            translate("Thicken", "No surface is chosen. Set Source to a mesh object or to a shape with faces.")
        )
    label = getattr(source, "Label", source)
    linked = getattr(source, "LinkedObject", None)
    if kind_of(source) is None and linked is not None:
        text = translate("Thicken", "“{label}” is a link. Choose the object that it links to, “{linked}”, or a copy of that.")
        raise RefusedError(text.format(label=label, linked=linked.Label))
    if kind_of(source) is None:
        text = translate("Thicken", "“{label}” is neither a mesh nor a shape with faces. Choose one that is.")
        raise RefusedError(text.format(label=label))
    if feature is not None and (source == feature or feature in source.OutListRecursive):
        raise RefusedError(f"“{label}” depends on “{feature.Label}”. Choose another Source.")


def surface_arrays(
    source: Any,
    *,
    faces: Sequence[str] = (),
    facets: Iterable[int] = (),
    deflection: float = DEFAULT_DEFLECTION,
) -> tuple[NDArray, NDArray]:
    """The vertices (n × 3 floats, mm) and triangles (m × 3) of what is chosen of `source`.

    `faces` are names such as "Face3" of a shape, `facets` indices of a mesh; without any it is all
    of it. `deflection` (mm) is the farthest that the tessellation of a shape may be from it.
    Raises RefusedError for what does not exist.
    """
    require_source(source)
    if kind_of(source) == "mesh":
        if faces:
            raise RefusedError(f"“{source.Label}” is a mesh and has no {faces[0]}. Choose facets instead.")
        return _facets_of(source, facets)
    if len(list(facets)):
        raise RefusedError(f"“{source.Label}” is a shape and has no facets. Choose faces instead.")
    return _tessellated(source, faces, deflection)


def bound_box(source: Any) -> Any:
    """The App.BoundBox of a source, in its parent's coordinates."""
    return source.Mesh.BoundBox if kind_of(source) == "mesh" else source.Shape.BoundBox


def face_names(faces: Iterable[Any]) -> list[str]:
    """Names such as "Face3" from names, numbers from 1, or a selection's sub-elements ("Body.Face3")."""
    names = []
    for face in faces:
        name = f"Face{face}" if isinstance(face, int) else str(face).rsplit(".", 1)[-1]
        if not (name.startswith("Face") and name[4:].isdigit() and int(name[4:]) > 0):
            raise ValueError(f"faces must be names such as 'Face3', not {face!r}")
        if name not in names:
            names.append(name)
    return names


def _facets_of(source: Any, facets: Iterable[int]) -> tuple[NDArray, NDArray]:
    import numpy as np

    from .mesh_io import MeshTransferError, arrays_from_mesh

    if source.Mesh.CountFacets == 0:
        text = translate("Thicken", "“{label}” has no triangles: there is nothing to thicken. Choose another mesh.")
        raise RefusedError(text.format(label=source.Label))
    try:
        vertices, triangles = arrays_from_mesh(source.Mesh)
    except MeshTransferError as error:
        raise RefusedError(str(error)) from None
    chosen = np.unique(np.fromiter(facets, np.int64))
    if len(chosen) == 0:
        return vertices, triangles
    if chosen[0] < 0 or chosen[-1] >= len(triangles):
        wrong = chosen[0] if chosen[0] < 0 else chosen[-1]
        raise RefusedError(
            f"Facet {wrong} was chosen, but “{source.Label}” has {len(triangles)} facets, counted from 0. "
            "Choose the facets again: the mesh has changed."
        )
    return vertices, triangles[chosen]


def _tessellated(source: Any, faces: Sequence[str], deflection: float) -> tuple[NDArray, NDArray]:
    import MeshPart

    from .mesh_io import arrays_from_mesh

    if not deflection > 0:
        raise RefusedError("Deflection is 0 mm. Set it to more than that.")
    mesh = MeshPart.meshFromShape(
        Shape=_chosen_shape(source, faces), LinearDeflection=_ASKED_SHARE * deflection, AngularDeflection=ANGULAR_DEFLECTION, Relative=False
    )
    vertices, triangles = arrays_from_mesh(mesh)
    if len(triangles) == 0:
        raise RefusedError(f"“{source.Label}” gave no triangles. Choose a smaller Deflection.")
    return vertices, triangles


def _chosen_shape(source: Any, faces: Sequence[str]) -> Any:
    import Part

    shape = source.Shape.copy()  # without the triangles that are kept for the screen
    shape.Placement = App.Placement()
    if not faces:
        return shape
    every = shape.Faces
    chosen = []
    for name in face_names(faces):
        number = int(name[4:])
        if number > len(every):
            raise RefusedError(
                f"“{source.Label}” has no {name}: the last one is Face{len(every)}. Choose the faces again: the shape has changed."
            )
        chosen.append(every[number - 1])
    return Part.makeCompound(chosen)
