// The FOLD format's own library: faces from vertices and edges alone, and borders from faces.
//
// in:  { path }   a FOLD file with a flat key frame
// out: { faces_vertices, faces_edges, borders }   borders: edges as pairs of vertices
"use strict";
const { readFileSync } = require("node:fs");
const { convert } = require("fold");

const { path } = JSON.parse(readFileSync(0, "utf8"));
const { vertices_coords, edges_vertices, faces_vertices } = JSON.parse(readFileSync(path, "utf8"));

const found = { vertices_coords, edges_vertices };
convert.edges_vertices_to_faces_vertices_edges(found);

const sheet = { faces_vertices };
convert.faces_vertices_to_edges(sheet);
const borders = sheet.edges_vertices.filter((_, edge) => sheet.edges_assignment[edge] === "B");

process.stdout.write(
  JSON.stringify({
    faces_vertices: found.faces_vertices,
    faces_edges: found.faces_edges,
    borders,
  }),
);
