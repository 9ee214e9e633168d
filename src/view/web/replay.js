// The replay page: unpacks the runs that lie in the page and shows the moment asked for.
import './view.css';
import {Crowd, ghost_color, Quaternion, Stage, Vector3} from './stage.js';
import {TimePlot} from './plots.js';

const $ = id => document.getElementById(id);

function bytes(text) {
  const raw = atob(text), out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) out[i] = raw.charCodeAt(i);
  return out.buffer;
}
const f32 = text => new Float32Array(bytes(text));
function steps({largest, steps}) {
  return Float32Array.from(new Int16Array(bytes(steps)), k => k * largest / 32767);
}
function unpack(run) {
  const turns = Float32Array.from(new Int16Array(bytes(run.q)), k => k / 32767);
  const energy = {kinetic: f32(run.energy.kinetic), potential: f32(run.energy.potential)};
  return {...run, t: new Float64Array(bytes(run.t)), p: f32(run.p), q: turns, v: steps(run.v), w: steps(run.w),
          touches: {end: new Uint32Array(bytes(run.touches.end)), sides: new Int16Array(bytes(run.touches.sides)), p: steps(run.touches.p), j: steps(run.touches.j)},
          energy: {...energy, total: energy.kinetic.map((k, i) => k + energy.potential[i])},
          momentum: {linear: f32(run.momentum.linear), angular: f32(run.momentum.angular)}};
}
// The last frame at or before t.
function frame_at(times, t) {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const mid = (low + high + 1) >> 1;
    if (times[mid] <= t + 1e-9) low = mid; else high = mid - 1;
  }
  return low;
}

const data = JSON.parse($('data').textContent), runs = data.runs.map(unpack), first = runs[0];
const count = first.bodies.length, end = Math.max(...runs.map(r => r.t[r.t.length - 1]));
// the scrub bar goes over the moments of all runs
const moments = runs.length === 1 ? first.t : Float64Array.from([...new Set(runs.flatMap(r => [...r.t]))].sort((a, b) => a - b));
let time = 0, playing = false, chosen = 0;

function bounds() {
  const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate(), at = new Vector3();
  let largest = 0;
  for (const run of runs) {
    for (let k = 0; k < run.p.length; k += 3) low.min(at.fromArray(run.p, k)), high.max(at);
    for (const b of run.bodies) largest = Math.max(largest, Math.hypot(...b.size));
  }
  if (!count) low.set(0, 0, 0), high.set(0, 0, 0);
  return {middle: low.clone().add(high).multiplyScalar(0.5), reach: Math.max(high.distanceTo(low) / 2, largest, 0.1)};
}

// How far from its start any body comes.
function travel() {
  let most = 0;
  for (const run of runs)
    for (let k = 0; k < run.p.length; k += 3) {
      const start = k % (3 * count);
      most = Math.max(most, Math.hypot(run.p[k] - run.p[start], run.p[k + 1] - run.p[start + 1], run.p[k + 2] - run.p[start + 2]));
    }
  return most;
}

let stage, crowds = [];
const {middle, reach} = bounds(), typical = first.bodies.map(b => Math.hypot(...b.size)).sort((a, b) => a - b)[count >> 1] || 1, scale = typical * 0.6;
// Bodies that travel far would be specks: then the camera goes with the chosen one.
const far = travel() > 12 * typical, view_reach = far ? 1.5 * typical : reach;
$('follow').checked = far;
try {
  stage = new Stage($('canvas'), first.planes, middle, reach, view_reach);
  crowds = runs.map((run, i) => new Crowd(stage, run.bodies, i, scale));
} catch (error) {
  $('failed').hidden = false;
  $('failed').textContent = 'The scene cannot be drawn: ' + error.message + '. Plots and numbers work; the picture needs WebGL.';
}

const body = $('body'), which = $('run');
for (let i = 0; i < count; ++i) body.add(new Option(`${i} (${first.bodies[i].mass.toPrecision(3)} kg, ${first.bodies[i].size.map(s => s.toPrecision(3)).join(' × ')} m)`, i));
runs.forEach((run, i) => {
  which.add(new Option(run.name, i));
  if (runs.length < 2) return;
  const item = $('legend').appendChild(document.createElement('li')), swatch = item.appendChild(document.createElement('i'));
  swatch.style.background = i ? ghost_color(i) : 'linear-gradient(90deg,#4e8fd0,#e08a3c,#58a866)';
  item.append(i ? `${run.name} (see-through)` : `${run.name} (solid)`);
});
which.parentElement.hidden = $('beside').parentElement.hidden = runs.length < 2;
$('scrub').max = moments.length - 1;

