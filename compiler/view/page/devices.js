// SPDX-License-Identifier: Apache-2.0
// The list of all devices with their values, and the list of what is forced. Only the rows in sight
// are in the document.
import {store, onDraw, drawSoon, command} from './link.js';
import {html} from './svg.js';
import {openMenu} from './menu.js';
import {goTo} from './ladder.js';

const ROW = 26;
let list, filter, forcedBox, paper;
let found = [];
let cursor = 0;
let forcedText = '';
let filterText = null;

export function setUp() {
  list = document.getElementById('devices');
  filter = document.getElementById('filter');
  forcedBox = document.getElementById('forced');
  paper = html('div', {class: 'paper'});
  list.append(paper);
  filter.addEventListener('input', search);
  filter.addEventListener('keydown', (event) => {
    if (event.key === 'ArrowDown') list.focus();
    if (event.key === 'Escape') {
      filter.value = '';
      search();
    }
  });
  list.addEventListener('scroll', drawSoon);
  new ResizeObserver(drawSoon).observe(list);
  list.addEventListener('click', (event) => act(event.target.closest('.device'), event.shiftKey));
  list.addEventListener('contextmenu', (event) => {
    event.preventDefault();
    act(event.target.closest('.device'), true);
  });
  list.addEventListener('keydown', onKey);
  onDraw(draw);
}

export function load() {
  filterText = null;
  search();
}

// A filter of words, all of which must fit: part of a name or comment, on, off, forced, break, input.
function fits(device, i, words) {
  return words.every((word) => {
    if (word === 'on') return store.values[i] !== 0;
    if (word === 'off') return store.values[i] === 0;
    if (word === 'forced') return store.forced.has(i);
    if (word === 'break') return store.breaks.has(i);
    if (word === 'input') return device.input;
    return device.name.toLowerCase().includes(word) || device.comment.toLowerCase().includes(word);
  });
}

function search() {
  const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
  const live = words.some((word) => ['on', 'off', 'forced', 'break'].includes(word));
  filterText = live ? words : null;
  found = [];
  store.model.devices.forEach((device, i) => {
    if (fits(device, i, words)) found.push(i);
  });
  cursor = Math.min(cursor, Math.max(0, found.length - 1));
  drawSoon();
}

function act(row, menu) {
  if (!row) return;
  const device = Number(row.dataset.device);
  cursor = found.indexOf(device);
  drawSoon();
  const about = store.model.devices[device];
  if (about.input && !about.word && !menu && !store.model.live && !store.forced.has(device)) command({do: 'toggle', device});
  else openMenu([device], row, goTo);
}

function onKey(event) {
  const step = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10}[event.key];
  if (step) {
    cursor = Math.max(0, Math.min(found.length - 1, cursor + step));
    const top = cursor * ROW;
    if (top < list.scrollTop) list.scrollTop = top;
    if (top + ROW > list.scrollTop + list.clientHeight) list.scrollTop = top + ROW - list.clientHeight;
    draw();
  } else if (event.key === 'Enter' || event.key === 'm') {
    act(paper.querySelector('[aria-selected="true"]'), event.key === 'm');
  } else {
    return;
  }
  event.preventDefault();
}

const rows = new Map();

function makeRow(device) {
  const about = store.model.devices[device];
  const value = html('span', {class: 'v'});
  const root = html('div', {class: 'device', role: 'option', id: `device-${device}`}, html('span', {class: 'n'}, about.name),
    html('span', {class: 'c', title: about.comment}, about.comment), value);
  root.dataset.device = device;
  return {root, value, key: ''};
}

function draw() {
  if (!store.model) return;
  if (filterText) {
    const now = store.model.devices.map((_, i) => i).filter((i) => fits(store.model.devices[i], i, filterText));
    if (now.length !== found.length || now.some((device, i) => device !== found[i])) found = now;
  }
  paper.style.height = `${found.length * ROW}px`;
  const first = Math.max(0, Math.floor(list.scrollTop / ROW) - 2);
  const last = Math.min(found.length, Math.ceil((list.scrollTop + list.clientHeight) / ROW) + 2);
  const wanted = new Set(found.slice(first, last));
  for (const [device, row] of rows) {
    if (wanted.has(device) && row.model === store.model) continue;
    row.root.remove();
    rows.delete(device);
  }
  for (let i = first; i < last; i++) {
    const device = found[i];
    let row = rows.get(device);
    if (!row) {
      row = {...makeRow(device), model: store.model};
      rows.set(device, row);
      paper.append(row.root);
    }
    const value = store.values[device];
    const key = [i, value, store.forced.has(device), store.breaks.has(device), i === cursor].join();
    if (key === row.key) continue;
    row.key = key;
    row.root.style.top = `${i * ROW}px`;
    const about = store.model.devices[device];
    row.value.textContent = about.word ? value : value ? '1' : '0';
    row.root.className = `device${value ? ' set' : ''}${about.input ? ' input' : ''}${store.forced.has(device) ? ' forced' : ''}${store.breaks.has(device) ? ' break' : ''}`;
    row.root.setAttribute('aria-selected', i === cursor);
    if (i === cursor) list.setAttribute('aria-activedescendant', row.root.id);
  }
  drawForced();
}

function drawForced() {
  const text = JSON.stringify([...store.forced, ...store.breaks.keys()]);
  if (text === forcedText) return;
  forcedText = text;
  forcedBox.hidden = store.forced.size === 0 && store.breaks.size === 0;
  const name = (device) => store.model.devices[device].name;
  const chips = [...store.forced].map(([device, value]) => html('button', {
    class: 'chip forced', title: 'release', onclick: () => command({do: 'force', device, value: null}),
  }, `${name(device)} = ${value} ✕`));
  const stops = [...store.breaks].map(([device, value]) => html('button', {
    class: 'chip break', title: 'no break', onclick: () => command({do: 'break', device, on: false}),
  }, `${name(device)}${value === null ? '' : ` = ${value}`} ✕`));
  forcedBox.replaceChildren();
  if (chips.length) {
    forcedBox.append(html('div', {}, html('b', {}, 'Forced '), ...chips,
      html('button', {class: 'link', id: 'release-all', onclick: () => command({do: 'release'})}, 'release all')));
  }
  if (stops.length) forcedBox.append(html('div', {}, html('b', {}, 'Breakpoints '), ...stops));
}
