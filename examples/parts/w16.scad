// A stand-in for the engine block of sixteen bores of the published experiment with
// vibration-suppressed toolpaths, whose model is not to be had: bores, bolt holes, and slots that its
// sections at 15, 25, 50 and 75 % of the height show. The same numbers as src/smooth/engine_block.h;
// ../README.md.
height = 60;
centre = [171, 112];
pitch = 44;

translate([centre.x, centre.y]) difference() {
    linear_extrude(height) rounded_square(194, 6);
    lattice(4) bore(34, 75);
    lattice(5) bore(8, 24);
    between(10, 20) for (side = [-80.5, 80.5]) translate([side, 0]) square([3.2, 120], center = true);
    between(20, 35) coolant_slots(16, 3.5);
    between(40, 60) coolant_slots(12, 4.5);
}

// Six chords to the quarter.
module rounded_square(side, radius)
    offset(r = radius, $fn = 24) square(side - 2 * radius, center = true);

module bore(diameter, corners)
    translate([0, 0, -1]) cylinder(d = diameter, h = height + 2, $fn = corners);

// Children on a square lattice of this many places each way.
module lattice(count)
    for (i = [0 : count - 1], j = [0 : count - 1])
        translate(pitch * [i - (count - 1) / 2, j - (count - 1) / 2]) children();

// A slot's outline from one share (%) of the height to another.
module between(low, high)
    translate([0, 0, height * low / 100]) linear_extrude(height * (high - low) / 100) children();

// Half-way between neighbouring bores, across the line that joins them.
module coolant_slots(length, width)
    for (i = [0 : 3], j = [0 : 2]) {
        along = (i - 1.5) * pitch;
        between = (j - 1) * pitch;
        translate([along, between]) square([length, width], center = true);
        translate([between, along]) square([width, length], center = true);
    }
