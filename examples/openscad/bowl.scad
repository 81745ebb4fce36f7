// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A stand for the bowl that `thicken` made: the shell is imported, its rim is left as it is, and a foot
// is joined to it.
//
//     openscad -o bowl_with_foot.stl -D 'shell="shell.stl"' bowl.scad
shell = "shell.stl";
$fn = 64;

module shell() {
    import(shell, convexity = 4);
}

union() {
    shell();
    difference() {
        translate([0, 0, -14]) cylinder(h = 4, r = 9);
        translate([0, 0, -15]) cylinder(h = 6, r = 7);
    }
}
