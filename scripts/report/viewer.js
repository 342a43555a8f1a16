// SPDX-License-Identifier: LGPL-2.1-or-later
// The controls of the orbit view: state, colour, mirror image, turning and zooming.
"use strict";

(() => {
  const element = (id) => document.getElementById(id);
  const shapes = readShapes(JSON.parse(element("shapes").textContent));
  const canvas = element("view");
  const scene = makeScene(canvas, shapes);
  if (!scene) {
    element("viewer").textContent = "This browser offers no WebGL 2; the pictures above show the same path.";
    return;
  }
  const slider = element("state");
  const colouring = element("colouring");
  const whole = element("whole");
  const draw = () => scene.draw(shapes.symmetric && whole.checked);

  function show() {
    const state = shapes.states[slider.value];
    scene.load(shapes.vertices(state, colouring.value));
    element("state-title").textContent = state.step == null ? state.title : `step ${state.step}: ${state.title}`;
    element("scale-end").textContent = shapes.colourings[colouring.value].end();
    draw();
  }

  let playing = 0;
  function play() {
    if (playing) {
      playing = clearInterval(playing);
      return;
    }
    playing = setInterval(() => {
      slider.value = (Number(slider.value) + 1) % shapes.states.length;
      show();
    }, 150);
  }

  const fingers = new Map();
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  function drag(event) {
    const last = fingers.get(event.pointerId);
    if (!last) return;
    const before = fingers.size === 2 ? spread() : 0;
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (before) scene.camera.zoom *= spread() / before;
    else {
      scene.camera.azimuth -= (event.clientX - last.x) / 2;
      const elevation = scene.camera.elevation + (event.clientY - last.y) / 2;
      scene.camera.elevation = Math.max(-90, Math.min(90, elevation));
    }
    draw();
  }
  function wheel(event) {
    if (document.activeElement !== canvas) return; // zooms only a view that was clicked: else the page scrolls
    event.preventDefault();
    scene.camera.zoom *= Math.exp(-event.deltaY / 600);
    draw();
  }

  slider.max = shapes.states.length - 1;
  slider.value = slider.max;
  if (shapes.states.length < 2) slider.hidden = element("play").hidden = true;
  if (!shapes.symmetric) whole.parentElement.hidden = true;
  if (!shapes.states.some(({ stress }) => stress)) colouring.querySelector("[value=stress]").remove();
  const ramp = [0, 64, 128, 192, 255].map((i) => `rgb(${shapes.colours.subarray(3 * i, 3 * i + 3).join()})`);
  element("scale").style.background = `linear-gradient(to right, ${ramp.join()})`;

  slider.oninput = colouring.onchange = show;
  whole.onchange = draw;
  element("play").onclick = play;
  element("reset").onclick = () => {
    scene.reset();
    draw();
  };
  canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    canvas.focus();
  };
  canvas.onpointerup = canvas.onpointercancel = (event) => fingers.delete(event.pointerId);
  canvas.onpointermove = drag;
  canvas.addEventListener("wheel", wheel, { passive: false });
  show();
  new ResizeObserver(draw).observe(canvas);
})();
