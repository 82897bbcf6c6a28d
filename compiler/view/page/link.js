// SPDX-License-Identifier: Apache-2.0
// The line to the program that serves this page: the model once, then what changes. Everything that
// shows something subscribes here; one drawing a frame of the screen, however many changes came.

export const store = {
  model: null,
  values: [],
  power: new Uint8Array(0),   // bits, by net
  closed: new Uint8Array(0),  // bits, by instruction
  forced: new Map(),
  breaks: new Map(),
  frame: null,                // the last one
  connected: false,
  drawn: 0,                   // frames of the screen in which something was drawn
};

export const bit = (bits, i) => (bits[i >> 3] >> (i & 7)) & 1;

const drawers = new Set();
let wanted = false;

export function onDraw(draw) {
  drawers.add(draw);
}

export function drawSoon() {
  if (wanted) return;
  wanted = true;
  requestAnimationFrame(() => {
    wanted = false;
    store.drawn++;
    for (const draw of drawers) draw();
  });
}

function unpacked(text) {
  const bytes = atob(text);
  const bits = new Uint8Array(bytes.length);
  for (let i = 0; i < bytes.length; i++) bits[i] = bytes.charCodeAt(i);
  return bits;
}

function take(frame) {
  for (let i = 0; i < frame.values.length; i += 2) store.values[frame.values[i]] = frame.values[i + 1];
  store.power = unpacked(frame.power);
  store.closed = unpacked(frame.closed);
  store.forced = new Map(frame.forced);
  store.breaks = new Map(frame.breaks);
  store.frame = frame;
  drawSoon();
}

// Loads the model and follows the run; `onModel` is called whenever there is a new model, also after
// the server has been away.
export async function connect(onModel) {
  for (;;) {
    try {
      const answer = await fetch('api/program');
      if (!answer.ok) throw new Error((await answer.json()).error);
      const model = await answer.json();
      store.model = model;
      store.values = new Array(model.devices.length).fill(0);
      onModel(model);
      await follow();
    } catch (error) {
      store.problem = String(error.message ?? error);
    }
    store.connected = false;
    drawSoon();
    await new Promise((again) => setTimeout(again, 500));
  }
}

// Until the stream breaks.
function follow() {
  return new Promise((broken) => {
    const events = new EventSource('api/events');
    events.onmessage = (event) => {
      store.connected = true;
      take(JSON.parse(event.data));
    };
    events.onerror = () => {
      events.close();
      broken();
    };
  });
}

let toasts = () => {};
export function onProblem(show) {
  toasts = show;
}

export async function command(body) {
  try {
    const answer = await fetch('api/command', {
      method: 'POST',
      headers: {'Content-Type': 'application/json'},
      body: JSON.stringify(body),
    });
    if (!answer.ok) toasts((await answer.json()).error);
    return answer.ok;
  } catch {
    toasts('The server does not answer.');
    return false;
  }
}
