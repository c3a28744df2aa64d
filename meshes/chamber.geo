// chamber.step: a rounded finger with a blind bore below its middle, open at x = 0. Written by gmsh: "gmsh chamber.geo -0 -o chamber.step".
SetFactory("OpenCASCADE");
Box(1) = {0, -6, -6, 40, 12, 12};
Fillet{1}{9, 10, 11, 12}{2}              // the edges along x
Cylinder(2) = {-1, 0, -1.5, 36, 0, 0, 2.5};
BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }
