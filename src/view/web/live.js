// The live scene: shows what the server tells, tells the server what is pressed and pulled. Nothing is simulated here.
import './view.css';
import {Crowd, Quaternion, Stage, Vector3} from './stage.js';
import {short, TimePlot} from './plots.js';
import {Plane} from 'three';

const $ = id => document.getElementById(id);
let socket, scene, status, stage, crowd, scale = 1;
let p = new Float32Array(), q = new Float32Array();
const say = message => { if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message)); };

// Scene ---------------------------------------------------------------------------------------------------------------
function set_scene(told) {
  const bodies = told.bodies, at = bodies.map(b => new Vector3(...b.position));
  scene = told;
  const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate(), sizes = bodies.map(b => Math.hypot(...b.size)).sort((a, b) => a - b);
  at.forEach(v => { low.min(v), high.max(v); });
  if (!bodies.length) low.set(0, 0, 0), high.set(0, 0, 0);
  const typical = sizes[bodies.length >> 1] || 1, reach = Math.max(high.distanceTo(low) / 2, 2 * (sizes.at(-1) || 1));
  if (!$('method').length) for (const name of scene.methods) $('method').add(new Option(name, name));
  past.forEach(values => { values.length = 0; });
  hand = undefined;
  try {
    scale = typical * 0.6;
    stage ??= listen(new Stage($('canvas'), scene.planes, low.add(high).multiplyScalar(0.5), reach));
    crowd?.leave();
    crowd = new Crowd(stage, bodies, 0, scale);
  } catch (error) {
    $('failed').hidden = false;
    $('failed').textContent = 'The scene cannot be drawn: ' + error.message + '. Switches and numbers work; the picture needs WebGL.';
  }
}
function set_frame(buffer) {
  const n = scene?.bodies.length ?? 0, touches = buffer.byteLength < 16 ? NaN : new Float64Array(buffer, 0, 2)[1];
  if (buffer.byteLength !== 16 + 4 * (7 * n + 6 * touches)) return;
  const values = new Float32Array(buffer, 16);
  p = values.subarray(0, 3 * n), q = values.subarray(3 * n, 7 * n);
  recent.push({until: performance.now() + 150, j: values.subarray(7 * n)});
  draw();
}
// Impulses are shown for a while, or nobody would see them.
let recent = [], asked = false;
const from = new Vector3(), v = new Vector3();
function draw() {
  if (asked || !crowd) return;
  asked = true;
  requestAnimationFrame(() => {
    asked = false;
    const now = performance.now();
    recent = recent.filter(r => r.until > now);
    crowd.place(p, q, $('axes').checked);
    crowd.impulses.clear();
    if ($('contacts').checked)
      for (const {j} of recent)
        for (let k = 0; k < j.length; k += 6) crowd.impulses.add(from.fromArray(j, k), v.fromArray(j, k + 3), Math.min(3, 0.6 * Math.sqrt(v.length())) * scale);
    crowd.trace(hand ? [...grip_W().toArray(), ...hand.to.toArray()] : []);
    stage.world.visible = $('world').checked;
    stage.draw();
    if (recent.length && !status?.running) draw();
  });
}

// The hand: a spring from where a cuboid was grasped to the pointer, in the plane that faces the camera ------------------
let hand;
const turn = i => new Quaternion(q[4 * i + 1], q[4 * i + 2], q[4 * i + 3], q[4 * i]).normalize();
const grip_W = () => hand.at.clone().applyQuaternion(turn(hand.body)).add(v.fromArray(p, 3 * hand.body));
function listen(made) {
  const canvas = $('canvas');
  canvas.addEventListener('pointerdown', event => {
    const hit = event.button === 0 && made.pick(event, [crowd]);
    if (!hit) return;
    const at = hit.point.clone().sub(new Vector3().fromArray(p, 3 * hit.body)).applyQuaternion(turn(hit.body).invert());
    hand = {body: hit.body, at, to: hit.point.clone(), plane: new Plane().setFromNormalAndCoplanarPoint(made.camera.getWorldDirection(new Vector3()), hit.point)};
    made.controls.enabled = false;
    canvas.setPointerCapture(event.pointerId);
    say({do: 'hold', body: hand.body, at: at.toArray(), to: hand.to.toArray()});
    event.stopImmediatePropagation();  // the camera stays
  }, true);
  canvas.addEventListener('pointermove', event => {
    if (!hand || !made.ray(event).ray.intersectPlane(hand.plane, hand.to) || hand.told) return;
    hand.told = true;  // once in a frame
    requestAnimationFrame(() => {
      if (!hand) return;
      hand.told = false;
      say({do: 'move', to: hand.to.toArray()});
      draw();
    });
  });
  for (const name of ['pointerup', 'pointercancel'])
    canvas.addEventListener(name, () => {
      if (hand) say({do: 'release'});
      hand = undefined;
      made.controls.enabled = true;
      draw();
    });
  made.controls.addEventListener('change', () => made.renderer.render(made.scene, made.camera));
  return made;
}

