// SPDX-License-Identifier: LGPL-2.1-or-later
// WebGL 2 and the camera: turns about the middle of the box, no perspective, light from beside the viewer.
"use strict";

const vertexShader = `#version 300 es
  in vec4 corner; uniform mat4 view; uniform float mirror; out vec3 place; out float share;
  void main() {
    place = vec3(corner.x, corner.y * mirror, corner.z);
    share = corner.w;
    gl_Position = view * vec4(place, 1.0);
  }`;
const fragmentShader = `#version 300 es
  precision highp float; in vec3 place; in float share; uniform sampler2D scale; uniform vec3 light; out vec4 colour;
  void main() {
    float shade = 0.45 + 0.55 * abs(dot(normalize(cross(dFdx(place), dFdy(place))), light));
    colour = vec4(texture(scale, vec2(clamp(share, 0.002, 0.998), 0.5)).rgb * shade, 1.0);
  }`;

function makeProgram(gl) {
  const program = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  gl.useProgram(program);
  return program;
}

// Returns null without WebGL 2.
function makeScene(canvas, shapes) {
  const gl = canvas.getContext("webgl2", { antialias: true });
  if (!gl) return null;
  const program = makeProgram(gl);
  const uniform = (name) => gl.getUniformLocation(program, name);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  const attribute = gl.getAttribLocation(program, "corner");
  gl.enableVertexAttribArray(attribute);
  gl.vertexAttribPointer(attribute, 4, gl.FLOAT, false, 0, 0);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, 256, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, shapes.colours);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.enable(gl.DEPTH_TEST);
  gl.clearColor(1, 1, 1, 1);

  const middle = [0, 1, 2].map((k) => (shapes.low[k] + shapes.high[k]) / 2);
  const radius = Math.hypot(...[0, 1, 2].map((k) => shapes.high[k] - shapes.low[k])) / 2 || 1;
  const camera = {};
  let corners = 0;

  function axes() {
    const [a, e] = [camera.azimuth, camera.elevation].map((degrees) => (degrees * Math.PI) / 180);
    const right = [-Math.sin(a), Math.cos(a), 0];
    const up = [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)];
    const towards = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
    return { right, up, towards };
  }

  // Looks at the side on which the bending shows, as near as all states fit into the canvas.
  function reset() {
    Object.assign(camera, { azimuth: -65, elevation: 14 });
    const { right, up } = axes();
    const half = (axis) => axis.reduce((sum, v, k) => sum + Math.abs(v) * (shapes.high[k] - middle[k]), 0);
    const wide = canvas.clientWidth / canvas.clientHeight || 1;
    camera.zoom = (0.95 * radius) / Math.max(half(right) / Math.max(wide, 1), half(up) * Math.min(wide, 1), 1e-9);
  }

  function viewMatrix({ right, up, towards }) {
    const wide = canvas.width / canvas.height;
    const size = camera.zoom / radius;
    const scales = [[right, size / Math.max(wide, 1)], [up, size * Math.min(wide, 1)], [towards, -0.5 / radius]];
    const shift = (axis) => -axis.reduce((sum, v, k) => sum + v * middle[k], 0);
    const rows = scales.map(([axis, scale]) => [...axis.map((v) => v * scale), shift(axis) * scale]);
    return [0, 1, 2, 3].flatMap((column) => [...rows.map((row) => row[column]), column === 3 ? 1 : 0]);
  }

  function draw(whole) {
    const pixels = window.devicePixelRatio || 1;
    canvas.width = canvas.clientWidth * pixels;
    canvas.height = canvas.clientHeight * pixels;
    const { right, up, towards } = axes();
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(uniform("view"), false, viewMatrix({ right, up, towards }));
    gl.uniform3fv(uniform("light"), [0, 1, 2].map((k) => 0.3 * right[k] + 0.45 * up[k] + 0.84 * towards[k]));
    for (const mirror of whole ? [1, -1] : [1]) {
      gl.uniform1f(uniform("mirror"), mirror);
      gl.drawArrays(gl.TRIANGLES, 0, corners);
    }
  }

  function load(vertices) {
    corners = vertices.length / 4;
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.DYNAMIC_DRAW);
  }
  reset();
  return { camera, draw, load, reset };
}
