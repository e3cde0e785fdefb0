// Folds the flat sheet of a FOLD file by the fold angles of its key frame and of every further
// frame. rabbit-ear: populate() completes a graph with what lies beside what,
// makeVerticesCoordsFolded(graph, face) turns its faces about its edges; one face stays.
//
// in:  { path, root }   the FOLD file, the face that stays
// out: vertices_coords of every frame, the key frame first
"use strict";
const { readFileSync } = require("node:fs");
const { graph } = require("rabbit-ear");

const { path, root } = JSON.parse(readFileSync(0, "utf8"));
const { file_frames: frames, ...pattern } = JSON.parse(readFileSync(path, "utf8"));

const folded = [pattern, ...frames].map(({ edges_foldAngle }) => {
  const sheet = { ...structuredClone(pattern), edges_foldAngle };
  graph.populate(sheet);
  return graph.makeVerticesCoordsFolded(sheet, root);
});
process.stdout.write(JSON.stringify(folded));
