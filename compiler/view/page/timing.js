// SPDX-License-Identifier: Apache-2.0
// The timing diagram: chosen devices over the last scans, with a cursor; export as VCD and CSV.
import {store, onDraw, drawSoon} from './link.js';
import {html} from './svg.js';

const ROW = 34, NAMES = 190, HEAD = 24;
let section, canvas, scroller, links, hint;
let chosen = [];
let rows = new Map();     // device -> [[scan, value], ...] ascending
let first = 0, last = -1; // scans that there are
let scale = 4;            // pixels a scan
let right = null;         // the scan at the right edge; null: the newest one
let cursor = null;        // a scan
let asking = false, askedScan = -1, run = 0;

export function setUp(panel) {
  section = panel;
  canvas = html('canvas', {tabindex: 0, role: 'img', 'aria-label': 'timing diagram'});
  hint = html('span', {class: 'hint'}, 'wheel or + − zooms, drag or ← → moves, click sets the cursor, end follows');
  links = html('span', {class: 'links'});
  const pick = html('input', {type: 'text', list: 'names', placeholder: 'Add a device', 'aria-label': 'add a device to the diagram'});
  pick.addEventListener('change', () => {
    const device = find(pick.value);
    if (device >= 0) addToTiming(device);
    pick.value = '';
  });
  scroller = html('div', {class: 'diagram'}, canvas);
  section.append(html('div', {class: 'bar'}, pick, links, hint), scroller);
  canvas.addEventListener('wheel', onWheel, {passive: false});
  canvas.addEventListener('pointerdown', onDown);
  canvas.addEventListener('keydown', onKey);
  new ResizeObserver(drawSoon).observe(section);
  onDraw(draw);
}

const find = (text) => {
  const name = text.split(' ')[0];
  return store.model.devices.findIndex((device) => device.name === name || device.name.toUpperCase() === name.toUpperCase());
};

// At first inputs and outputs.
export function load(model) {
  const some = [];
  model.devices.forEach((device, i) => {
    if ((device.input && !device.word) || device.output) some.push(i);
  });
  chosen = some.slice(0, 16);
  forget();
}

function forget() {
  rows = new Map(chosen.map((device) => [device, []]));
  first = 0;
  last = -1;
  askedScan = -1;
  const query = chosen.join(',');
  links.replaceChildren(html('a', {href: `api/rung.vcd?d=${query}`, download: 'rung.vcd'}, 'VCD'), ' ',
    html('a', {href: `api/rung.csv?d=${query}`, download: 'rung.csv'}, 'CSV'));
  drawSoon();
}

export function addToTiming(device) {
  if (!chosen.includes(device)) {
    chosen.push(device);
    forget();
  }
}

// Only what is newer than what is here.
async function ask() {
  if (asking || !store.frame || chosen.length === 0) return;
  if (store.frame.run !== run) {
    run = store.frame.run;
    forget();
  }
  if (store.frame.scan === askedScan) return;
  asking = true;
  askedScan = store.frame.scan;
  try {
    const answer = await fetch(`api/history?from=${last + 1}&d=${chosen.join(',')}`);
    const history = await answer.json();
    if (history.run === run) merge(history);
  } catch { /* the line to the server says so */ }
  asking = false;
  drawSoon();
}

function merge(history) {
  first = history.first;
  last = history.last;
  for (const {device, changes} of history.rows) {
    const row = rows.get(device);
    if (!row) continue;
    for (let i = 0; i < changes.length; i += 2) {
      if (row.length === 0 || row.at(-1)[1] !== changes[i + 1]) row.push([changes[i], changes[i + 1]]);
    }
    while (row.length > 1 && row[1][0] <= first) row.shift();
  }
}

// Index of the change that holds in this scan.
function changeAt(row, scan) {
  let low = 0, high = row.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (row[middle][0] <= scan) low = middle;
    else high = middle - 1;
  }
  return low;
}

function draw() {
  if (section.hidden || !store.model) return;
  ask();
  const ratio = devicePixelRatio;
  const width = scroller.clientWidth, height = HEAD + chosen.length * ROW + 10;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.height = `${height}px`;
    canvas.style.width = `${width}px`;
  }
  const context = canvas.getContext('2d');
  const style = getComputedStyle(document.documentElement);
  const color = (name) => style.getPropertyValue(name);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  const end = right ?? last + 1;
  const begin = end - (width - NAMES) / scale;
  const x = (scan) => NAMES + (scan - begin) * scale;
  drawScale(context, begin, end, x, width, height, color);
  chosen.forEach((device, i) => drawRow(context, device, HEAD + i * ROW, begin, end, x, color));
  if (cursor !== null && cursor >= begin && cursor <= end) {
    context.strokeStyle = color('--accent');
    context.beginPath();
    context.moveTo(x(cursor + 0.5), 0);
    context.lineTo(x(cursor + 0.5), height);
    context.stroke();
  }
}

function drawScale(context, begin, end, x, width, height, color) {
  context.font = '12px system-ui';
  context.textBaseline = 'middle';
  context.fillStyle = color('--soft');
  const rough = 90 / scale;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = Math.max(1, [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough));
  context.strokeStyle = color('--grid');
  context.beginPath();
  for (let scan = Math.max(0, Math.ceil(begin / step) * step); scan <= end; scan += step) {
    if (x(scan) < NAMES) continue;
    context.moveTo(Math.round(x(scan)) + 0.5, HEAD - 6);
    context.lineTo(Math.round(x(scan)) + 0.5, height);
    context.fillText(`${scan}`, x(scan) + 3, 9);
  }
  context.stroke();
  if (cursor !== null) {
    context.fillStyle = color('--text');
    context.fillText(`scan ${cursor}, ${(cursor * store.model.tick_us / 1000).toFixed(0)} ms`, 6, 9);
  }
}