// Numbers ---------------------------------------------------------------------------------------------------------------
const window_s = 20;  // of the plot
const plot = new TimePlot($('energy'), [{name: 'energy', color: '--s0', dash: 0}, {name: 'but for the steps’ own', color: '--s1', dash: 1}], undefined, window_s);
const past = [[], [], []];
plot.line.remove();  // what is shown is always now
const percent = (a, b) => b ? (100 * a / b).toFixed(1) + ' %' : 'none';
const rows = {
  'energy, J': s => short(s.energy.now),
  'work of hand, vacuum and forces, J': s => short(s.energy.work),
  'lost in impacts: restitution, J': s => short(s.energy.restitution_loss),
  'lost in impacts: friction, J': s => short(s.energy.friction_loss),
  'given by pushing apart, J': s => short(s.energy.correction),
  'gravity switched, J': s => short(s.energy.switched),
  'given by the steps themselves, J': s => short(s.energy.stepper),
  'unexplained at worst, J': s => short(s.energy.worst_drift),
  'linear momentum, N s': s => short(s.momentum.linear),
  'unexplained at worst, N s': s => short(s.momentum.linear_drift),
  'angular momentum, kg m²/s': s => short(s.momentum.angular),
  'given by the steps themselves, kg m²/s': s => short(s.momentum.angular_stepper),
  'unexplained at worst, kg m²/s': s => short(s.momentum.angular_drift),
  'impacts on planes': s => s.impacts.planes,
  'impacts of pairs': s => s.impacts.pairs,
  'impacts that gained energy': s => s.impacts.energy_rises,
  'deepest overlap, m': s => short(s.deepest_penetration),
  'skipped pairs, far apart': s => percent(s.skips.pairs, s.skips.pairs_of),
  'skipped planes, out of reach': s => percent(s.skips.planes, s.skips.planes_of),
};
const cells = Object.keys(rows).map(name => {
  const row = $('accounts').tBodies[0].insertRow(), head = row.appendChild(document.createElement('th'));
  head.scope = 'row', head.textContent = name;
  return row.insertCell();
});

// dt on a logarithmic bar: 100 steps from the shortest to the longest
const dt_at = k => scene.dt.from * (scene.dt.to / scene.dt.from) ** (k / 100), bar_at = dt => 100 * Math.log(dt / scene.dt.from) / Math.log(scene.dt.to / scene.dt.from);
const surface = ['restitution', 'static_friction', 'dynamic_friction'];
function put(id, value, text) {
  if (document.activeElement !== $(id) || $(id).type !== 'range') $(id).value = value;
  const shown = $(id).nextElementSibling;
  if (shown.textContent !== text) shown.textContent = text, $(id).setAttribute('aria-valuetext', text);
}
function set_status(told) {
  status = told;
  for (const id of ['running', 'vacuum', 'gravity']) $(id).setAttribute('aria-pressed', told[id]);
  for (const id of surface) put(id, told.surface[id], String(+told.surface[id].toFixed(3)));
  put('dt', bar_at(told.dt), `1/${+(1 / told.dt).toPrecision(3)} s`);
  $('method').value = told.method;
  $('time').textContent = `${told.t.toFixed(2)} s, seed ${told.seed}`;
  $('pace').textContent = told.running && told.pace < 0.9 ? `${Math.round(100 * told.pace)} % of real time` : '';
  if (!told.finite) tell('A number stopped being finite: the step is too long for this. n begins anew.');
  Object.values(rows).forEach((text, i) => { cells[i].textContent = text(told); });
  const e = told.energy, times = past[0];
  if (times.length && told.t <= times.at(-1)) return;
  [told.t, e.now, e.start + e.work + e.correction + e.switched - e.restitution_loss - e.friction_loss].forEach((x, i) => past[i].push(x));
  while (times[0] < told.t - window_s) past.forEach(values => values.shift());
  plot.set(times, past.slice(1));
}

// Talking ---------------------------------------------------------------------------------------------------------------
let silence;
function tell(text, ms = 5000) {
  $('told').textContent = text;
  clearTimeout(silence);
  if (ms) silence = setTimeout(() => { $('told').textContent = ''; }, ms);
}
function connect() {
  socket = new WebSocket(`ws://${location.host}/socket`);
  socket.binaryType = 'arraybuffer';
  socket.onopen = () => tell('');
  socket.onmessage = ({data}) => {
    if (typeof data !== 'string') return set_frame(data);
    const told = JSON.parse(data);
    if (told.kind === 'scene') set_scene(told);
    else if (told.kind === 'status') set_status(told);
    else tell(told.text);
  };
  socket.onclose = () => {
    tell('rigor does not answer: it was stopped, or eight look already. Trying again.', 0);
    setTimeout(connect, 2000);
  };
}
const toggle = what => say({do: 'toggle', what});
for (const what of ['running', 'vacuum', 'gravity']) $(what).onclick = () => toggle(what);
$('new').onclick = () => say({do: 'new'});
for (const id of surface) $(id).oninput = event => say({do: 'set', what: id, value: +event.target.value});
$('dt').oninput = event => say({do: 'set', what: 'dt', value: dt_at(+event.target.value)});
$('method').onchange = event => say({do: 'method', value: event.target.value});
for (const id of ['contacts', 'axes', 'world']) $(id).onchange = draw;
const keys = {' ': () => toggle('running'), r: () => toggle('vacuum'), g: () => toggle('gravity'), n: () => say({do: 'new'})};
addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.repeat || !keys[event.key]) return;
  const on = event.target;
  if (on.tagName === 'SELECT' || event.key === ' ' && (on.tagName === 'BUTTON' || on.type === 'checkbox')) return;
  event.preventDefault();
  keys[event.key]();
});
connect();
