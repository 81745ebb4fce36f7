# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the files that the fuzzer starts from: `write_seeds.py FORMAT FOLDER`. Each shows what its format can hold."""

import struct
import sys
from pathlib import Path

SQUARE = [(0, 0, 0), (1.5, 0, 0), (1.5, 2, 0.25), (0, 2, -0.125)]
HALVES = [(0, 1, 2), (0, 2, 3)]


def text(*lines: str, end: str = "\n") -> bytes:
    return (end.join(lines) + end).encode()


def stl() -> dict[str, bytes]:
    facet = ["facet normal 0 0 1", "outer loop", "vertex 0 0 0", "vertex 1.5 0 0", "vertex 0 1e-3 0", "endloop", "endfacet"]
    corners = [[SQUARE[v] for v in half] for half in HALVES]
    facets = b"".join(struct.pack("<12fH", 0, 0, 1, *(x for corner in half for x in corner), 0) for half in corners)
    binary = b"solid".ljust(80, b"\0") + struct.pack("<I", len(HALVES)) + facets
    return {
        "ascii": text("solid name", *facet, "endsolid name"),
        "two-solids": text("solid", *facet, "endsolid", "solid b", *facet, "endsolid b", end="\r\n"),
        "binary": binary,
        "padded": binary + bytes(16),
    }


def ply() -> dict[str, bytes]:
    def head(encoding: str, *more: str) -> bytes:
        return text("ply", f"format {encoding} 1.0", "comment a square", "element vertex 4", "property float x",
                    "property float y", "property double z", "property list uchar int more", "element face 2",
                    "property list uchar uint vertex_indices", "property uchar red", *more, "end_header")  # fmt: skip

    def body(order: str) -> bytes:
        vertices = b"".join(struct.pack(order + "2fdBi", *v, 1, 7) for v in SQUARE)
        return vertices + b"".join(struct.pack(order + "B3IB", 3, *half, 9) for half in HALVES)

    lines = [f"{x} {y} {z} 0" for x, y, z in SQUARE] + ["3 0 1 2 9", "4 0 1 2 3 9", "1 5"]
    polygon = ["ply", "format ascii 1.0", "element vertex 6", "property int64 x", "property uint8 y", "property int16 z",
               "element face 1", "property list uint16 int8 vertex_index", "end_header",
               "0 0 0", "4 0 0", "4 4 0", "2 1 0", "0 4 0", "9 9 9", "5 0 1 2 3 4"]  # fmt: skip
    return {
        "ascii": head("ascii", "element edge 1", "property list uchar int ends") + text(*lines),
        "little": head("binary_little_endian") + body("<"),
        "big": head("binary_big_endian") + body(">"),
        "polygon": text(*polygon, end="\r"),
    }


def obj() -> dict[str, bytes]:
    vertices = [f"v {x} {y} {z}" for x, y, z in SQUARE]
    return {
        "indices": text("# a square", "mtllib a.mtl", "o one", *vertices, "vt 0 0", "vn 0 0 1", "f 1/1/1 2//1 3/1", "f 1 3 4"),
        "relative": text(*vertices, "g a", "s off", "f -4 -3 \\", "-2 -1", end="\r\n"),
        "concave": text("v 0 0 0", "v 4 0 0", "v 4 4 0 1 0 0", "v 2 1 0", "v 0 4 0", "f 1 2 3 4 5", "l 1 2", "p 1"),
    }


def off() -> dict[str, bytes]:
    vertices = [f"{x} {y} {z}" for x, y, z in SQUARE]
    return {
        "off": text("OFF", "4 2 0", *vertices, "3 0 1 2", "3 0 2 3"),
        "coloured": text("COFF # a comment", "4 1", *(v + " 255 0 0 255" for v in vertices), "4 0 1 2 3 0.5 0.5 0.5"),
        "all": text("STCNOFF 5 1 0", "0 0 0 0 0 1", "4 0 0", "4 4 0", "2 1 0", "0 4 1e-3", "5 0 1 2 3 4", end="\r"),
    }


def main() -> None:
    write, folder = {"stl": stl, "ply": ply, "obj": obj, "off": off}[sys.argv[1]], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, data in write().items():
        (folder / name).write_bytes(data)


main()
