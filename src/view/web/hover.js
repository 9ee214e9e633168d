// Plots of a report under the pointer: uPlot in place of the static picture, from the same numbers. Without scripts, and on
// paper, the picture stays.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import './hover.css';

const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const exponential = x => x.toExponential(2).replace('e+', 'e');
// a point's value; an axis writes all its ticks in one way, by exponent where one of them is small or large
const short = x => x == null ? '' : x === 0 ? '0' : Math.abs(x) >= 1e4 || Math.abs(x) < 1e-3 ? exponential(x) : String(+x.toPrecision(4));

// uPlot wants one list of x for all curves
function aligned(series) {
  const xs = [...new Set(series.flatMap(s => s.x))].sort((a, b) => a - b);
  return [xs, ...series.map(s => { const at = new Map(s.x.map((x, i) => [x, s.y[i]])); return xs.map(x => at.has(x) ? at.get(x) : undefined); })];
}

// The powers of ten on a logarithmic axis, and twice and five times them where fewer than two are seen. uPlot's own search for them
// does not end for some ranges: it goes on from the last tick by its value, which rounding may have left off the powers.
function decades(low, high) {
  const exponents = [];
  for (let k = Math.floor(Math.log10(low)); k <= Math.log10(high); ++k) exponents.push(k);
  const ticks = multiples => exponents.flatMap(k => multiples.map(m => Number(`${m}e${k}`))).filter(t => low <= t && t <= high);
  return ticks([1]).length < 2 ? ticks([1, 2, 5]) : ticks([1]);
}

function draw(figure) {
  const plot = JSON.parse(figure.querySelector('script').textContent), still = figure.querySelector('svg');
  const host = document.createElement('div');
  host.className = 'hover';
  host.setAttribute('role', 'img');
  host.setAttribute('aria-label', still.querySelector('desc').textContent);
  still.before(host);
  const ticks_text = ticks => {
    const sizes = ticks.map(Math.abs).filter(t => t > 0), by_exponent = sizes.some(t => t >= 1e4 || t < 1e-3 * 0.999);
    return ticks.map(t => t == null ? '' : !by_exponent || t === 0 ? String(+t.toPrecision(6)) : (+t.toPrecision(6)).toExponential().replace('e+', 'e'));
  };
  const axis = {stroke: css('--ink'), grid: {stroke: css('--line'), width: 1}, ticks: {stroke: css('--line')}, font: '12px sans-serif', labelFont: '13px sans-serif'};
  const axis_of = (label, log) => ({...axis, label, values: (u, ticks) => ticks_text(ticks), ...log && {splits: (u, i, low, high) => decades(low, high)}});
  const scale = log => log ? {distr: 3, range: (u, low, high) => [low / 1.4, high * 1.4]} : {};
  const size = () => ({width: Math.min(720, figure.clientWidth), height: 400});
  const chart = new uPlot({
    ...size(), scales: {x: {time: false, ...scale(plot.log_x)}, y: scale(plot.log_y)}, cursor: {drag: {x: true, y: true}},
    legend: {markers: {dash: (u, i) => plot.series[i - 1]?.dash ? 'dashed' : 'solid'}},
    axes: [axis_of(plot.x_label, plot.log_x), {...axis_of(plot.y_label, plot.log_y), size: 70}],
    series: [{label: plot.x_label, value: (u, x) => short(x)}, ...plot.series.map(s => ({
      label: s.name, show: !s.aside, stroke: css('--s' + s.colour), width: s.dashed ? 1.2 : 1.8, dash: s.dash.split(' ').filter(Boolean).map(Number), spanGaps: true,
      points: {show: s.markers && !s.dashed, size: 6, fill: s.dash ? css('--paper') : css('--s' + s.colour)}, value: (u, y) => y && plot.log_y ? exponential(y) : short(y)}))],
  }, aligned(plot.series), host);
  figure.classList.add('hovers');
  new ResizeObserver(() => chart.setSize(size())).observe(figure);
}
for (const figure of document.querySelectorAll('figure.plot')) draw(figure);
