# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures that the library draws, put together."""

from __future__ import annotations

import io

from PIL import Image, ImageDraw

import thicken

BACKGROUND = (255, 255, 255)


def draw(*mesh_and_colours, **view) -> Image.Image:
    """What thicken.render_picture() draws."""
    return Image.open(io.BytesIO(thicken.render_picture(*mesh_and_colours, **view)))


def beside(pictures: list[Image.Image], legend: list[tuple[str, tuple[int, int, int]]]) -> Image.Image:
    """Pictures side by side above a line that names the colours."""
    line = 36
    width, height = sum(p.width for p in pictures), max(p.height for p in pictures)
    sheet = Image.new("RGB", (width, height + line), BACKGROUND)
    left = 0
    for picture in pictures:
        sheet.paste(picture, (left, 0))
        left += picture.width
    pen = ImageDraw.Draw(sheet)
    left = 20
    for name, colour in legend:
        pen.rectangle((left, height + 10, left + 14, height + 24), fill=colour)
        pen.text((left + 22, height + 11), name, fill=(0, 0, 0))
        left += 40 + 7 * len(name)
    return sheet
