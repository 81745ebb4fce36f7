# SPDX-License-Identifier: LGPL-2.1-or-later
"""summary.tsv and summary.html of a folder of parts: summarize.py FOLDER."""

from __future__ import annotations

import re
import sys
from collections import Counter
from html import escape
from pathlib import Path
from typing import Any
from urllib.parse import quote

from part_table import Folder, Part, read_json, write_whole

RESULTS = ["status", "code", "sentence", "exit_status", "thinnest_wall_mm", "volume_ml", "triangles", "seconds",
           "memory_mib", "memory_limit_mib", "time_limit_s", "runs", "warnings", "solid", "report"]  # fmt: skip
_SHOWN = ["status", "code", "sentence", "thinnest_wall_mm", "volume_ml", "seconds", "memory_mib"]


def row_of(part: Part, folder: Folder) -> dict[str, Any]:
    made = read_json(folder.row(part.name))
    told = made["told"]
    is_made = made["status"] == "ok"
    return {
        **part.cells,
        "status": made["status"],
        "code": told["code"],
        "sentence": told["sentence"],
        "exit_status": told["exit_status"],
        "thinnest_wall_mm": told["thinnest_wall_mm"],
        "volume_ml": told["volume_ml"],
        "triangles": told["triangles"],
        "seconds": round(made["seconds"], 3),
        "memory_mib": told["peak_mib"],
        "memory_limit_mib": made["limits"]["memory"],
        "time_limit_s": made["limits"]["timeout"],
        "runs": made["runs"],
        "warnings": " ".join(told["warnings"]),
        "solid": folder.solid(part.name).name if is_made else "",
        "report": folder.report(part.name).name,
        "picture": f"pictures/{part.name}.png" if folder.picture(part.name).is_file() else "",
    }


def cell(value: Any) -> str:
    """On one line and without tabs; a missing number is empty."""
    if value is None:
        return ""
    return f"{value:.6g}" if isinstance(value, float) else re.sub(r"\s+", " ", str(value))


def table(columns: list[str], rows: list[dict[str, Any]]) -> str:
    lines = ["\t".join(columns), *("\t".join(cell(row[name]) for name in columns) for row in rows)]
    return "\n".join(lines) + "\n"


def page(given: list[str], rows: list[dict[str, Any]]) -> str:
    columns = [*given, *_SHOWN]
    counts = Counter(row["status"] for row in rows)
    told = ", ".join(f"{count} {status}" for status, count in sorted(counts.items()))
    head = "".join(f'<th aria-sort="none"><button>{escape(name.replace("_", " "))}</button></th>' for name in columns)
    body = "\n".join(_line(columns, row) for row in rows)
    return _PAGE.format(told=escape(f"{len(rows)} parts: {told}" if rows else "no parts"), head=head, body=body)


def _line(columns: list[str], row: dict[str, Any]) -> str:
    picture = f'<img loading="lazy" alt="" src="{quote(row["picture"])}">' if row["picture"] else ""
    if row["solid"]:
        picture = f'<a href="{quote(row["solid"])}">{picture or "solid"}</a>'
    cells = []
    for name in columns:
        value = row[name]
        text = f"{value:.4g}" if isinstance(value, float) else cell(value)
        shown = f'<a href="{quote(row["report"])}">{escape(text)}</a>' if name == "status" else escape(text)
        cells.append(f'<td class="{"n" if isinstance(value, (int, float)) else "t"}">{shown}</td>')
    return f'<tr class="{row["status"]}"><td>{picture}</td>{"".join(cells)}</tr>'


# Braces are doubled for str.format.
_PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Parts</title>
<style>
body {{ font: 14px/1.4 system-ui, sans-serif; margin: 1.5em; color: #222; }}
table {{ border-collapse: collapse; }}
th, td {{ padding: .25em .6em; border-bottom: 1px solid #ddd; text-align: left; vertical-align: middle; }}
thead th {{ position: sticky; top: 0; background: #fff; }}
th button {{ font: inherit; font-weight: 600; border: 0; background: none; padding: 0; cursor: pointer; }}
th[aria-sort=ascending] button::after {{ content: " ▲"; }}
th[aria-sort=descending] button::after {{ content: " ▼"; }}
td.t {{ max-width: 28em; overflow-wrap: break-word; }}
td.n {{ text-align: right; font-variant-numeric: tabular-nums; }}
tr.refused {{ background: #fff6e5; }} tr.failed {{ background: #fde8e8; }}
img {{ width: 96px; height: 72px; display: block; }}
</style>
<h1>{told}</h1>
<p>A click on a heading sorts; the picture leads to the solid, the status to the report. The same as a table:
<a href="summary.tsv">summary.tsv</a>.</p>
<table><thead><tr><th>picture</th>{head}</tr></thead><tbody>
{body}
</tbody></table>
<script>
const body = document.querySelector("tbody"), heads = [...document.querySelectorAll("th[aria-sort]")];
const compare = new Intl.Collator("en", {{ numeric: false }}).compare;
heads.forEach((head, i) => head.firstChild.addEventListener("click", () => {{
  const up = head.getAttribute("aria-sort") !== "ascending", key = row => row.cells[i + 1].textContent;
  heads.forEach(h => h.setAttribute("aria-sort", "none"));
  head.setAttribute("aria-sort", up ? "ascending" : "descending");
  const rows = [...body.rows], isNumber = text => text !== "" && !isNaN(text);
  rows.sort((a, b) => {{
    const x = key(a), y = key(b);
    if (x === "" || y === "") return (x === "") - (y === "");  // nothing comes last, either way
    const order = isNumber(x) && isNumber(y) ? x - y : compare(x, y);
    return up ? order : -order;
  }});
  body.append(...rows);
}}));
</script>
</html>
"""


def main(path: Path) -> None:
    folder = Folder(path)
    parts = [Part(*part) for part in read_json(path / "jobs/parts.json")["parts"]]
    given = list(parts[0].cells) if parts else ["file", "thickness"]
    rows = [row_of(part, folder) for part in parts]
    write_whole(path / "summary.tsv", table([*given, *RESULTS], rows))
    write_whole(path / "summary.html", page(given, rows))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
