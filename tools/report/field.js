// The live field of a report: a map, the profile and the stress below a line that pointer and keys move.

// ---- fields: deflated differences of whole numbers along the rows, of two bytes first all high ones ----

async function inflated(text) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
const stops = text => text.split(' ').map(c => [1, 3, 5].map(at => parseInt(c.slice(at, at + 2), 16)));
// { values, label, unit, step, colours, range, words }; a missing value is NaN.
async function unpacked(script, row) {
  const d = script.dataset,
    raw = await inflated(script.textContent),
    n = raw.length / 2;
  const values = new Float64Array(n),
    low = +d.low,
    step = +d.step,
    words = d.words ? d.words.split(' ') : null;
  for (let k = 0, sum = 0; k < n; ++k) {
    sum = ((k % row ? sum : 0) + ((raw[k] << 8) | raw[n + k])) & 65535;
    values[k] = sum === 65535 ? NaN : low + step * sum;
  }
  return {
    values,
    step,
    words,
    colours: stops(d.colours),
    label: d.label,
    unit: d.unit,
    range: range(d.range),
  };
}
const shown = (field, v) =>
  `${field.label} ${field.words?.[v]?.replace(/_/g, ' ') ?? number(v, 10 * field.step)}` +
  (Number.isFinite(v) && field.unit ? ` ${field.unit}` : '');

// ---- drawing ----

const axis_label = (label, unit) => (unit ? `${label} [${unit}]` : label);
function ticks([a, b], most) {
  const low = Math.min(a, b),
    high = Math.max(a, b),
    raw = (high - low) / most,
    decade = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find(d => d * decade >= 0.999 * raw) * decade,
    out = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) out.push(k * step);
  return out.map(v => ({ v, text: number(v, step) }));
}
function colour_at(colours, share) {
  const at = clamp(share, 0, 1) * (colours.length - 1),
    k = Math.min(colours.length - 2, Math.floor(at));
  return [0, 1, 2].map(c => mix([colours[k][c], colours[k + 1][c]], at - k));
}
// Axes around a panel of this height; `right` is kept free. Sharp on any screen: sizes are in CSS pixels.
function frame(canvas, height, x, y, xlabel, ylabel, right = 8) {
  const wide = canvas.clientWidth,
    ratio = Math.max(2, devicePixelRatio),
    g = canvas.getContext('2d');
  Object.assign(canvas, { width: wide * ratio, height: (height + 48) * ratio }).style.height =
    `${height + 48}px`;
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.font = '12px system-ui, sans-serif';
  g.fillStyle = g.strokeStyle = getComputedStyle(canvas).color;
  const rows = ticks(y, Math.max(3, height / 45)),
    left = 28 + Math.max(...rows.map(t => g.measureText(t.text).width));
  const width = Math.max(40, wide - left - right),
    top = 8;
  const px = v => left + ((v - x[0]) / (x[1] - x[0])) * width,
    py = v => top + ((y[1] - v) / (y[1] - y[0])) * height;
  g.strokeRect(left, top, width, height);
  g.textAlign = 'center';
  for (const { v, text } of ticks(x, Math.max(3, width / 70))) {
    g.fillRect(px(v) - 0.5, top + height, 1, 4);
    g.fillText(text, clamp(px(v), 0, wide - 12), top + height + 17);
  }
  g.fillText(xlabel, left + width / 2, top + height + 34, wide);
  g.textAlign = 'right';
  for (const { v, text } of rows) {
    g.fillRect(left - 4, py(v) - 0.5, 4, 1);
    g.fillText(text, left - 7, py(v) + 4);
  }
  g.save();
  g.translate(12, top + height / 2);
  g.rotate(-Math.PI / 2);
  g.textAlign = 'center';
  g.fillText(ylabel, 0, 0, height + 40);
  g.restore();
  const share = event => [(event.offsetX - left) / width, 1 - (event.offsetY - top) / height];
  return (canvas.frame = { g, left, top, width, height, px, py, share });
}
// Cells of nx × ny, row by row along the second axis: upwards, or down.
function painted(values, nx, ny, [low, high], colours, upwards) {
  const picture = new OffscreenCanvas(nx, ny),
    pen = picture.getContext('2d'),
    image = pen.createImageData(nx, ny);
  const table = Array.from({ length: 256 }, (_, k) => colour_at(colours, k / 255));
  for (let i = 0; i < nx; ++i)
    for (let j = 0; j < ny; ++j) {
      const v = values[i * ny + j],
        hatch = (i + j) % 6 < 2 ? 140 : 225;
      const colour = Number.isNaN(v)
        ? [hatch, hatch, hatch]
        : table[Math.round(255 * clamp((v - low) / (high - low), 0, 1))];
      image.data.set([...colour, 255], 4 * ((upwards ? ny - 1 - j : j) * nx + i));
    }
  pen.putImageData(image, 0, 0);
  return picture;
}
// The picture in a frame, and the bar of its colours.
function show(f, picture, [low, high], colours) {
  f.g.imageSmoothingEnabled = false;
  f.g.drawImage(picture, f.left, f.top, f.width, f.height);
  const x = f.left + f.width + 8,
    y = v => f.top + ((high - v) / (high - low)) * f.height;
  for (let k = 0; k < f.height; ++k) {
    f.g.fillStyle = `rgb(${colour_at(colours, 1 - k / f.height)})`;
    f.g.fillRect(x, f.top + k, 11, 1.5);
  }
  f.g.fillStyle = f.g.strokeStyle;
  f.g.textAlign = 'left';
  for (const { v, text } of ticks([low, high], Math.max(3, f.height / 40)))
    f.g.fillText(text, x + 15, y(v) + 4);
}

