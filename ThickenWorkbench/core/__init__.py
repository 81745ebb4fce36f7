# SPDX-License-Identifier: LGPL-2.1-or-later
"""What needs arrays only: nothing in here knows of FreeCAD."""
