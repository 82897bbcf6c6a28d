// SPDX-License-Identifier: Apache-2.0
// The ladder diagram. Only the rungs in sight are in the document; each is drawn once, and from then
// on only what has changed in it is touched.
import {store, bit, onDraw, drawSoon, command} from './link.js';
import {svg, html, cut} from './svg.js';
import {signOf, isBoxed} from './symbols.js';
import {openMenu} from './menu.js';

const ROW = 74, LEFT = 58, RIGHT = 30, WIRE = 44, NOTE = 19, GAP = 14;
const LEAST_CELL = 84, MOST_CELL = 112;

let pane, paper;
let CELL = 100;           // width of a column, as the window has room
let columns = 1;          // of the widest rung that is not too wide for any window
let tops = [];            // of each rung, and the end of the last one
const shown = new Map();  // rung -> its drawing
let cursor = {rung: 0, element: 0};
let marked = -1;          // a device whose places are marked

const heightOf = (rung) => rung.rows * ROW + (rung.note ? rung.note.split('\n').length * NOTE + 6 : 0) + GAP;

export function setUp(section) {
  pane = section;
  paper = html('div', {class: 'paper'});
  pane.append(paper);
  pane.addEventListener('scroll', drawSoon);
  new ResizeObserver(fit).observe(pane);
  pane.addEventListener('click', (event) => act(event, event.shiftKey));
  pane.addEventListener('contextmenu', (event) => {
    if (event.target.closest('.element')) {
      event.preventDefault();
      act(event, true);
    }
  });
  pane.addEventListener('keydown', onKey);
  onDraw(draw);
}

function clear() {
  for (const drawing of shown.values()) drawing.root.remove();
  shown.clear();
}

// As wide as the pane, within reason; what is wider still can be scrolled.
function fit() {
  if (!store.model || pane.clientWidth === 0) return;
  const room = (pane.clientWidth - LEFT - RIGHT) / columns;
  const cell = Math.max(LEAST_CELL, Math.min(MOST_CELL, Math.floor(room)));
  if (cell !== CELL) {
    CELL = cell;
    clear();
  }
  const widest = Math.max(1, ...store.model.rungs.map((rung) => rung.columns));
  paper.style.width = `${LEFT + widest * CELL + RIGHT}px`;
  drawSoon();
}

export function load(model) {
  clear();
  tops = [8];
  for (const rung of model.rungs) tops.push(tops.at(-1) + heightOf(rung));
  columns = Math.min(...model.rungs.map((rung) => rung.columns), 99);
  paper.style.height = `${tops.at(-1) + 40}px`;
  cursor = {rung: 0, element: 0};
  paper.replaceChildren();
  fit();
  if (model.rungs.length === 0) paper.append(html('p', {class: 'empty'}, 'This program has no ladder.'));
  drawSoon();
}

// ---- drawing a rung -------------------------------------------------------------------------------

function drawRung(rung, number) {
  const live = [];  // [element, net] of what has power or has not
  const notes = rung.note ? rung.note.split('\n') : [];
  const offset = notes.length ? notes.length * NOTE + 6 : 0;
  const height = rung.rows * ROW + offset;
  const right = LEFT + rung.columns * CELL;
  const root = svg('svg', {class: 'rung', width: right + RIGHT, height, role: 'group', 'aria-label': `rung ${number + 1}`});
  root.style.top = `${tops[number]}px`;
  notes.forEach((note, i) => root.append(svg('text', {x: LEFT, y: 14 + i * NOTE, class: 'note'}, note)));
  const y = (row) => offset + row * ROW + WIRE;
  const x = (column) => LEFT + column * CELL;
  const wire = (x1, y1, x2, y2, net) => {
    const element = svg('line', {x1, y1, x2, y2, class: 'wire'});
    live.push([element, net]);
    root.append(element);
  };
  root.append(svg('text', {x: 8, y: y(0) + 4, class: 'number'}, String(number + 1)));
  if (rung.line) root.append(svg('text', {x: 8, y: y(0) + 18, class: 'line-number'}, `l. ${rung.line}`));
  wire(LEFT, offset, LEFT, height, rung.rail);
  root.append(svg('line', {x1: right, y1: offset, x2: right, y2: height, class: 'wire rail'}));
  for (const [row, from, to, net] of rung.w) wire(x(from), y(row), x(to), y(row), net);
  for (const [column, from, to, net] of rung.u) wire(x(column), y(from), x(column), y(to), net);
  for (const [name, row, column, below, net] of rung.turns) {
    const ends = [svg('text', {x: x(column) - 4, y: y(row) - 6, class: 'turn', 'text-anchor': 'end'}, `▶${name}`),
      svg('text', {x: LEFT - 4, y: y(below) - 6, class: 'turn', 'text-anchor': 'end'}, `${name}▶`)];
    for (const end of ends) live.push([end, net]);
    root.append(...ends);
  }
  const elements = rung.e.map((element, i) => drawElement(element, i, x(element.c), y(element.r), live));
  root.append(...elements.map((each) => each.root));
  const drawing = {root, rung, number, live, elements, state: new Int8Array(live.length).fill(-1)};
  root.dataset.rung = number;
  return drawing;
}

