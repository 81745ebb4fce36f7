# SPDX-License-Identifier: LGPL-2.1-or-later
"""As much of JSON Schema as docs/report.schema.json uses; any other keyword is an error."""

from __future__ import annotations

from typing import Any

_TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}
_NOTES = {"$schema", "$defs", "title", "description", "type"}


def _has_type(value: Any, name: str) -> bool:
    if name == "number":
        return isinstance(value, (int, float)) and not isinstance(value, bool)
    if name == "integer":
        return isinstance(value, int) and not isinstance(value, bool)
    return isinstance(value, _TYPES[name])


def faults(value: Any, schema: dict, root: dict, at: str = "$") -> list[str]:
    """What is wrong with `value`, as sentences; empty: it fits."""
    names = schema.get("type", [])
    names = [names] if isinstance(names, str) else names
    if names and not any(_has_type(value, name) for name in names):
        return [f"{at} is {value!r} and no {' or '.join(names)}"]
    found: list[str] = []
    for keyword, rule in schema.items():
        if keyword == "const":
            found += [] if value == rule else [f"{at} is {value!r}, not {rule!r}"]
        elif keyword == "enum":
            found += [] if value in rule else [f"{at} is {value!r}, none of {rule}"]
        elif keyword == "minimum":
            found += [f"{at} is {value} < {rule}"] if value is not None and value < rule else []
        elif keyword == "minItems":
            found += [f"{at} has fewer than {rule} entries"] if len(value) < rule else []
        elif keyword == "maxItems":
            found += [f"{at} has more than {rule} entries"] if len(value) > rule else []
        elif keyword == "items":
            entries = value if isinstance(value, list) else []
            found += [fault for i, entry in enumerate(entries) for fault in faults(entry, rule, root, f"{at}[{i}]")]
        elif keyword == "required":
            found += [f"{at}.{key} is missing" for key in rule if isinstance(value, dict) and key not in value]
        elif keyword == "properties":
            for key, child in rule.items():
                if isinstance(value, dict) and key in value:
                    found += faults(value[key], child, root, f"{at}.{key}")
        elif keyword == "additionalProperties":
            others = set(value) - set(schema["properties"]) if isinstance(value, dict) else set()
            for key in sorted(others):
                found += [f"{at}.{key} is unknown"] if rule is False else faults(value[key], rule, root, f"{at}.{key}")
        elif keyword == "$ref":
            found += faults(value, root["$defs"][rule.removeprefix("#/$defs/")], root, at)
        elif keyword == "oneOf":
            tries = [faults(value, choice, root, at) for choice in rule]
            if sum(not one for one in tries) != 1:
                found.append(f"{at} fits {sum(not one for one in tries)} of {len(tries)} kinds; the nearest: "
                             + "; ".join(min(tries, key=len)))  # fmt: skip
        elif keyword not in _NOTES:
            raise NotImplementedError(keyword)
    return found
