// A bending finger: a block with a blind round bore below its middle, open at x = 0. Millimetres.
//     gmsh -3 -format msh41 finger.geo -o finger.msh
length = 40; width = 12; height = 12; radius = 3; below = 1.5; depth = 36;

Point(1) = {0, -width/2, -height/2}; Point(2) = {0, width/2, -height/2};
Point(3) = {0, width/2, height/2};   Point(4) = {0, -width/2, height/2};
Point(5) = {0, 0, -below};
Point(6) = {0, radius, -below};  Point(7) = {0, 0, radius - below};
Point(8) = {0, -radius, -below}; Point(9) = {0, 0, -radius - below};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Circle(5) = {6, 5, 7}; Circle(6) = {7, 5, 8}; Circle(7) = {8, 5, 9}; Circle(8) = {9, 5, 6};
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(1) = {1, 2};

wall[] = Extrude {length, 0, 0} { Curve{1, 2, 3, 4}; };
bore[] = Extrude {depth, 0, 0} { Curve{5, 6, 7, 8}; };
Curve Loop(3) = {wall[0], wall[4], wall[8], wall[12]};   Plane Surface(101) = {3};
Curve Loop(4) = {bore[0], bore[4], bore[8], bore[12]};   Plane Surface(102) = {4};
Surface Loop(1) = {1, 101, 102, wall[1], wall[5], wall[9], wall[13], bore[1], bore[5], bore[9], bore[13]};
Volume(1) = {1};

Physical Surface("fixed") = {1};
Physical Surface("tip") = {101};
Physical Surface("sides") = {wall[1], wall[5], wall[9], wall[13]};
Physical Surface("bore") = {bore[1], bore[5], bore[9], bore[13]};
Physical Surface("bore_end") = {102};
Physical Volume("finger") = {1};

Mesh.MeshSizeMin = 6; Mesh.MeshSizeMax = 8;