function drawElement(element, index, x, y, live) {
  const width = element.w * CELL;
  const [half, shapes] = signOf(element, width);
  const middle = width / 2;
  const root = svg('g', {class: `element ${element.s}`, transform: `translate(${x} ${y})`, tabindex: -1, role: 'button'});
  root.dataset.element = index;
  const target = svg('rect', {x: 2, y: -WIRE + 4, width: width - 4, height: ROW - 6, class: 'target', rx: 4});
  const before = svg('line', {x1: 0, y1: 0, x2: middle - half, y2: 0, class: 'wire'});
  const after = svg('line', {x1: middle + half, y1: 0, x2: width, y2: 0, class: 'wire'});
  if (element.s === 'mark') {
    before.setAttribute('class', 'none');
    after.setAttribute('class', 'none');
  }
  live.push([before, element.in], [after, element.out]);
  const sign = svg('g', {transform: `translate(${middle} 0)`, class: 'body'}, ...shapes);
  root.append(target, before, after, sign);
  const device = element.d[0];
  const about = device === undefined ? null : store.model.devices[device];
  if (!isBoxed(element) && element.t) {
    root.append(svg('text', {x: middle, y: -17, class: 'name'}, cut(element.t, 14)));
    if (about?.comment) root.append(svg('text', {x: middle, y: -31, class: 'comment'}, cut(about.comment, 16)));
  } else if (about?.comment) {
    root.append(svg('text', {x: middle, y: -19, class: 'comment'}, cut(about.comment, 16 * element.w)));
  }
  const value = svg('text', {x: middle, y: 25, class: 'value'});
  const dot = svg('circle', {cx: middle + 30, cy: -20, r: 4, class: 'dot'});
  root.append(value, dot, svg('title', {}, titleOf(element)));
  return {root, element, value, text: '', flags: -1};
}

function titleOf(element) {
  const names = element.d.map((i) => {
    const device = store.model.devices[i];
    return device.comment ? `${device.name}  ${device.comment}` : device.name;
  });
  return [element.t, ...names].join('\n');
}

// ---- bringing it up to date -------------------------------------------------------------------------

function update(drawing) {
  const {live, state} = drawing;
  for (let i = 0; i < live.length; i++) {
    const on = bit(store.power, live[i][1]);
    if (state[i] === on) continue;
    state[i] = on;
    live[i][0].classList.toggle('on', on === 1);
  }
  for (const each of drawing.elements) updateElement(each);
}

function valueText(element) {
  const parts = [];
  for (const i of new Set(element.d)) {
    const device = store.model.devices[i];
    if (device.word) parts.push(element.d.length === 1 || isTimer(element) ? store.values[i] : `${device.name}=${store.values[i]}`);
  }
  return cut(parts.join('  '), element.w * 17);
}
const isTimer = (element) => element.d.length === 2 && !store.model.devices[element.d[0]].word;

function updateElement(each) {
  const {element} = each;
  const device = element.d[0];
  const conducts = bit(store.closed, element.i);
  const powered = bit(store.power, element.in === element.out ? element.in : element.out);
  const flags = conducts | powered << 1 | store.forced.has(device) << 2 | store.breaks.has(device) << 3 |
    (store.values[device] !== 0) << 4 | (marked >= 0 && element.d.includes(marked)) << 5;
  if (flags !== each.flags) {
    each.flags = flags;
    const list = each.root.classList;
    list.toggle('conducts', conducts === 1);
    list.toggle('powered', powered === 1);
    list.toggle('forced', store.forced.has(device));
    list.toggle('break', store.breaks.has(device));
    list.toggle('set', store.values[device] !== 0);
    list.toggle('marked', marked >= 0 && element.d.includes(marked));
    each.root.setAttribute('aria-label', `${element.t}, ${element.s.replace('-', ' ')}, ${powered ? 'power' : 'no power'}`);
  }
  const text = String(valueText(element));
  if (text !== each.text) each.value.textContent = each.text = text;
}

// The rung at this height.
function rungAt(top) {
  let low = 0, high = tops.length - 2;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (tops[middle] <= top) low = middle;
    else high = middle - 1;
  }
  return low;
}

function draw() {
  if (pane.hidden || !store.model || store.model.rungs.length === 0) return;
  const first = rungAt(pane.scrollTop - 100);
  const last = rungAt(pane.scrollTop + pane.clientHeight + 100);
  for (const [number, drawing] of shown) {
    if (number >= first && number <= last) continue;
    if (drawing.root.contains(document.activeElement)) continue;
    drawing.root.remove();
    shown.delete(number);
  }
  for (let number = first; number <= last; number++) {
    let drawing = shown.get(number);
    if (!drawing) {
      drawing = drawRung(store.model.rungs[number], number);
      shown.set(number, drawing);
      paper.append(drawing.root);
    }
    update(drawing);
  }
}

