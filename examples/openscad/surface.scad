// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A bowl as a closed body: OpenSCAD has no open surfaces. What is thickened is its outer skin; the flat
// lid is left out by `thicken_bowl.py`.
//
//     openscad -o bowl.stl surface.scad
$fn = 64;
radius = 20;
depth = 12;

difference() {
    translate([0, 0, radius - depth]) sphere(radius);
    translate([0, 0, radius]) cube(2 * radius, center = true);
}
