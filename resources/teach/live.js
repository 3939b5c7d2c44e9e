// The live canvas of a lesson: the program's own GLSL, run by the browser. SPDX-License-Identifier: MIT
"use strict";
(() => {
  const config = JSON.parse(document.getElementById("live-config").textContent);
  const root = document.getElementById("live");
  const canvas = root.querySelector("canvas.ball");
  const chart = root.querySelector("canvas.curve");
  const words = config.words;
  const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
  if (!gl) {
    root.querySelector(".panes").textContent = words.no_webgl;
    return;
  }

  const TABLE = 48, POINTS = 256;
  const state = { values: {}, chosen: { ...config.models[0].chosen }, environment_masking: config.models[0].environment_masking,
    view: config.views[0].index, furnace: config.furnace };
  for (const slider of config.sliders) state.values[slider.name] = slider.value;

  const head = "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp usampler2D;\n";
  const compile = (kind, name) => {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, head + config.shaders[name].replace("//@brdf", () => config.shaders["generated/brdf.glsl"]));
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(name + ": " + gl.getShaderInfoLog(shader));
    return shader;
  };
  const vertex = compile(gl.VERTEX_SHADER, "frame/full_screen.vert");
  const program = (name) => {
    const made = gl.createProgram();
    gl.attachShader(made, vertex);
    gl.attachShader(made, compile(gl.FRAGMENT_SHADER, name));
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(name + ": " + gl.getProgramInfoLog(made));
    const places = {};
    return { use: () => gl.useProgram(made), at: (uniform) => (places[uniform] ??= gl.getUniformLocation(made, uniform)) };
  };
  const programs = Object.fromEntries(["albedo", "average", "canvas", "probe"].map((n) => [n, program(`teach/${n}.frag`)]));

  const target = (width, height) => {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, width, height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    return { texture, framebuffer, width, height };
  };
  const first = target(TABLE, TABLE), table = target(TABLE, TABLE), numbers = target(POINTS, 2);
  gl.bindVertexArray(gl.createVertexArray());

  const begin = (name, to, from) => {
    programs[name].use();
    gl.bindFramebuffer(gl.FRAMEBUFFER, to ? to.framebuffer : null);
    gl.viewport(0, 0, to ? to.width : canvas.width, to ? to.height : canvas.height);
    gl.bindTexture(gl.TEXTURE_2D, from ? from.texture : null);
    gl.uniform1i(programs[name].at("albedo_table"), 0);
    for (const [slot, index] of Object.entries(state.chosen)) gl.uniform1i(programs[name].at("chosen_" + slot), index);
    return programs[name];
  };
  const draw = () => gl.drawArrays(gl.TRIANGLES, 0, 3);

  // The table depends on the terms alone.
  let tabled = "";
  const makeTable = () => {
    const key = JSON.stringify([state.chosen, state.environment_masking]);
    if (key === tabled) return;
    tabled = key;
    const p = begin("albedo", first, null);
    gl.uniform1i(p.at("chosen_masking"), state.environment_masking);
    draw();
    begin("average", table, first);
    draw();
  };

  const radians = (degrees) => (degrees * Math.PI) / 180;
  const surfaceOf = (p) => {
    const v = state.values;
    gl.uniform4f(p.at("surface"), v.roughness, v.metallic, v.f0, v.base);
  };

  // n.v, n.l, n.h, v.h. The viewer is on the left: at azimuth 0 a light on the right stands opposite.
  const cosines = () => {
    const view = radians(state.values.view_deg), light = radians(state.values.light_deg);
    const nv = Math.max(Math.cos(view), 1e-4), nl = Math.max(Math.cos(light), 0);
    const vl = nv * nl - Math.sin(view) * Math.sin(light) * Math.cos(radians(state.values.azimuth_deg));
    const vh = Math.sqrt(Math.max(0.5 + 0.5 * vl, 0));
    return [nv, nl, Math.min(1, (nv + nl) / Math.max(2 * vh, 1e-9)), vh];
  };
  const NAMES = ["D", "G", "V", "F", "specular", "diffuse", "full", "model_specular", "model_diffuse",
    "n_dot_v", "n_dot_l", "n_dot_h", "v_dot_h", "reflected", "transmitted"];
  const ask = () => {
    makeTable();
    const p = begin("probe", numbers, table);
    surfaceOf(p);
    gl.uniform4f(p.at("cosines"), ...cosines());
    gl.uniform1f(p.at("view"), radians(state.values.view_deg));
    gl.uniform1i(p.at("curve"), config.curve.index);
    draw();
    const bits = new Uint32Array(POINTS * 2 * 4);
    gl.readPixels(0, 0, POINTS, 2, gl.RGBA_INTEGER, gl.UNSIGNED_INT, bits);
    const floats = new Float32Array(bits.buffer);
    return {
      values: Object.fromEntries(NAMES.map((name, i) => [name, floats[i * 4]])),
      curve: Array.from({ length: POINTS }, (_, i) => floats[(POINTS + i) * 4]),
    };
  };

  const style = (name) => getComputedStyle(root).getPropertyValue(name).trim();
  const rgb = (text) => {
    const m = /^#(..)(..)(..)$/.exec(text);
    return m ? m.slice(1).map((h) => parseInt(h, 16) / 255) : [1, 1, 1];
  };

  const drawBall = () => {
    makeTable();
    const p = begin("canvas", null, table);
    surfaceOf(p);
    const v = state.values, a = radians(v.light_deg), turn = radians(v.azimuth_deg);
    gl.uniform2f(p.at("size_px"), canvas.width, canvas.height);
    gl.uniform3f(p.at("to_light"), Math.sin(a) * Math.cos(turn), Math.sin(a) * Math.sin(turn), Math.cos(a));
    gl.uniform1f(p.at("intensity"), v.intensity);
    gl.uniform1i(p.at("view"), state.view);
    gl.uniform1i(p.at("furnace"), state.furnace ? 1 : 0);
    gl.uniform3f(p.at("base_tint"), ...(state.furnace ? [1, 1, 1] : [1, 0.62, 0.33]));
    gl.uniform3f(p.at("page_color"), ...rgb(style("--pane")));
    draw();
  };

  const short = (x) => String(+x.toPrecision(2));
  const number = (x) => (Math.abs(x) >= 1000 || (x !== 0 && Math.abs(x) < 0.001) ? x.toExponential(3) : x.toPrecision(4));

  const drawCurve = (points) => {
    const c = chart.getContext("2d"), scale = chart.width / 360;
    const width = 360, height = chart.height / scale, left = 44, bottom = height - 34, top = 16;
    c.setTransform(scale, 0, 0, scale, 0, 0);
    c.clearRect(0, 0, width, height);
    c.font = "12px system-ui, sans-serif";
    c.lineWidth = 1;
    c.strokeStyle = style("--line");
    c.fillStyle = style("--faint");
    const peak = Math.max(...points.filter(Number.isFinite), 1e-6);
    if (config.curve.index === 0) {
      const cx = width / 2, r = Math.min(width / 2 - 22, bottom - top), base = Math.min(bottom, (height + r) / 2);
      c.textAlign = "center";
      for (const share of [0.25, 0.5, 0.75, 1]) {
        c.beginPath();
        c.arc(cx, base, r * Math.sqrt(share), Math.PI, 0);
        c.stroke();
        if (share !== 0.75) c.fillText(short(peak * share), cx + r * Math.sqrt(share), base + 15);
      }
      const ray = (degrees, color, length) => {
        c.strokeStyle = color;
        c.beginPath();
        c.moveTo(cx, base);
        c.lineTo(cx + length * Math.sin(radians(degrees)), base - length * Math.cos(radians(degrees)));
        c.stroke();
      };
      ray(0, style("--line"), r);
      c.lineWidth = 2;
      ray(-state.values.view_deg, style("--accent2"), r);
      c.strokeStyle = style("--accent");
      c.beginPath();
      points.forEach((f, i) => {
        const angle = radians((i / (POINTS - 1)) * 179 - 89.5), length = r * Math.sqrt(Math.max(f, 0) / peak);
        c.lineTo(cx + length * Math.sin(angle), base - length * Math.cos(angle));
      });
      c.stroke();
      c.fillText(config.curve.label, cx, base + 36);
      return;
    }
    const high = config.curve.index === 1 ? peak * 1.05 : Math.max(1, peak * 1.02);
    c.textAlign = "right";
    for (let i = 0; i <= 4; ++i) {
      const y = bottom - ((bottom - top) * i) / 4;
      c.beginPath();
      c.moveTo(left, y);
      c.lineTo(width - 8, y);
      c.stroke();
      c.fillText(number((high * i) / 4), left - 5, y + 4);
    }
    c.textAlign = "center";
    for (let d = 0; d <= 90; d += 30) c.fillText(d + "°", left + ((width - 8 - left) * d) / 90, bottom + 14);
    c.fillText(config.curve.label, (left + width) / 2, height - 4);
    c.strokeStyle = style("--accent");
    c.lineWidth = 2;
    c.beginPath();
    points.forEach((f, i) => c.lineTo(left + ((width - 8 - left) * i * 89.9) / 90 / (POINTS - 1),
      bottom - (bottom - top) * Math.min(1, f / high)));
    c.stroke();
  };

  const table_ = root.querySelector("table.values");
  const show = () => {
    drawBall();
    const { values, curve } = ask();
    drawCurve(curve);
    table_.replaceChildren(...["n_dot_v", "n_dot_l", "n_dot_h", "v_dot_h", "D", "F", "G", "specular", "diffuse", "full",
      "reflected", "transmitted"].map((name) => {
      const row = document.createElement("tr");
      const th = document.createElement("th"), td = document.createElement("td");
      th.textContent = words[name] ?? name;
      td.textContent = number(values[name]);
      row.append(th, td);
      return row;
    }));
  };
  let pending = false;
  const soon = () => {
    if (pending) return;
    pending = true;
    requestAnimationFrame(() => { pending = false; show(); });
  };

  const fit = () => {
    const pixels = Math.min(window.devicePixelRatio || 1, 2);
    for (const one of [canvas, chart]) {
      const width = Math.max(64, Math.round(one.clientWidth * pixels)), height = Math.max(64, Math.round(one.clientHeight * pixels));
      if (one.width !== width || one.height !== height) { one.width = width; one.height = height; }
    }
    soon();
  };

  // Controls.
  const controls = root.querySelector(".controls"), inputs = {}, selects = {};
  const labelled = (text, element) => {
    const label = document.createElement("label");
    const span = document.createElement("span");
    span.textContent = text;
    label.append(span, element);
    return label;
  };
  const set = (name, value) => {
    state.values[name] = value;
    const input = inputs[name];
    if (input) { input.range.value = value; input.output.textContent = number(+value); }
    soon();
  };
  for (const slider of config.sliders) {
    if (!slider.shown) continue;
    const range = document.createElement("input"), output = document.createElement("output");
    Object.assign(range, { type: "range", min: slider.low, max: slider.high, step: slider.step, value: slider.value, name: slider.name });
    range.addEventListener("input", () => set(slider.name, +range.value));
    inputs[slider.name] = { range, output };
    const label = labelled(slider.label, range);
    label.append(output);
    output.textContent = number(slider.value);
    controls.append(label);
  }
  const choose = (slot, index) => {
    state.chosen[slot] = index;
    if (slot === "masking") state.environment_masking = index;
    if (selects[slot]) selects[slot].value = index;
    mark(-1);
    soon();
  };
  for (const { slot, values } of config.switches) {
    const select = document.createElement("select");
    select.name = slot;
    values.forEach((value, i) => {
      const option = document.createElement("option");
      option.value = i;
      option.textContent = value.name;
      option.title = value.help;
      select.append(option);
    });
    select.value = state.chosen[slot];
    select.addEventListener("change", () => choose(slot, +select.value));
    selects[slot] = select;
    controls.append(labelled(words["slot_" + slot] ?? slot, select));
  }
  const buttons = root.querySelector(".models");
  const mark = (index) => [...buttons.children].forEach((b, i) => b.setAttribute("aria-pressed", i === index));
  const take = (index) => {
    const model = config.models[index];
    state.chosen = { ...model.chosen };
    state.environment_masking = model.environment_masking;
    for (const [slot, select] of Object.entries(selects)) select.value = state.chosen[slot];
    mark(index);
    soon();
  };
  if (config.models.length > 1)
    config.models.forEach((model, i) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = model.name;
      button.addEventListener("click", () => take(i));
      buttons.append(button);
    });
  mark(0);
  const views = document.createElement("select");
  views.name = "view";
  for (const view of config.views) {
    const option = document.createElement("option");
    option.value = view.index;
    option.textContent = view.label;
    views.append(option);
  }
  const look = (index) => { state.view = index; views.value = index; soon(); };
  views.addEventListener("change", () => look(+views.value));
  if (config.views.length > 1) controls.append(labelled(words.ball, views));
  const light = document.createElement("select");
  light.name = "light";
  [words.light, words.furnace].forEach((text, i) => {
    const option = document.createElement("option");
    option.value = i;
    option.textContent = text;
    light.append(option);
  });
  light.value = state.furnace ? 1 : 0;
  light.addEventListener("change", () => { state.furnace = light.value === "1"; soon(); });
  controls.append(labelled(words.lit_by, light));

  // A drag over the ball turns the light around it.
  const drag = (event) => {
    if (!(event.buttons & 1) && event.type !== "pointerdown") return;
    const box = canvas.getBoundingClientRect(), half = Math.min(box.width, box.height) / 2;
    const x = (event.clientX - box.left - box.width / 2) / half, y = (box.top + box.height / 2 - event.clientY) / half;
    const tilt = Math.min(89, Math.hypot(x, y) * 80);
    const side = y < 0 || (y === 0 && x < 0) ? -1 : 1;
    set("light_deg", Math.round(side * tilt));
    set("azimuth_deg", Math.round((Math.atan2(side * y, side * x) * 180) / Math.PI));
    event.preventDefault();
  };
  canvas.addEventListener("pointerdown", (event) => { canvas.setPointerCapture(event.pointerId); drag(event); });
  canvas.addEventListener("pointermove", drag);

  new ResizeObserver(fit).observe(root);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", soon);
  window.addEventListener("beforeprint", show);
  fit();
  show();
  // For people who look under the hood, and for tests.
  window.facet = { values: () => ask().values, curve: () => ask().curve, set, choose, take, look,
    furnace: (on) => { state.furnace = on; light.value = on ? 1 : 0; soon(); }, show,
    pixel: (x, y) => {
      show();
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      const out = new Uint8Array(4);
      gl.readPixels(Math.round(x * canvas.width), Math.round(y * canvas.height), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, out);
      return [...out];
    } };
})();