// ---- pointer and keys ---------------------------------------------------------------------------------

function at(node) {
  const element = node.closest?.('.element');
  const rung = node.closest?.('.rung');
  if (!element || !rung) return null;
  const place = {rung: Number(rung.dataset.rung), element: Number(element.dataset.element)};
  return {...place, node: element, what: store.model.rungs[place.rung].e[place.element]};
}

// An input toggles; anything else, or an input with `menu`, shows its menu.
function act(event, menu) {
  const place = at(event.target);
  if (!place) return;
  cursor = {rung: place.rung, element: place.element};
  focus(place.node);
  const device = place.what.d[0];
  if (device === undefined) return;
  const about = store.model.devices[device];
  if (about.input && !about.word && !menu && !store.model.live) {
    if (store.forced.has(device)) command({do: 'force', device, value: store.forced.get(device) ? 0 : 1});
    else command({do: 'toggle', device});
  } else {
    openMenu(place.what.d, place.node, goTo, place.what.i);
  }
}

function focus(node) {
  for (const each of pane.querySelectorAll('[tabindex="0"]')) each.setAttribute('tabindex', -1);
  node.setAttribute('tabindex', 0);
  node.focus({preventScroll: true});
}

function moveTo(rung, element) {
  const rungs = store.model.rungs;
  rung = Math.max(0, Math.min(rungs.length - 1, rung));
  cursor = {rung, element: Math.max(0, Math.min(rungs[rung].e.length - 1, element))};
  reveal(rung, cursor.element);
  draw();
  const node = shown.get(rung)?.elements[cursor.element]?.root;
  if (node) focus(node);
}

// The next element in a direction, by its place in the grid.
function neighbour(columns, rows) {
  const rung = store.model.rungs[cursor.rung];
  const here = rung.e[cursor.element];
  let best = -1, distance = Infinity;
  rung.e.forEach((each, i) => {
    const dx = (each.c - here.c) * (columns || 0), dy = (each.r - here.r) * (rows || 0);
    if (columns ? dx <= 0 : dy <= 0) return;
    const far = columns ? dx + 20 * Math.abs(each.r - here.r) : 20 * dy + Math.abs(each.c - here.c);
    if (far < distance) [best, distance] = [i, far];
  });
  return best;
}

function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
  if (steps) {
    const next = neighbour(...steps);
    if (next >= 0) moveTo(cursor.rung, next);
    else if (steps[1]) moveTo(cursor.rung + steps[1], steps[1] > 0 ? 0 : store.model.rungs[Math.max(0, cursor.rung - 1)].e.length - 1);
  } else if (event.key === 'Enter') {
    act(event, false);
  } else if (event.key === 'm' || event.key === 'M' || event.key === 'ContextMenu') {
    act(event, true);
  } else if (event.key === 'Home' || event.key === 'End') {
    moveTo(event.key === 'Home' ? 0 : store.model.rungs.length - 1, 0);
  } else if (event.key === 'PageDown' || event.key === 'PageUp') {
    const down = event.key === 'PageDown';
    moveTo(rungAt(tops[cursor.rung] + (down ? pane.clientHeight : -pane.clientHeight)), 0);
  } else {
    return;
  }
  event.preventDefault();
}

// Scrolls only if it is out of sight.
function reveal(rung, element = 0) {
  const what = store.model.rungs[rung];
  const top = tops[rung] + (what.e[element]?.r ?? 0) * ROW;
  if (top < pane.scrollTop || top + 2 * ROW > pane.scrollTop + pane.clientHeight) {
    pane.scrollTop = top - pane.clientHeight / 3;
  }
  const left = LEFT + (what.e[element]?.c ?? 0) * CELL;
  if (left < pane.scrollLeft || left + CELL > pane.scrollLeft + pane.clientWidth) {
    pane.scrollLeft = left - pane.clientWidth / 2;
  }
}

export function goTo(rung, device = -1) {
  document.getElementById('tab-ladder').click();
  marked = device;
  for (const drawing of shown.values()) for (const each of drawing.elements) each.flags = -1;
  const what = store.model.rungs[rung];
  const element = Math.max(0, what.e.findIndex((each) => each.d.includes(device)));
  moveTo(rung, element);
}

export function goToInstruction(instruction) {
  const rung = store.model.rungs.findIndex((each) => instruction >= each.first && instruction < each.first + each.list.length);
  if (rung < 0) return;
  document.getElementById('tab-ladder').click();
  moveTo(rung, Math.max(0, store.model.rungs[rung].e.findIndex((each) => each.i === instruction)));
}

export function focusLadder() {
  if (store.model.rungs.length) moveTo(cursor.rung, cursor.element);
}
