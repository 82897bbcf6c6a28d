// SPDX-License-Identifier: Apache-2.0
// The frame around everything: tool bar, tabs, keys, what is said to the user.
import {store, connect, command, onDraw, onProblem} from './link.js';
import {html} from './svg.js';
import * as ladder from './ladder.js';
import * as devices from './devices.js';
import * as timing from './timing.js';
import * as flow from './flow.js';
import * as inside from './inside.js';
import * as menu from './menu.js';

const $ = (id) => document.getElementById(id);

// ---- tool bar -------------------------------------------------------------------------------------------

const mode = (name) => command({do: 'mode', mode: name});
const step = () => command({do: 'step', scans: 1});
const restart = () => command({do: 'restart', engine: store.frame?.engine ?? store.model.engines[0]});

$('step').onclick = step;
$('real').onclick = () => mode('real');
$('fast').onclick = () => mode('fast');
$('pause').onclick = () => mode('paused');
$('restart').onclick = restart;
$('engine').onchange = () => command({do: 'restart', engine: $('engine').value});
$('help-button').onclick = () => $('help').showModal();
for (const button of document.querySelectorAll('[data-order]')) {
  button.onclick = () => command({do: 'order', order: button.dataset.order});
}

const NAMES = {reference: 'the reference', mpu1: 'MPU1', mpu2: 'MPU2', mpu3: 'MPU3', inside: 'all three, recorded', controller: 'a controller'};

function drawBar() {
  const {frame, model} = store;
  $('message').hidden = store.connected && !frame?.message;
  if (!store.connected && model) {
    $('message').textContent = 'The server does not answer. This page goes on by itself when it is back.';
    $('message').className = 'bad';
  } else if (!store.connected) {
    $('message').textContent = store.problem ?? 'connecting ...';
    $('message').className = 'bad';
  } else if (frame?.message) {
    $('message').textContent = frame.message;
    $('message').className = frame.failed ? 'bad' : 'good';
  }
  if (!frame) return;
  for (const name of ['real', 'fast']) $(name).setAttribute('aria-pressed', frame.mode === name);
  $('pause').setAttribute('aria-pressed', frame.mode === 'paused');
  $('sent').hidden = !frame.sent;
  if ($('sent').textContent !== frame.sent) {
    $('sent').textContent = frame.sent;
    $('sent').scrollTop = $('sent').scrollHeight;
  }
  if ($('engine').value !== frame.engine) $('engine').value = frame.engine;
  const ms = frame.scan * model.tick_us / 1000;
  const time = model.live ? frame.state : `scan ${frame.scan}, ${(ms / 1000).toFixed(2)} s`;
  $('status').textContent = frame.clocks ? `${time}, ${frame.clocks} clocks a scan` : time;
}

// ---- tabs -----------------------------------------------------------------------------------------------

const tabs = [...document.querySelectorAll('[role="tab"]')];

function show(tab) {
  for (const each of tabs) {
    const on = each === tab;
    each.setAttribute('aria-selected', on);
    each.tabIndex = on ? 0 : -1;
    $(each.getAttribute('aria-controls')).hidden = !on;
  }
  inside.shown(!$('inside').hidden);
  import('./link.js').then((link) => link.drawSoon());
}
tabs.forEach((tab, i) => {
  tab.onclick = () => show(tab);
  tab.onkeydown = (event) => {
    const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (!step) return;
    const seen = tabs.filter((each) => !each.hidden);
    const next = seen[(seen.indexOf(tab) + step + seen.length) % seen.length];
    next.focus();
    show(next);
  };
});

// ---- search: where a device is written, then where it is read --------------------------------------------------

let lastFound = '', foundAt = 0;
function search() {
  const text = $('search').value.trim().toLowerCase();
  if (!text) return;
  const all = store.model.devices;
  const name = text.split('  ')[0];
  let device = all.findIndex((each) => each.name.toLowerCase() === name);
  if (device < 0) device = all.findIndex((each) => each.comment.toLowerCase() === text);
  if (device < 0) device = all.findIndex((each) => `${each.name} ${each.comment}`.toLowerCase().includes(text));
  if (device < 0) return toast(`No device and no comment has "${text}" in it.`);
  const places = [...new Set([...all[device].written, ...all[device].read])];
  if (places.length === 0) return toast(`${all[device].name} stands in no rung.`);
  foundAt = text === lastFound ? (foundAt + 1) % places.length : 0;
  lastFound = text;
  ladder.goTo(places[foundAt], device);
  const written = all[device].written.includes(places[foundAt]) ? 'writes' : 'reads';
  toast(`${all[device].name}: rung ${places[foundAt] + 1} ${written} it (${foundAt + 1} of ${places.length})`);
  $('search').focus();
}
$('search').addEventListener('keydown', (event) => {
  if (event.key === 'Enter') search();
  if (event.key === 'Escape') ladder.focusLadder();
});

// ---- keys ------------------------------------------------------------------------------------------------

const KEYS = {
  ' ': step, r: () => mode('real'), f: () => mode('fast'), p: () => mode('paused'), 0: restart,
  '/': () => $('search').focus(), '?': () => $('help').showModal(),
  1: () => show($('tab-ladder')), 2: () => !$('tab-flow').hidden && show($('tab-flow')),
  3: () => show($('tab-timing')), 4: () => show($('tab-inside')),
};
document.addEventListener('keydown', (event) => {
  if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
  if (event.target.closest('input, select, dialog, [popover]')) return;
  if (event.key === ' ' && event.target.closest('button, a')) return;
  const act = KEYS[event.key.toLowerCase()];
  if (!act) return;
  event.preventDefault();
  act();
});

// ---- what is said -------------------------------------------------------------------------------------------

let toasting;
function toast(text) {
  document.querySelector('.toast')?.remove();
  const box = html('div', {class: 'toast', role: 'status'}, text);
  document.body.append(box);
  clearTimeout(toasting);
  toasting = setTimeout(() => box.remove(), 4000);
}
onProblem(toast);

let loaded = '';
function load(model) {
  const name = model.file.split('/').at(-1);
  $('file').textContent = name;
  $('file').title = model.file;
  document.title = `${name} · Rung`;
  $('engine').replaceChildren(...model.engines.map((each) => html('option', {value: each}, NAMES[each] ?? each)));
  $('engine').disabled = model.engines.length < 2;
  $('names').replaceChildren(...model.devices.map((each) => html('option', {value: each.name}, each.comment)));
  for (const id of ['step', 'fast', 'restart']) $(id).hidden = model.live;
  $('orders').hidden = !model.live;
  $('tab-inside').hidden = !model.engines.includes('inside');
  ladder.load(model);
  devices.load(model);
  timing.load(model);
  flow.load(model);
  inside.load(model);
  if (model.tasks.length && loaded !== model.file) show($('tab-flow'));
  loaded = model.file;
}

menu.setUp($('menu'));
ladder.setUp($('ladder'));
devices.setUp();
timing.setUp($('timing'));
flow.setUp($('flow'));
inside.setUp($('inside'));
onDraw(drawBar);
globalThis.rung = store;  // for those who look with the browser's tools
connect(load);