function drawRow(context, device, top, begin, end, x, color) {
  const about = store.model.devices[device];
  const row = rows.get(device) ?? [];
  context.font = '13px system-ui';
  context.fillStyle = color('--text');
  const at = cursor === null ? last : cursor;
  const value = row.length ? row[changeAt(row, at)][1] : store.values[device];
  context.fillText(about.name, 6, top + ROW / 2 - (about.comment ? 7 : 0));
  context.textAlign = 'right';
  context.fillText(String(value), NAMES - 10, top + ROW / 2);
  context.textAlign = 'left';
  if (about.comment) {
    context.fillStyle = color('--soft');
    context.font = '11px system-ui';
    context.fillText(about.comment.slice(0, 20), 6, top + ROW / 2 + 8);
  }
  if (row.length === 0) return;
  context.save();
  context.beginPath();
  context.rect(NAMES, top, 1e5, ROW);
  context.clip();
  const stop = Math.min(end, last + 1);
  if (about.word) drawWord(context, row, top, begin, stop, x, color);
  else drawBit(context, row, top, begin, stop, x, color);
  context.restore();
}

function drawBit(context, row, top, begin, stop, x, color) {
  const y = (value) => top + (value ? 7 : ROW - 8);
  context.strokeStyle = color('--power');
  context.fillStyle = color('--power-soft');
  context.lineWidth = 1.5;
  context.beginPath();
  let i = changeAt(row, begin);
  context.moveTo(x(Math.max(row[i][0], begin)), y(row[i][1]));
  for (; i < row.length && row[i][0] < stop; i++) {
    const from = x(Math.max(row[i][0], begin)), to = x(Math.min(row[i + 1]?.[0] ?? stop, stop));
    context.lineTo(from, y(row[i][1]));
    context.lineTo(to, y(row[i][1]));
    if (row[i][1]) context.fillRect(from, y(1), to - from, y(0) - y(1));
  }
  context.stroke();
  context.lineWidth = 1;
}

function drawWord(context, row, top, begin, stop, x, color) {
  context.strokeStyle = color('--word');
  context.font = '12px system-ui';
  const up = top + 7, down = top + ROW - 8, middle = (up + down) / 2;
  for (let i = changeAt(row, begin); i < row.length && row[i][0] < stop; i++) {
    const from = x(Math.max(row[i][0], begin)), to = x(Math.min(row[i + 1]?.[0] ?? stop, stop));
    const edge = Math.min(3, (to - from) / 2);
    context.beginPath();
    context.moveTo(from, middle);
    context.lineTo(from + edge, up);
    context.lineTo(to - edge, up);
    context.lineTo(to, middle);
    context.lineTo(to - edge, down);
    context.lineTo(from + edge, down);
    context.closePath();
    context.stroke();
    const text = String(row[i][1]);
    if (to - from > text.length * 7 + 6) {
      context.fillStyle = color('--text');
      context.fillText(text, Math.max(from, NAMES) + 5, middle);
    }
  }
}

// ---- pointer and keys ---------------------------------------------------------------------------------

const span = () => (scroller.clientWidth - NAMES) / scale;
const scanAt = (px) => Math.floor((right ?? last + 1) - span() + (px - NAMES) / scale);

function zoom(factor, px = scroller.clientWidth) {
  const anchor = (right ?? last + 1) - span() + (px - NAMES) / scale;
  scale = Math.max(0.02, Math.min(80, scale * factor));
  if (right !== null) right = anchor + (scroller.clientWidth - px) / scale;
  drawSoon();
}

function move(scans) {
  right = (right ?? last + 1) + scans;
  if (right >= last + 1) right = null;
  else right = Math.max(right, first + 1);
  drawSoon();
}

function onWheel(event) {
  event.preventDefault();
  if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) move((event.deltaX || event.deltaY) / scale);
  else zoom(event.deltaY < 0 ? 1.25 : 0.8, event.offsetX);
}

function onDown(event) {
  canvas.setPointerCapture(event.pointerId);
  let moved = 0, before = event.offsetX;
  const drag = (each) => {
    moved += Math.abs(each.offsetX - before);
    if (moved > 4) move((before - each.offsetX) / scale);
    before = each.offsetX;
  };
  canvas.addEventListener('pointermove', drag);
  canvas.addEventListener('pointerup', (each) => {
    canvas.removeEventListener('pointermove', drag);
    if (moved > 4 || each.offsetX < NAMES) return;
    cursor = Math.max(first, Math.min(last, scanAt(each.offsetX)));
    if (right === null) right = last + 1;  // the cursor stays where it was set
    drawSoon();
  }, {once: true});
}

function onKey(event) {
  switch (event.key) {
    case '+': zoom(1.25); break;
    case '-': zoom(0.8); break;
    case 'ArrowLeft': event.shiftKey ? moveCursor(-1) : move(-span() / 8); break;
    case 'ArrowRight': event.shiftKey ? moveCursor(1) : move(span() / 8); break;
    case 'End': right = null; cursor = null; drawSoon(); break;
    case 'Home': right = first + span(); drawSoon(); break;
    default: return;
  }
  event.preventDefault();
}

function moveCursor(scans) {
  cursor = Math.max(first, Math.min(last, (cursor ?? last) + scans));
  drawSoon();
}
