# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only part of the package that needs FreeCAD's user interface."""
