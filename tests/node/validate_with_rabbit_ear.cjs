// in:  { path }   a FOLD file
// out: what rabbit-ear's validate() says of its key frame
"use strict";
const { readFileSync } = require("node:fs");
const { graph } = require("rabbit-ear");

const { path } = JSON.parse(readFileSync(0, "utf8"));
const fold = JSON.parse(readFileSync(path, "utf8"));
process.stdout.write(JSON.stringify(graph.validate(fold)));
