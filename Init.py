# SPDX-License-Identifier: LGPL-2.1-or-later
#
# FreeCAD runs this file at every start, with or without a display. There is nothing to prepare:
# `import ThickenWorkbench` works because this folder is on Python's path, and costs nothing until then.
