'use strict';
// What moves on a report: tables are copied, curves read under the pointer (fields: field.js). All numbers
// stand on the page without it. The page gives data as attributes, in the units shown.

const range = text => text.split(' ').map(Number);
const clamp = (v, low, high) => Math.min(high, Math.max(low, v));
const mix = ([a, b], share) => a + (b - a) * share;
// With as many places as a step needs: 0.05 has two.
function number(v, step) {
  if (!Number.isFinite(v)) return 'missing';
  const places = Math.ceil(-Math.log10(step) - 1e-9);
  return (Math.abs(places) > 7 ? v.toExponential(3) : v.toFixed(Math.max(0, places))).replace(/-/g, '\u2212');
}
// "height [nm]" and a number: "height 3 nm".
const named = (label, text) =>
  label.replace(/ \[(.*)\]$|$/, (_, unit) => ` ${text}${unit ? ' ' + unit : ''}`);

// ---- tables: tabs between the exact numbers, in SI ----

const exact = cell => cell.dataset.tsv ?? cell.querySelector('data')?.value ?? cell.textContent.trim();
const table_text = table =>
  [...table.rows].map(row => [...row.cells].map(exact).join('\t')).join('\n') + '\n';
function copy(text) {
  const area = document.createElement('textarea'); // navigator.clipboard is not there on every page of a file
  area.value = text;
  document.body.append(area);
  area.select();
  const done = document.execCommand('copy');
  area.remove();
  return done;
}
for (const table of document.querySelectorAll('table')) {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'Copy as TSV';
  button.onclick = () => {
    button.textContent = copy(table_text(table)) ? 'Copied' : 'The browser does not allow it';
    button.focus();
    setTimeout(() => {
      button.textContent = 'Copy as TSV';
    }, 2000);
  };
  table.after(button);
}

// ---- curves: the vertices of the picture's own lines, by the axes of the panel they are in ----

const hex = colour =>
  '#' + (colour?.match(/\d+/g) ?? []).map(v => (+v).toString(16).padStart(2, '0')).join('');
function points_of(svg) {
  const names = new Map(svg.dataset.key.split('\n').map(line => [line.slice(0, 7), line.slice(8)]));
  const points = [],
    add = (x, y, colour) => names.has(hex(colour)) && points.push({ x, y, name: names.get(hex(colour)) });
  for (const path of svg.querySelectorAll('path[stroke]'))
    for (const [, x, y] of path.getAttribute('d').matchAll(/[ML]\s*([-\d.]+)[ ,]([-\d.]+)/g))
      add(+x, +y, path.getAttribute('stroke'));
  for (const mark of svg.querySelectorAll('use[color]'))
    add(
      ...mark
        .getAttribute('transform')
        .match(/[-\d.]+/g)
        .slice(0, 2)
        .map(Number),
      mark.getAttribute('color'),
    );
  for (const bar of svg.querySelectorAll('polygon')) {
    // of a histogram: the middle of its top
    const corners = [...bar.points];
    if (corners.length === 4)
      add((corners[0].x + corners[1].x) / 2, Math.min(...corners.map(p => p.y)), bar.getAttribute('fill'));
  }
  return points;
}
function panel_of(rect) {
  const [x, y, width, height] = ['x', 'y', 'width', 'height'].map(name => +rect.getAttribute(name)),
    d = rect.dataset;
  const inside = p => p.x >= x - 1 && p.x <= x + width + 1 && p.y >= y - 1 && p.y <= y + height + 1;
  const value = (ends, share, log) => (log ? Math.exp(mix(ends.map(Math.log), share)) : mix(ends, share));
  const words = (ends, share, log) => {
    const v = value(ends, share, log);
    return number(v, log ? v / 200 : Math.abs(ends[1] - ends[0]) / 1000);
  };
  const text = p =>
    (p.name ? `${p.name}: ` : '') +
    `${named(d.xlabel, words(range(d.x), (p.x - x) / width, d.log.includes('x')))}, ` +
    named(d.ylabel, words(range(d.y), 1 - (p.y - y) / height, d.log.includes('y')));
  return { inside, text };
}
for (const svg of document.querySelectorAll('figure svg[data-key]')) {
  const output = svg.closest('figure').querySelector('output');
  const panels = [...svg.querySelectorAll('.panel')].map(panel_of),
    ring = svg.querySelector('.ring');
  let points;
  svg.onpointermove = svg.onpointerdown = event => {
    points ??= points_of(svg);
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const panel = panels.find(p => p.inside(at)),
      far = p => (p.x - at.x) ** 2 + 0.05 * (p.y - at.y) ** 2;
    const near = panel && points.filter(panel.inside).reduce((a, b) => (a && far(a) <= far(b) ? a : b), null);
    ring.setAttribute('visibility', near ? 'visible' : 'hidden');
    output.textContent = near ? panel.text(near) : '';
    if (near) ring.setAttribute('transform', `translate(${near.x},${near.y})`);
  };
  output.dataset.hint = 'Point at a curve to read it.';
}
