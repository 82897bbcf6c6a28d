// SPDX-License-Identifier: Apache-2.0
// The menu of a device: set, force, break, where it stands, timing diagram.
import {store, command} from './link.js';
import {html} from './svg.js';
import {addToTiming} from './timing.js';
import {showInstruction} from './inside.js';

let menu, back;

export function setUp(element) {
  menu = element;
  menu.addEventListener('toggle', (event) => {
    if (event.newState === 'closed' && back?.isConnected) back.focus({preventScroll: true});
  });
}

const close = () => menu.hidePopover();

// What a user types for a word: decimal, 0x or with a sign.
function number(text) {
  const value = Number(text.trim());
  return text.trim() !== '' && Number.isInteger(value) ? value : null;
}

function bitRow(device) {
  const button = (text, body) => html('button', {onclick: () => { command(body); close(); }}, text);
  return html('div', {class: 'row'},
    button('Set 1', {do: 'set', device, value: 1}), button('Set 0', {do: 'set', device, value: 0}),
    button('Force 1', {do: 'force', device, value: 1}), button('Force 0', {do: 'force', device, value: 0}));
}

function wordRow(device) {
  const field = html('input', {type: 'text', inputmode: 'numeric', value: store.values[device], size: 8, 'aria-label': 'value'});
  const send = (what) => {
    const value = number(field.value);
    if (value === null || value < -32768 || value > 65535) {
      field.setCustomValidity('-32768 to 65535, or 0x0 to 0xFFFF');
      field.reportValidity();
      return;
    }
    command({do: what, device, value});
    close();
  };
  field.addEventListener('input', () => field.setCustomValidity(''));
  field.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') send('set');
  });
  return html('div', {class: 'row'}, field, html('button', {onclick: () => send('set')}, 'Set'),
    html('button', {onclick: () => send('force')}, 'Force'));
}

function places(title, rungs, device, goTo) {
  if (rungs.length === 0) return '';
  const links = rungs.slice(0, 40).map((rung) => html('button', {class: 'link', onclick: () => { close(); goTo(rung, device); }}, rung + 1));
  return html('div', {class: 'places'}, html('span', {}, title), ...links, rungs.length > 40 ? ' …' : '');
}

function deviceBlock(device, goTo) {
  const about = store.model.devices[device];
  const forced = store.forced.has(device);
  const broken = store.breaks.has(device);
  const state = html('span', {class: 'state'}, `= ${store.values[device]}`);
  const rows = [
    html('h3', {}, about.name, ' ', state, about.comment ? html('small', {}, about.comment) : ''),
    about.word ? wordRow(device) : bitRow(device),
  ];
  const more = html('div', {class: 'row'});
  if (forced) more.append(html('button', {class: 'warn', onclick: () => { command({do: 'force', device, value: null}); close(); }}, 'Release force'));
  more.append(html('button', {onclick: () => { command({do: 'break', device, on: !broken}); close(); }}, broken ? 'No break' : 'Break on change'));
  more.append(html('button', {onclick: () => { addToTiming(device); close(); }}, 'To timing'));
  rows.push(more, places('written in rung', about.written, device, goTo), places('read in rung', about.read, device, goTo));
  return html('section', {}, ...rows);
}

// `instruction` is the element's, -1 if the menu is of a device alone.
export function openMenu(devices, anchor, goTo, instruction = -1) {
  back = document.activeElement;
  menu.replaceChildren(...[...new Set(devices)].slice(0, 6).map((device) => deviceBlock(device, goTo)));
  if (instruction >= 0 && store.model.engines.includes('inside')) {
    menu.append(html('button', {class: 'link', onclick: () => { close(); showInstruction(instruction); }}, 'Inside the processor'));
  }
  menu.showPopover();
  const at = anchor.getBoundingClientRect();
  const size = menu.getBoundingClientRect();
  const below = at.bottom + size.height + 8 < innerHeight;
  menu.style.left = `${Math.max(8, Math.min(at.left, innerWidth - size.width - 8))}px`;
  menu.style.top = `${below ? at.bottom + 4 : Math.max(8, at.top - size.height - 4)}px`;
  menu.querySelector('input, button')?.focus();
}
