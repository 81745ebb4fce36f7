# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run does at the moment, in words."""

from __future__ import annotations

import FreeCAD as App

translate = App.Qt.translate


def stage_name(stage: str) -> str:
    """The user's word for a stage of the library."""
    names = {
        "waiting": translate("Thicken", "Working"),
        "checking": translate("Thicken", "Checking the surface"),
        "sweeping": translate("Thicken", "Building the shell"),
        "field": translate("Thicken", "Measuring distances"),
        "contouring": translate("Thicken", "Rebuilding parts of the shell"),
        "shaping": translate("Thicken", "Smoothing the shell"),
        "joining": translate("Thicken", "Joining the parts"),
        "auditing": translate("Thicken", "Proving the solid"),
        "measuring": translate("Thicken", "Measuring"),
    }
    return names.get(stage, stage)
