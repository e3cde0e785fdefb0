// Khronos' glTF validator.
//
// in:  { path }   a .glb or .gltf file
// out: the validator's report: issues (numErrors, numWarnings, numInfos, messages) and info
"use strict";
const { readFileSync } = require("node:fs");
const validator = require("gltf-validator");

const { path } = JSON.parse(readFileSync(0, "utf8"));
validator
  .validateBytes(new Uint8Array(readFileSync(path)), { writeTimestamp: false, maxIssues: 20 })
  .then((report) => process.stdout.write(JSON.stringify(report)));