// of one run each curve has a colour; of several each run has one, as its cuboids do, and each curve its dashes
const curve_color = (run, curve) => runs.length === 1 ? `--s${curve}` : run ? ghost_color(run) : '--s0';
const label = (name, run) => runs.length > 1 ? `${name}, ${run.name}` : name;
const plots = [['energy', ['total', 'kinetic', 'potential']], ['momentum', ['linear', 'angular']]].map(([id, names]) => {
  const plot = new TimePlot($(id), runs.flatMap((run, r) => names.map((name, k) => ({name: label(name, run), color: curve_color(r, k), dash: runs.length > 1 ? k : 0}))), t => { pause(); snap(t); });
  const of_run = (run, name) => runs.length === 1 ? run[id][name] : Array.from(moments, t => t > run.t[run.t.length - 1] + 1e-9 ? null : run[id][name][frame_at(run.t, t)]);
  plot.set(moments, runs.flatMap(run => names.map(name => of_run(run, name))));
  return plot;
});

const p = new Float32Array(3 * count), q = new Float32Array(4 * count), qa = new Quaternion(), qb = new Quaternion();
// Between two frames: positions in a line, attitudes along the shorter arc.
function between(run, k, t) {
  const next = Math.min(k + 1, run.t.length - 1), gap = run.t[next] - run.t[k], s = gap > 0 ? Math.min(1, Math.max(0, (t - run.t[k]) / gap)) : 0;
  for (let i = 0; i < 3 * count; ++i) p[i] = run.p[3 * count * k + i] * (1 - s) + run.p[3 * count * next + i] * s;
  for (let i = 0; i < 4 * count; i += 4) {
    const a = 4 * count * k + i, b = 4 * count * next + i;
    qa.set(run.q[a + 1], run.q[a + 2], run.q[a + 3], run.q[a]);
    if (s > 0) qa.slerp(qb.set(run.q[b + 1], run.q[b + 2], run.q[b + 3], run.q[b]), s);
    q[i] = qa.w, q[i + 1] = qa.x, q[i + 2] = qa.y, q[i + 3] = qa.z;
  }
}
function trail_of(run, k) {
  const points = [], bodies = count <= 60 ? [...Array(count).keys()] : [chosen];
  for (let f = k; f > 0 && run.t[f] > run.t[k] - 1.5; --f)
    for (const i of bodies) {
      const a = 3 * (count * f + i), b = 3 * (count * (f - 1) + i);
      points.push(run.p[a], run.p[a + 1], run.p[a + 2], run.p[b], run.p[b + 1], run.p[b + 2]);
    }
  return points;
}
const largest_j = Math.max(1e-300, ...runs.map(r => r.touches.j.reduce((most, x) => Math.max(most, Math.abs(x)), 0)));
const at = new Vector3(), v = new Vector3();
function arrows_of(run, crowd, k) {
  crowd.impulses.clear(), crowd.velocities.clear();
  if ($('contacts').checked)
    for (let f = k; f >= 0 && (f === k || run.t[f] > time - 0.05); --f)
      for (let c = f ? run.touches.end[f - 1] : 0; c < run.touches.end[f]; ++c) {
        v.fromArray(run.touches.j, 3 * c);
        crowd.impulses.add(at.fromArray(run.touches.p, 3 * c), v, 3 * scale * Math.sqrt(v.length() / largest_j));
      }
  if ($('velocities').checked)
    for (let i = 0; i < count; ++i) crowd.velocities.add(at.fromArray(p, 3 * i), v.fromArray(run.v, 3 * (count * k + i)), 0.25 * v.length());
}
const digits = (x, decimals = 4) => Math.abs(x) >= 1e4 ? x.toExponential(3) : x.toFixed(decimals).replace(/^-(0(\.0+)?)$/, '$1');
// no more decimals than a step of the recording (1/32767 of the largest) fills
const kept = ({largest}) => largest > 0 ? Math.max(0, Math.min(4, Math.floor(-Math.log10(largest / 32767)))) : 4;
const decimals = data.runs.map(run => [4, kept(run.v), kept(run.w)]);
const cells = [...$('state').tBodies[0].rows].map(row => [...row.querySelectorAll('td')]);
function numbers() {
  if (!count) return;
  const r = +which.value || 0, run = runs[r], k = frame_at(run.t, time), i = count * k + chosen;
  [run.p, run.v, run.w].forEach((values, row) => cells[row].forEach((cell, c) => { cell.textContent = digits(values[3 * i + c], decimals[r][row]); }));
  cells[3].forEach((cell, c) => { cell.textContent = digits(run.q[4 * i + 1 + c]); });
  $('qw').textContent = 'w ' + digits(run.q[4 * i]);
}
let followed = null;
function show() {
  const m = frame_at(moments, time);
  $('scrub').value = m;
  $('scrub').setAttribute('aria-valuetext', moments[m].toFixed(3) + ' s');
  $('time').textContent = `${time.toFixed(3)} of ${end.toFixed(2)} s`;
  numbers();
  plots.forEach(plot => plot.at(time));
  if (!stage) return;
  runs.forEach((run, r) => {
    const k = frame_at(run.t, time), crowd = crowds[r];
    between(run, k, time);
    crowd.place(p, q, $('axes').checked);
    arrows_of(run, crowd, k);
    crowd.trace($('trails').checked ? trail_of(run, k) : []);
    crowd.group.position.x = $('beside').checked ? r * (far ? 3 * typical : 2.2 * reach) : 0;
    if (r === (+which.value || 0) && $('follow').checked && count) {
      const target = new Vector3().fromArray(p, 3 * chosen).add(crowd.group.position);
      if (followed) stage.camera.position.add(target.clone().sub(followed));
      else stage.camera.position.add(target.clone().sub(stage.controls.target));
      stage.controls.target.copy(target);
      followed = target;
    }
  });
  if (!$('follow').checked) followed = null;
  stage.world.visible = $('world').checked;
  stage.draw();
}
function go(t) { time = Math.min(end, Math.max(0, t)); show(); }
function snap(t) { go(moments[frame_at(moments, t)]); }
function step(by) { pause(); go(moments[Math.min(moments.length - 1, Math.max(0, frame_at(moments, time) + by))]); }

