// SPDX-License-Identifier: Apache-2.0
// Inside the processors: the last scan of MPU1, MPU2 and MPU3 side by side, clock by clock: the step
// in each stage, what each slot computes in EX, which operands were forwarded. Recorded by the server.
import {store, onDraw, drawSoon, command} from './link.js';
import {html, svg} from './svg.js';
import {goToInstruction} from './ladder.js';

const STAGES = ['IF1', 'IF2', 'IF3', 'ID1', 'ID2', 'ID3', 'EX'];
const WHAT = {
  IF1: 'the program counter addresses the instruction memory', IF2: 'the instruction memory answers',
  IF3: 'the step crosses to the slots', ID1: 'device numbers and LUT row go to the memories',
  ID2: 'the memories answer; forwarding from 3 and 4 steps before', ID3: 'banks merged; forwarding from 2 steps before',
  EX: 'look-up, sum, exc, write; forwarding from the step before',
};
let section, bar, panes, intro, slider, label;
let code = null;       // of run `codeRun`
let codeRun = 0, recordedScan = -1, recordedRun = 0, asking = false;
let clocks = [];       // by processor
let at = [];           // the clock that each shows
let wanted = null;     // an instruction to show once there is a recording
let dirty = true;

export function setUp(panel) {
  section = panel;
  intro = html('div', {class: 'intro'},
    html('p', {}, 'Runs the program on MPU1, MPU2 and MPU3 at once, each beside the reference, and records what is in every stage in every clock of the last scan.'),
    html('button', {id: 'record', onclick: () => command({do: 'restart', engine: 'inside'}).then((done) => done && command({do: 'step', scans: 1}))},
      'Record all three (the program restarts, inputs stay)'));
  slider = html('input', {type: 'range', min: 0, max: 1, value: 0, 'aria-label': 'clock', oninput: () => moveTo(Number(slider.value))});
  label = html('output', {});
  const button = (text, title, act) => html('button', {title, onclick: act}, text);
  bar = html('div', {class: 'bar'}, button('◀', 'a clock back (←)', () => move(-1)), button('▶', 'a clock on (→)', () => move(1)),
    slider, label, button('Next scan', 'single scan (space)', () => command({do: 'step', scans: 1})),
    html('span', {class: 'hint'}, 'click an instruction to see its rung'));
  panes = html('div', {class: 'processors'});
  section.append(intro, bar, panes);
  section.tabIndex = -1;
  section.addEventListener('keydown', (event) => {
    if (event.target === slider) return;
    const step = {ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10}[event.key];
    if (!step) return;
    event.preventDefault();
    move(step);
  });
  onDraw(draw);
}

export function load() {
  code = null;
  clocks = [];
  dirty = true;
}

export function shown(on) {
  if (on) section.focus();
}

// From a rung to the steps that it has become.
export function showInstruction(instruction) {
  wanted = instruction;
  document.getElementById('tab-inside').click();
  find();
}

function find() {
  if (wanted === null || !code || clocks.length === 0) return;
  const instruction = wanted;
  wanted = null;
  clocks.forEach((all, p) => {
    const found = all.findIndex(([steps]) => steps[6] >= 0 && code[p].code[steps[6]].some((slot) => slot[1] === instruction));
    if (found >= 0) at[p] = found;
  });
  slider.value = at.at(-1) ?? 0;
  dirty = true;
  drawSoon();
}

const longest = () => Math.max(1, ...clocks.map((all) => all.length));

function moveTo(clock) {
  at = clocks.map((all) => Math.max(0, Math.min(all.length - 1, clock)));
  slider.value = clock;
  dirty = true;
  drawSoon();
}

function move(by) {
  at = at.map((clock, p) => Math.max(0, Math.min(clocks[p].length - 1, clock + by)));
  slider.value = Math.max(...at);
  dirty = true;
  drawSoon();
}

async function ask() {
  const {frame} = store;
  if (asking || !frame || frame.engine !== 'inside') return;
  if (recordedRun === frame.run && recordedScan === frame.scan) return;
  asking = true;
  try {
    if (codeRun !== frame.run) {
      const answer = await (await fetch('api/code')).json();
      [code, codeRun] = [answer.processors, answer.run];
      clocks = [];
    }
    const answer = await (await fetch('api/recording')).json();
    if (answer.run === codeRun) {
      const begun = clocks.length === 0 || clocks.every((all) => all.length === 0);
      clocks = answer.clocks;
      [recordedRun, recordedScan] = [answer.run, answer.scan];
      slider.max = longest() - 1;
      if (begun) {
        at = clocks.map(() => 0);
        // The button that began this is gone, and the keys with it.
        if (!section.hidden && document.activeElement === document.body) section.focus();
      }
      find();
      dirty = true;
    }
  } catch { /* the line to the server says so */ }
  setTimeout(() => {
    asking = false;
    drawSoon();
  }, 150);
  drawSoon();
}