// ---- the live field ----

async function viewer(box) {
  const d = box.dataset,
    nx = +d.nx,
    ny = +d.ny,
    ends = { x: range(d.x), y: range(d.y) },
    unit = d.unit;
  const part = name => box.querySelector('.' + name),
    scripts = [...box.querySelectorAll('.field')],
    store = [];
  const places = { x: nx, y: ny },
    at = Object.fromEntries(['x', 'y'].map((a, k) => [a, range(d.at)[k]]));
  const centre = (axis, k) => mix(ends[axis], (k + 0.5) / places[axis]);
  const place = (axis, k) =>
    `${axis} = ${number(centre(axis, k), Math.abs(ends[axis][1] - ends[axis][0]) / 2000)} ${unit}`;
  const index = (axis, share) => clamp(Math.floor(share * places[axis]), 0, places[axis] - 1);
  const deep = part('volume') && (await depths_of(part('volume')));
  let field,
    along = 'x',
    colours,
    picture;
  const across = () => (along === 'x' ? 'y' : 'x');

  async function choose() {
    const k = part('which').selectedIndex;
    const chosen = (store[k] ??= await unpacked(scripts[k], ny));
    if (k !== part('which').selectedIndex) return;  // another was chosen since
    field = chosen;
    colours = field.range;
    if (part('robust').checked) {
      const sorted = field.values.filter(Number.isFinite).sort(),
        q = share => sorted[Math.floor(share * (sorted.length - 1))];
      const [low, high] = [q(0.01), q(0.99)],
        most = Math.max(-low, high);
      if (high > low) colours = colours[0] === -colours[1] ? [-most, most] : [low, high];
    }
    picture = painted(field.values, nx, ny, colours, field.colours, true);
    draw();
  }
  function draw_map() {
    const canvas = part('map'),
      true_aspect = (ends.y[1] - ends.y[0]) / (ends.x[1] - ends.x[0]),
      aspect = clamp(true_aspect, 0.16, 1.6);
    const longer = aspect / true_aspect,
      stretch =
        Math.abs(longer - 1) < 0.01
          ? ''
          : longer > 1
            ? `, y \u00d7 ${longer.toPrecision(2)}`
            : `, x \u00d7 ${(1 / longer).toPrecision(2)}`;
    const height = Math.max(60, aspect * (canvas.clientWidth - 120));
    const f = frame(canvas, height, ends.x, ends.y, `x [${unit}]${stretch}`, `y [${unit}]`, 66);
    show(f, picture, colours, field.colours);
    const x = f.px(centre('x', at.x)),
      y = f.py(centre('y', at.y));
    // White below black is seen on any colour.
    for (const [strokeStyle, lineWidth] of Object.entries({ '#fff': 3, '#000': 1 })) {
      Object.assign(f.g, { strokeStyle, lineWidth });
      f.g.beginPath();
      along === 'x'
        ? (f.g.moveTo(f.left, y), f.g.lineTo(f.left + f.width, y))
        : (f.g.moveTo(x, f.top), f.g.lineTo(x, f.top + f.height));
      f.g.moveTo(x + 4, y);
      f.g.arc(x, y, 4, 0, 7);
      f.g.stroke();
    }
  }
  const value = (i, j) => field.values[i * ny + j];
  const on_line = k => (along === 'x' ? value(k, at.y) : value(at.x, k));
  function draw_profile() {
    const n = places[along],
      line = Array.from({ length: n }, (_, k) => on_line(k));
    const [low, high] = field.range,
      room = 0.05 * (high - low),
      label = `${along} [${unit}] at ${place(across(), at[across()])}`;
    const y = [low === 0 ? 0 : low - room, high + room];
    const f = frame(
      part('profile'),
      clamp(part('map').frame.height, 140, 320),
      ends[along],
      y,
      label,
      axis_label(field.label, field.unit),
    );
    f.g.beginPath();
    line.forEach(
      (v, k) =>
        Number.isNaN(v) ||
        f.g[k === 0 || Number.isNaN(line[k - 1]) ? 'moveTo' : 'lineTo'](f.px(centre(along, k)), f.py(v)),
    );
    Object.assign(f.g, {
      strokeStyle: getComputedStyle(box).getPropertyValue('--accent'),
      lineWidth: 1.6,
    }).stroke();
    if (Number.isNaN(line[at[along]])) return;
    f.g.beginPath();
    f.g.arc(f.px(centre(along, at[along])), f.py(line[at[along]]), 3.5, 0, 7);
    f.g.fill();
  }
  function draw_below() {
    const canvas = part('below'),
      z = [deep.z[0], deep.z.at(-1)],
      rows = 160,
      n = along === 'x' ? deep.nx : deep.ny;
    const cut = new Float64Array(n * rows);
    for (let c = 0; c < n; ++c)
      for (let r = 0; r < rows; ++r) cut[c * rows + r] = stress(c, mix(z, (r + 0.5) / rows));
    const height = clamp(
      ((z[1] - z[0]) / (ends[along][1] - ends[along][0])) * (canvas.clientWidth - 120),
      80,
      260,
    );
    const f = frame(canvas, height, ends[along], [z[1], z[0]], `${along} [${unit}]`, `depth [${unit}]`, 66);
    show(f, painted(cut, n, rows, deep.range, deep.colours, false), deep.range, deep.colours);
  }
  // In the section, linear between the depths.
  function stress(column, z) {
    const other = Math.min(
      (along === 'x' ? deep.ny : deep.nx) - 1,
      Math.floor(((at[across()] + 0.5) / places[across()]) * (along === 'x' ? deep.ny : deep.nx)),
    );
    const k = clamp(deep.z.findLastIndex(v => v <= z), 0, deep.z.length - 2),
      q = clamp((z - deep.z[k]) / (deep.z[k + 1] - deep.z[k]), 0, 1);
    const [i, j] = along === 'x' ? [column, other] : [other, column],
      of = k => deep.values[(k * deep.nx + i) * deep.ny + j];
    return mix([of(k), of(k + 1)], q);
  }
  const words = (i, j) => `${shown(field, value(i, j))} at ${place('x', i)}, ${place('y', j)}`;
  function tell() {
    part('readout').textContent = words(at.x, at.y);
  }
  function draw() {
    draw_map();
    draw_profile();
    if (deep) draw_below();
    for (const axis of ['x', 'y']) {
      part(axis).value = at[axis];
      part(axis).setAttribute('aria-valuetext', place(axis, at[axis]));
    }
    const [low, high] = field.range.map(v => number(v, 10 * field.step));
    part('map').setAttribute('aria-label', `Map of ${field.label}, ${low} to ${high} ${field.unit}`);
    part('profile').setAttribute(
      'aria-label',
      `Profile of ${field.label} along ${along} at ${place(across(), at[across()])}`,
    );
    part('below')?.setAttribute('aria-label', `${deep.label} below this line`);
    tell();
  }

  for (const script of scripts)
    part('which').add(new Option(axis_label(script.dataset.label, script.dataset.unit)));
  part('which').onchange = part('robust').onchange = choose;
  part('along').onchange = event => {
    along = event.target.value;
    draw();
  };
  for (const axis of ['x', 'y']) {
    part(axis).max = places[axis] - 1;
    part(axis).oninput = event => {
      at[axis] = +event.target.value;
      draw();
    };
  }
  part('map').onpointerdown = part('map').onpointermove = event => {
    const [x, y] = part('map').frame.share(event);
    if (event.buttons === 0) return void (part('readout').textContent = words(index('x', x), index('y', y)));
    Object.assign(at, { x: index('x', x), y: index('y', y) });
    requestAnimationFrame(draw);
  };
  part('profile').onpointermove = event => {
    const k = index(along, part('profile').frame.share(event)[0]);
    part('readout').textContent = along === 'x' ? words(k, at.y) : words(at.x, k);
  };
  if (deep)
    part('below').onpointermove = event => {
      const [s, up] = part('below').frame.share(event),
        n = along === 'x' ? deep.nx : deep.ny,
        c = clamp(Math.floor(s * n), 0, n - 1);
      const z = clamp(mix([deep.z.at(-1), deep.z[0]], up), deep.z[0], deep.z.at(-1));
      part('readout').textContent =
        `${shown({ ...deep, step: deep.step / 10 }, stress(c, z))} at ${place(along, index(along, s))}, ` +
        `depth ${number(z, deep.z.at(-1) / 500)} ${unit}`;
    };
  for (const name of ['map', 'profile', 'below']) if (part(name)) part(name).onpointerleave = tell;
  document.documentElement.classList.add('live');
  await choose();
  addEventListener('resize', draw);
  matchMedia('(prefers-color-scheme: dark)').onchange = draw;
}
// A volume of one byte a cell, differences from depth to depth; 255 is missing.
async function depths_of(script) {
  const d = script.dataset,
    raw = await inflated(script.textContent),
    nx = +d.nx,
    ny = +d.ny,
    low = +d.low,
    step = +d.step;
  for (let k = nx * ny; k < raw.length; ++k) raw[k] += raw[k - nx * ny];
  return {
    nx,
    ny,
    colours: stops(d.colours),
    step,
    z: range(d.z),
    range: range(d.range),
    label: d.label,
    unit: d.unit,
    values: Float64Array.from(raw, v => (v === 255 ? NaN : low + step * v)),
  };
}
// Without it the still figures stay.
for (const box of document.querySelectorAll('.viewer'))
  viewer(box).catch(() => document.documentElement.classList.remove('live'));
