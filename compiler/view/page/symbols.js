// SPDX-License-Identifier: Apache-2.0
// The sign of each kind of element, in a box of `w` by 24 around (0, 0), with its wires.
import {svg, cut} from './svg.js';

const line = (x1, y1, x2, y2, name) => svg('line', {x1, y1, x2, y2, class: name});
const letter = (text) => svg('text', {x: 0, y: 4, class: 'letter'}, text);

function contact(mark) {
  return [
    svg('rect', {x: -9, y: -12, width: 18, height: 24, class: 'gap'}),
    line(-9, -12, -9, 12, 'sign'),
    line(9, -12, 9, 12, 'sign'),
    ...mark,
  ];
}

function coil(text) {
  return [
    svg('rect', {x: -12, y: -12, width: 24, height: 24, rx: 12, class: 'gap'}),
    svg('path', {d: 'M-7 -12 Q-17 0 -7 12 M7 -12 Q17 0 7 12', class: 'sign'}),
    ...(text ? [letter(text)] : []),
  ];
}

function box(element, width) {
  const half = width / 2 - 8;
  const words = svg('text', {x: 0, y: 4, class: 'words'}, cut(element.t, Math.floor(half / 3.6)));
  return [svg('rect', {x: -half, y: -13, width: 2 * half, height: 26, rx: 3, class: 'gap box'}), words];
}

const SIGNS = {
  'contact': () => [9, contact([])],
  'contact-not': () => [9, contact([line(-6, 10, 6, -10, 'sign')])],
  'contact-up': () => [9, contact([svg('path', {d: 'M0 9V-8M-4 -3L0 -9L4 -3', class: 'sign'})])],
  'contact-down': () => [9, contact([svg('path', {d: 'M0 -9V8M-4 3L0 9L4 3', class: 'sign'})])],
  'invert': () => [0, [line(-6, 10, 6, -10, 'sign')]],
  'edge-up': () => [0, [svg('path', {d: 'M0 10V-9M-5 -3L0 -10L5 -3', class: 'sign'})]],
  'edge-down': () => [0, [svg('path', {d: 'M0 -10V9M-5 3L0 10L5 3', class: 'sign'})]],
  'coil': () => [12, coil('')],
  'coil-not': () => [12, coil('/')],
  'coil-set': () => [12, coil('S')],
  'coil-reset': () => [12, coil('R')],
  'coil-up': () => [12, coil('↑')],
  'coil-down': () => [12, coil('↓')],
  'coil-toggle': () => [12, coil('~')],
  'short': () => [0, []],
  'open': () => [14, [svg('circle', {cx: -11, cy: 0, r: 2, class: 'sign'}), svg('circle', {cx: 11, cy: 0, r: 2, class: 'sign'})]],
};

// The half of the width that the sign takes of its wire, and its shapes.
export function signOf(element, width) {
  const make = SIGNS[element.s];
  return make ? make() : [width / 2 - 8, box(element, width)];
}

export const isBoxed = (element) => !(element.s in SIGNS);
