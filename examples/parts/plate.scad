// Flat test pieces, 2.1 mm thick, centred on the origin: choose with -D 'shape="square"'.
// Their outlines follow the five shapes of P. Somade's experiment (2023); see ../README.md.
shape = "square";
thickness = 2.1;
$fn = 180;

linear_extrude(thickness) outline();

module outline() {
    if (shape == "square") square(54, center = true);
    else if (shape == "rectangle") square([80, 26.5], center = true);
    else if (shape == "triangle") triangle(53.5);
    else if (shape == "teardrop") teardrop(25.8, 45.5);
    else if (shape == "oval") scale([73.5 / 2, 61 / 2]) circle(1);
    else assert(false, str("no such shape: ", shape));
}

// Equilateral, one side along X, the centroid in the origin.
module triangle(side) {
    height = side * sqrt(3) / 2;
    polygon([[-side / 2, -height / 3], [side / 2, -height / 3], [0, 2 * height / 3]]);
}

// A circle and the two tangents to it from a tip on the X axis.
module teardrop(radius, tip) {
    touch = radius * radius / tip;
    reach = radius * sqrt(1 - pow(radius / tip, 2));
    circle(radius);
    polygon([[touch, -reach], [tip, 0], [touch, reach]]);
}
