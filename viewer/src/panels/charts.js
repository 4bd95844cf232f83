// SPDX-License-Identifier: Apache-2.0
// Charts of ledger.csv and progress.csv over simulated time.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { getJson } from '../data/api.js';
import { make } from '../dom.js';
import { numberText } from '../text.js';

const COLOURS = ['#3b82c4', '#d9822b', '#3f9a5f', '#b0508f', '#8a6fd1'];
const ROWS = 1500;
const HEIGHT = 132;

/// file, title, and lines: [column, name]. ratio: column that divides all lines. log: logarithmic axis.
const CHARTS = [
  {
    file: 'ledger.csv',
    title: 'energy (J)',
    lines: [
      ['kinetic_J', 'kinetic'],
      ['elastic_J', 'elastic'],
      ['potential_J', 'potential'],
      ['dissipated_J', 'dissipated'],
      ['wall_work_J', 'work of walls'],
    ],
  },
  {
    file: 'ledger.csv',
    title: 'energy residual / largest term',
    ratio: 'energy_scale_J',
    lines: [['energy_residual_J', 'residual']],
  },
  { file: 'progress.csv', title: 'time step (s)', lines: [['dt_s', 'dt']], log: true, text: 'dt_limited_by' },
  { file: 'ledger.csv', title: 'liquid fraction', lines: [['liquid_fraction', 'liquid']] },
  {
    file: 'ledger.csv',
    title: 'heat (J)',
    lines: [
      ['heat_in_J', 'heat in'],
      ['heat_residual_J', 'residual'],
    ],
  },
  {
    file: 'progress.csv',
    title: 'iterations',
    lines: [
      ['density_iterations', 'density'],
      ['divergence_iterations', 'divergence'],
      ['viscosity_iterations', 'viscosity'],
      ['contact_iterations', 'contact'],
    ],
  },
  { file: 'progress.csv', title: 'steps a second', lines: [['steps_per_second', 'steps/s']] },
];

const FILES = [...new Set(CHARTS.map((chart) => chart.file))];

function columnsOf(file) {
  const names = new Set(['time_s']);
  for (const chart of CHARTS.filter((c) => c.file === file)) {
    for (const [column] of chart.lines) names.add(column);
    for (const other of [chart.ratio, chart.text]) if (other) names.add(other);
  }
  return [...names].join(',');
}

/// Returns the values of a line, or null if they are all empty, or all the same and so say nothing.
function lineOf(columns, chart, column) {
  const values = columns[column];
  if (!values || values.every((v) => v === null || v === 0)) return null;
  const divisor = chart.ratio ? columns[chart.ratio] : null;
  return values.map((v, k) => {
    if (typeof v !== 'number') return null;
    if (divisor) return divisor[k] > 0 ? v / divisor[k] : null;
    return chart.log && v <= 0 ? null : v;
  });
}

export class Charts {
  /// onTime(time): a click on a chart.
  constructor(parent, onTime) {
    this.parent = parent;
    this.onTime = onTime;
    this.known = {};
    this.columns = {};
    this.plots = new Map();
    this.time = null;
    new ResizeObserver(() => this.resize()).observe(parent);
  }

  /// Reads what has changed since the last call.
  async read() {
    for (const file of FILES) {
      const log = await getJson('log', {
        file,
        columns: columnsOf(file),
        rows: ROWS,
        known: this.known[file],
      });
      this.known[file] = log.bytes;
      if (log.same) continue;
      this.columns[file] = log.columns;
      for (const chart of CHARTS.filter((c) => c.file === file)) this.draw(chart);
    }
  }