// ---- drawing ----------------------------------------------------------------------------------------------

function draw() {
  if (section.hidden) return;
  const inside = store.frame?.engine === 'inside';
  intro.hidden = inside;
  bar.hidden = panes.hidden = !inside;
  if (!inside) return;
  ask();
  if (!dirty || !code) return;
  dirty = false;
  label.textContent = `clock ${Number(slider.value) + 1} of ${longest()}`;
  const scrolled = section.scrollTop;
  panes.replaceChildren(...clocks.map((all, p) => processor(code[p], all, at[p] ?? 0)));
  section.scrollTop = scrolled;
}

function instruction(slot, step) {
  const [text, origin] = slot;
  if (text === 'NOP') return html('span', {class: 'nop'}, 'NOP');
  return html('button', {class: 'code', title: `step ${step}: to its rung`, disabled: origin < 0, onclick: () => goToInstruction(origin)}, text);
}

function processor({mpu, code: steps}, all, clock) {
  const now = all[clock];
  const slots = steps[0]?.length ?? 1;
  const root = html('section', {class: 'processor'},
    html('h2', {}, `MPU${mpu}`, html('small', {}, ` ${steps.length} steps; clock ${Math.min(clock + 1, all.length)} of ${all.length}${clock >= all.length - 1 ? ', done' : ''}`)));
  if (!now) return root;
  const table = html('table', {}, html('tr', {}, html('th', {}, ''), ...STAGES.map((name) => html('th', {title: WHAT[name], class: name === 'EX' ? 'ex' : ''}, name))));
  table.append(html('tr', {class: 'numbers'}, html('td', {}, 'step'), ...now[0].map((step) => html('td', {}, step < 0 ? '' : String(step)))));
  for (let s = 0; s < slots; s++) {
    const cells = now[0].map((step, stage) => html('td', {class: stage === 6 ? 'ex' : ''}, step < 0 || !steps[step] ? '' : instruction(steps[step][s], step)));
    table.append(html('tr', {}, html('td', {}, slots > 1 ? `slot ${s}` : 'slot'), ...cells));
  }
  root.append(html('div', {class: 'stages'}, table));
  for (let s = 0; s < slots; s++) root.append(execute(now, s, steps, mpu, slots));
  return root;
}

// The row of the LUT with the bit that the operands choose.
function lut(row, value, operands) {
  const picture = svg('svg', {width: 8 * 24 + 2, height: 44, class: 'lut', role: 'img', 'aria-label': `LUT row ${row}`});
  for (let i = 0; i < 8; i++) {
    const x = (7 - i) * 24 + 1;
    picture.append(svg('rect', {x, y: 1, width: 24, height: 24, class: i === operands ? 'chosen' : ''}),
      svg('text', {x: x + 12, y: 17, class: 'bit'}, String(value >> i & 1)),
      svg('text', {x: x + 12, y: 38, class: 'index'}, i.toString(2).padStart(3, '0')));
  }
  return picture;
}

function execute(now, s, steps, mpu, slots) {
  const step = now[0][6];
  const slot = now[1][s];
  const root = html('div', {class: 'execute'}, html('b', {}, slots > 1 ? `EX, slot ${s}` : 'EX'));
  if (step < 0 || !slot) {
    root.append(html('span', {class: 'nop'}, step < 0 ? 'nothing yet, or no more' : 'waits, or nothing'));
    return root;
  }
  const [before, after, value, operands, s1, s2, forwarded, written, result] = slot;
  const row = steps[step][s][2];
  if (row >= 0) {
    const bits = operands.toString(2).padStart(3, '0');
    root.append(html('span', {}, `LUT row ${row}, a b c = ${[...bits].join(' ')}`), lut(row, value, operands));
  } else if (mpu === 1 && /^(LD|LDI|AND|ANI|OR|ORI) /.test(steps[step][s][0])) {
    root.append(html('span', {}, `device = ${operands & 1}`));
  }
  if (/^(MV|ADD|ADC|SUB|SBC|W|EQ|LT|MUL|DIV|MIN|ROL)/.test(steps[step][s][0])) root.append(html('span', {}, `s1 = ${s1}, s2 = ${s2}`));
  root.append(html('span', {}, `exc ${before} → ${after}`));
  for (let i = 0; i < forwarded.length; i += 2) {
    const name = {1: 's1', 2: 's2'}[forwarded[i]] ?? (mpu === 1 ? 'device' : forwarded[i]);
    root.append(html('span', {class: 'forward', title: 'the memory does not have it yet'}, `${name} forwarded from ${forwarded[i + 1]} step${forwarded[i + 1] === '1' ? '' : 's'} before`));
  }
  if (written !== undefined) root.append(html('span', {class: 'write'}, `${written} := ${result}`));
  return root;
}
