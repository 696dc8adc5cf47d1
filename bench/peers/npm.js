// SPDX-License-Identifier: GPL-3.0-or-later
// node npm.js PACKAGE RADIUS: fills the unit square with a package of the npm registry (found by
// NODE_PATH) and prints the CPU seconds, then one point per line.
const [name, radius] = [process.argv[2], Number(process.argv[3])];
let Sampler;
try {
  Sampler = require(name);
} catch {
  process.exit(1);
}
const side = 1000; // of the square, since some packages work in pixels
const fill = (r) => new Sampler({ shape: [side, side], radius: r, minDistance: r, tries: 30 }).fill();
fill(side / 30); // compiles it
const start = process.cpuUsage();
const points = fill(radius * side);
const used = process.cpuUsage(start);
const lines = [(used.user + used.system) / 1e6];
for (const [x, y] of points) lines.push(`${x / side} ${y / side}`);
require("fs").writeSync(1, lines.join("\n") + "\n");
