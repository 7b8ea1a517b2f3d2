// A clevis bracket: a bolted base with two lugs that hold a pin of 8 mm, ribbed and lightened.
// Printed as it stands, without supports: every roof rises at 45 degrees, the pin hole is a teardrop.
// Lengths in mm; the base lies on z = 0 and the origin is below the middle of the pin.
$fn = 32;

base = [70, 50, 5];
bolt_at = [28, 18];
bolt_hole = 5.5;
boss = [13, 8];        // diameter, height above the bed
pin_hole = 8;
pin_height = 20;
eye_radius = 8.5;      // of the lug round the pin
gap = 12;              // between the lugs
lug = 6;               // thickness of a lug
rib = 5;
eps = 0.01;

bracket();

module bracket() {
    difference() {
        union() {
            plate();
            at_bolts() cylinder(d = boss[0], h = boss[1], $fn = 24);
            both_sides() { lug_wall(); gusset(); }
        }
        at_bolts() translate([0, 0, -1]) cylinder(d = bolt_hole, h = 20, $fn = 24);
        across() teardrop(pin_hole / 2);
        slot();
        at_corners() pocket();
    }
}

// The plate, with a scallop in either short side.
module plate() {
    linear_extrude(base[2]) difference() {
        offset(7) square([base[0] - 14, base[1] - 14], center = true);
        for (side = [-1, 1]) translate([side * 43, 0]) circle(12, $fn = 48);
    }
}

module at_bolts() {
    for (x = [-1, 1], y = [-1, 1]) translate([x * bolt_at[0], y * bolt_at[1], 0]) children();
}

module at_corners() {
    for (x = [0, 1], y = [0, 1]) mirror([x, 0, 0]) mirror([0, y, 0]) children();
}

module both_sides() {
    for (y = [0, 1]) mirror([0, y, 0]) children();
}

// Extrudes a shape drawn in (x, z), with the pin as its origin, through the whole bracket.
module across() {
    translate([0, base[1], pin_height]) rotate([90, 0, 0]) linear_extrude(2 * base[1]) children();
}

module teardrop(radius) {
    circle(radius);
    rotate(45) square(radius);
}

// The lug seen along the pin: an eye on a foot whose sides fall at 45 degrees.
module lug_outline() {
    hull() {
        circle(eye_radius, $fn = 48);
        translate([-27, eps - pin_height]) square([54, base[2]]);
    }
}

// A three-cornered opening in the lug's foot, 3 mm inside its outline.
module window() {
    intersection() {
        offset(delta = -3) lug_outline();
        translate([-40, 8 - pin_height]) square([40 - eye_radius, 40]);
    }
}

module lug_wall() {
    translate([0, gap / 2 + lug, pin_height]) rotate([90, 0, 0]) linear_extrude(lug) difference() {
        lug_outline();
        window();
        mirror([1, 0]) window();
    }
}

// A triangle that props the lug from outside, up to just below the pin hole.
module gusset() {
    foot = gap / 2 + lug;
    top = pin_height - pin_hole / 2 - 2;
    translate([-rib / 2, 0, 0]) rotate([90, 0, 90]) linear_extrude(rib)
        polygon([[foot - 1, 1], [base[1] / 2 - 1.5, 1], [base[1] / 2 - 1.5, base[2]],
                 [foot, top], [foot - 1, top]]);
}

// A hole in the plate between the lugs.
module slot() {
    translate([0, 0, -1]) linear_extrude(base[2] + 2)
        hull() for (side = [-1, 1]) translate([side * 16, 0]) circle(4);
}

// A hollow beside each gusset that leaves a floor of 2 mm.
module pocket() {
    translate([0, 0, 2]) linear_extrude(base[2])
        offset(1.5, $fn = 16) polygon([[6, 15.5], [17.5, 15.5], [17.5, 20.5], [6, 20.5]]);
}
