// What Origami Simulator says it does with the lines of an SVG, with the library that it says it
// uses for that (FOLD's): ends that lie close together become one vertex, lines that cross are
// cut, and what lies between lines becomes a face. rabbit-ear then folds the pattern by the angles
// that the lines stand for.
//
// in:  { vertices_coords, edges_vertices, edges_assignment, edges_foldAngle, epsilon }
//      two vertices for every line
// out: the pattern with faces_vertices, and folded: vertices_coords in space
"use strict";
const { readFileSync } = require("node:fs");
const { convert, filter } = require("fold");
const { graph } = require("rabbit-ear");

const { epsilon, ...pattern } = JSON.parse(readFileSync(0, "utf8"));
filter.collapseNearbyVertices(pattern, epsilon);
filter.subdivideCrossingEdges_vertices(pattern, epsilon);
convert.edges_vertices_to_faces_vertices_edges(pattern);

const sheet = structuredClone(pattern);
graph.populate(sheet);
const folded = graph.makeVerticesCoordsFolded(sheet, 0);
process.stdout.write(JSON.stringify({ ...pattern, folded }));
