// SPDX-License-Identifier: LGPL-2.1-or-later
// The recorded shapes: unpacks the JSON element #shapes (written by viewer.py) and makes the triangles of a state.
"use strict";

function readShapes(data) {
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const unpack = (text, scale, low) =>
    Float32Array.from(new Uint16Array(bytes(text)), (v, i) => low[i % low.length] + (v * scale) / 65535);
  const faces = new Uint32Array(bytes(data.faces));
  const faceBody = new Uint8Array(bytes(data.faceBody));
  const bodyIds = Object.keys(data.bodies).map(Number);
  const states = data.states.map(({ title, step, points, stress }) => ({
    title,
    step,
    points: unpack(points, data.extent, data.low),
    stress: stress && unpack(stress, data.largestStress, [0]),
  }));
  const moved = ({ points }, node) =>
    Math.hypot(...[0, 1, 2].map((k) => points[3 * node + k] - states[0].points[3 * node + k]));
  let largestMove = 0;
  for (const state of states)
    for (let node = 0; node < state.points.length / 3; ++node) largestMove = Math.max(largestMove, moved(state, node));

  // What the colour shows: a share between 0 and 1 at a node, and in words where 1 is.
  const colourings = {
    stress: {
      share: (state, node, body) => (state.stress ? state.stress[node] / Math.max(data.stressRanges[body], 1e-12) : 0),
      end: () => bodyIds.map((b) => `${data.bodies[b]} ≥ ${data.stressRanges[b].toPrecision(3)} MPa`).join(", "),
    },
    displacement: {
      share: (state, node) => moved(state, node) / (largestMove || 1),
      end: () => `${largestMove.toPrecision(3)} mm from the first state`,
    },
    body: {
      share: (state, node, body) => (bodyIds.indexOf(body) + 0.5) / bodyIds.length,
      end: () => bodyIds.map((b) => data.bodies[b]).join(" … "),
    },
  };

  // Two triangles a face; x, y, z and the share for every corner.
  function vertices(state, colouring) {
    const result = new Float32Array(faceBody.length * 6 * 4);
    let at = 0;
    for (let face = 0; face < faceBody.length; ++face)
      for (const corner of [0, 1, 2, 0, 2, 3]) {
        const node = faces[4 * face + corner];
        result.set(state.points.subarray(3 * node, 3 * node + 3), at);
        result[at + 3] = colourings[colouring].share(state, node, faceBody[face]);
        at += 4;
      }
    return result;
  }

  // The box that all states fill, the mirrored half included.
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const { points } of states)
    points.forEach((v, i) => {
      low[i % 3] = Math.min(low[i % 3], v);
      high[i % 3] = Math.max(high[i % 3], v);
    });
  if (data.symmetric) {
    high[1] = Math.max(high[1], -low[1]);
    low[1] = -high[1];
  }
  const colours = new Uint8Array(bytes(data.colours));
  return { states, colourings, vertices, low, high, colours, symmetric: data.symmetric };
}