let last = 0;
function tick(now) {
  if (!playing) return;
  const passed = Math.min(0.1, (now - last) / 1000) * +$('speed').value;
  last = now;
  go(time + passed);
  if (time >= end) pause(); else requestAnimationFrame(tick);
}
function play() {
  if (time >= end) time = 0;
  playing = true, last = performance.now();
  $('play').textContent = '❚❚', $('play').setAttribute('aria-label', 'Pause');
  requestAnimationFrame(tick);
}
function pause() {
  playing = false;
  $('play').textContent = '▶', $('play').setAttribute('aria-label', 'Play');
}
function choose(i) { chosen = (i + count) % count; body.value = chosen; followed = null; show(); }

$('play').onclick = () => playing ? pause() : play();
$('back').onclick = () => step(-1);
$('next').onclick = () => step(1);
$('scrub').oninput = event => { pause(); go(moments[+event.target.value]); };
body.onchange = () => choose(+body.value);
which.onchange = show;
for (const id of ['contacts', 'trails', 'axes', 'velocities', 'world', 'follow', 'beside']) $(id).onchange = show;
const toggle = id => { $(id).checked = !$(id).checked; show(); };
const faster = by => { const s = $('speed'); s.selectedIndex = Math.min(s.options.length - 1, Math.max(0, s.selectedIndex + by)); };
const keys = {' ': () => playing ? pause() : play(), ArrowLeft: () => step(-1), ArrowRight: () => step(1), Home: () => { pause(); go(0); }, End: () => { pause(); go(end); },
              '[': () => faster(-1), ']': () => faster(1), f: () => toggle('follow'), c: () => toggle('contacts'), t: () => toggle('trails'), a: () => toggle('axes'),
              v: () => toggle('velocities'), n: () => choose(chosen + 1)};
addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
  const on = event.target.tagName;
  if (on === 'SELECT' || on === 'INPUT' && event.target.type !== 'range' && event.key === ' ' || on === 'BUTTON' && event.key === ' ' || on === 'SUMMARY' && event.key === ' ') return;
  event.preventDefault();
  keys[event.key]();
});
if (stage) {
  let down;
  $('canvas').addEventListener('pointerdown', event => { down = event; });
  $('canvas').addEventListener('pointerup', event => {
    if (!down || Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) > 4) return;
    const hit = stage.pick(event, crowds);
    if (!hit) return;
    which.value = crowds.indexOf(hit.crowd);
    choose(hit.body);
  });
  stage.controls.addEventListener('change', () => { if (!playing) stage.renderer.render(stage.scene, stage.camera); });
}
show();
