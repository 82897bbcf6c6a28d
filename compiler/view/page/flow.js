// SPDX-License-Identifier: Apache-2.0
// The tasks of a flow program as flowcharts, the step that each is at marked.
import {store, onDraw} from './link.js';
import {svg, html, cut} from './svg.js';

const WIDTH = 300, LINE = 17, HEAD = 24, GAP = 26, LANE = 14;
let section;
let charts = [];  // by task: heading and boxes

export function setUp(panel) {
  section = panel;
  onDraw(draw);
}

export function load(model) {
  document.getElementById('tab-flow').hidden = model.tasks.length === 0;
  charts = model.tasks.map(chart);
  section.replaceChildren(...charts.map((each) => each.root));
}

const heightOf = (step) => HEAD + step.lines.length * LINE + 8;

function chart(task) {
  const heading = html('h2', {}, task.name, ' ', html('small', {}));
  const tops = [];
  let y = 6;
  for (const step of task.steps) {
    tops.push(y);
    y += heightOf(step) + GAP;
  }
  const index = new Map(task.steps.map((step, i) => [step.number, i]));
  const arrows = [];
  let lanes = 0;
  task.steps.forEach((step, i) => {
    for (const next of step.next) {
      const to = index.get(next);
      if (to === undefined) continue;
      if (to === i + 1) {
        arrows.push(svg('path', {d: `M${WIDTH / 2} ${tops[i] + heightOf(step)}V${tops[to] - 2}`, class: 'arrow'}));
      } else {
        const x = WIDTH + 8 + LANE * (lanes++ % 8);
        arrows.push(svg('path', {d: `M${WIDTH} ${tops[i] + heightOf(step) - 12}H${x}V${tops[to] + 12}H${WIDTH + 2}`, class: 'arrow'}));
      }
    }
  });
  const boxes = task.steps.map((step, i) => {
    const box = svg('g', {class: 'step', transform: `translate(0 ${tops[i]})`},
      svg('rect', {x: 1, y: 0, width: WIDTH - 1, height: heightOf(step), rx: step.added ? 14 : 5}),
      svg('text', {x: 10, y: 17, class: 'name'}, step.added ? `${step.name}, after its wait` : step.name));
    step.lines.forEach((line, k) => box.append(svg('text', {x: 18, y: HEAD + 12 + k * LINE, class: 'code'}, cut(line, 40), svg('title', {}, line))));
    return box;
  });
  const picture = svg('svg', {width: WIDTH + 8 + LANE * 8, height: y, role: 'img', 'aria-label': `task ${task.name}`},
    svg('defs', {}, svg('marker', {id: `tip-${task.name}`, viewBox: '0 0 8 8', refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: 'auto'},
      svg('path', {d: 'M0 0L8 4L0 8z', class: 'tip'}))), ...arrows, ...boxes);
  for (const arrow of arrows) arrow.setAttribute('marker-end', `url(#tip-${task.name})`);
  return {root: html('div', {class: 'task'}, heading, picture), heading, boxes, index, key: ''};
}

const SAYS = {fetch: 'ready', load: 'reads', store: 'writes', pause: 'paused'};

function draw() {
  if (section.hidden || !store.frame?.tasks) return;
  store.frame.tasks.forEach((state, i) => {
    const each = charts[i];
    const key = JSON.stringify(state);
    if (each.key === key) return;
    each.key = key;
    const says = !state.on ? 'not running' : state.waits ? `${SAYS[state.state]}, waits for its data` : SAYS[state.state];
    each.heading.querySelector('small').textContent = says;
    const active = state.on ? each.index.get(state.step) : -1;
    each.boxes.forEach((box, k) => box.classList.toggle('active', k === active));
  });
}