  draw(chart) {
    const columns = this.columns[chart.file],
      times = columns?.time_s;
    const lines =
      times?.length > 1
        ? chart.lines
            .map(([column, name], k) => ({
              name,
              colour: COLOURS[k],
              values: lineOf(columns, chart, column),
            }))
            .filter((line) => line.values)
        : [];
    const known = this.plots.get(chart);
    if (lines.length === 0) {
      known?.box.remove();
      this.plots.delete(chart);
      return;
    }
    const data = [times, ...lines.map((line) => line.values)];
    const names = JSON.stringify(lines.map((line) => line.name));
    if (known?.names === names) {
      known.plot.setData(data);
      return;
    }
    known?.plot.destroy();
    const box = known?.box ?? this.place(chart);
    box.replaceChildren(make('h3', { textContent: chart.title }));
    this.plots.set(chart, { box, names, plot: this.plotOf(chart, lines, data, box) });
  }

  /// Returns a new element at the chart's place in the order.
  place(chart) {
    const box = make('div', { className: 'chart', dataset: { chart: chart.title } });
    const later = CHARTS.slice(CHARTS.indexOf(chart) + 1)
      .map((c) => this.plots.get(c)?.box)
      .find(Boolean);
    this.parent.insertBefore(box, later ?? null);
    return box;
  }

  plotOf(chart, lines, data, box) {
    const style = getComputedStyle(document.documentElement);
    const ink = style.getPropertyValue('--quiet').trim(),
      grid = style.getPropertyValue('--line').trim();
    const axis = {
      stroke: ink,
      grid: { stroke: grid, width: 1 },
      ticks: { show: false },
      font: '11px system-ui, sans-serif',
    };
    const limits = () => this.columns[chart.file][chart.text];
    const plot = new uPlot(
      {
        width: this.width(),
        height: HEIGHT,
        legend: { markers: { width: 0, fill: (u, k) => lines[k - 1]?.colour ?? null } },
        cursor: { y: false, drag: { x: true, y: false } },
        scales: { x: { time: false }, y: chart.log ? { distr: 3 } : {} },
        axes: [
          { ...axis, size: 24, values: (u, ticks) => ticks.map((v) => numberText(v)) },
          { ...axis, size: 58, values: (u, ticks) => ticks.map((v) => (v === null ? '' : numberText(v, 3))) },
        ],
        series: [
          { label: ' ', value: (u, v) => (v === null ? '' : `${numberText(v)} s`) },
          ...lines.map(({ name, colour }) => ({
            label: name,
            stroke: colour,
            width: 1.6,
            points: { show: false },
            spanGaps: true,
            value: (u, v, series, k) =>
              v === null
                ? ''
                : `${numberText(v)}${chart.text && k !== null ? ` (${limits()?.[k] ?? ''})` : ''}`,
          })),
        ],
        hooks: { draw: [(u) => this.markTime(u)] },
      },
      data,
      box,
    );
    plot.over.addEventListener('click', () => {
      if (plot.cursor.left >= 0 && plot.select.width < 2) this.onTime(plot.posToVal(plot.cursor.left, 'x'));
    });
    return plot;
  }

  width() {
    return Math.max(160, this.parent.clientWidth);
  }

  resize() {
    for (const { plot } of this.plots.values()) plot.setSize({ width: this.width(), height: HEIGHT });
  }

  /// Draws a line at the time of the frame that is shown.
  markTime(plot) {
    if (this.time === null) return;
    const x = plot.valToPos(this.time, 'x', true),
      { left, top, width, height } = plot.bbox;
    if (x < left || x > left + width) return;
    const { ctx } = plot;
    ctx.save();
    ctx.strokeStyle = '#d9822b';
    ctx.beginPath();
    ctx.moveTo(x, top);
    ctx.lineTo(x, top + height);
    ctx.stroke();
    ctx.restore();
  }

  setTime(time) {
    this.time = time;
    for (const { plot } of this.plots.values()) plot.redraw(false);
  }

  /// Draws all charts anew in the colours of the theme.
  restyle() {
    for (const { plot, box } of this.plots.values()) {
      plot.destroy();
      box.remove();
    }
    this.plots.clear();
    for (const chart of CHARTS) if (this.columns[chart.file]) this.draw(chart);
  }
}
