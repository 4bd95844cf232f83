// SPDX-License-Identifier: Apache-2.0
// State of the run: progress, time step, warnings, and the button that stops it.
import { requestStop } from '../data/api.js';
import { make } from '../dom.js';
import { countText, durationText, numberText } from '../text.js';

const COUNTS = [
  ['particles', 'particles'],
  ['surfels', 'surfels'],
  ['sheet', 'sheet vertices'],
  ['oriented', 'oriented'],
];

/// Returns a link to the licences of bundled packages, or their text in a page without a server.
function licences() {
  const title = 'licences of three.js and uPlot',
    text = document.getElementById('licences');
  if (!text) return make('a', { href: 'licences.txt', textContent: title, target: '_blank' });
  return make(
    'details',
    {},
    make('summary', { textContent: title }),
    make('pre', { textContent: text.textContent }),
  );
}

export class StatusPanel {
  constructor(parent) {
    this.state = make('span', { id: 'state', className: 'state' });
    this.text = make('span', { id: 'state-text' });
    this.bar = make('progress', { id: 'progress', max: 1, value: 0 });
    this.left = make('div', { id: 'time-left', className: 'left' });
    this.table = make('table', { id: 'figures' });
    this.stop = make('button', {
      id: 'stop',
      textContent: 'Stop with checkpoint',
      onclick: () => this.askStop(),
    });
    this.warnings = make('ul', { id: 'warnings' });
    this.warningsTitle = make('h2', { textContent: 'Warnings' });
    this.charts = make('div', { id: 'charts' });
    this.phases = make('div', { id: 'phases', hidden: true });
    this.ask = make(
      'div',
      { id: 'stop-question', hidden: true },
      'Stop the run? It writes a checkpoint first. ',
      make('button', { id: 'stop-yes', textContent: 'Stop', onclick: () => this.sendStop() }),
      make('button', {
        textContent: 'No',
        onclick: () => {
          this.ask.hidden = true;
        },
      }),
    );
    parent.append(
      make('header', {}, this.state, this.text),
      this.bar,
      this.left,
      this.stop,
      this.ask,
      this.table,
      this.warningsTitle,
      this.warnings,
      this.charts,
      this.phases,
      make('footer', {}, licences()),
    );
  }

  askStop() {
    this.ask.hidden = false;
  }

  async sendStop() {
    this.ask.hidden = true;
    try {
      await requestStop();
      this.stop.textContent = 'Stop requested';
    } catch (problem) {
      this.stop.textContent = problem.message;
    }
    this.stop.disabled = true;
  }

  /// run: of api/run. end: s, of the scene, or null.
  update(run, end) {
    const { progress: p, summary: s } = run;
    const time = p.time_s ?? s.time_s,
      last = s.end_s ?? end;
    this.state.textContent = run.state;
    this.state.dataset.state = run.state;
    this.text.textContent = run.text === run.state ? '' : run.text.replace(`${run.state}: `, '');
    const share = time !== undefined && last > 0 ? Math.min(1, time / last) : 0;
    this.bar.value = share;
    this.left.textContent = this.leftText(run, share, time, last);
    this.stop.hidden = !run.live;
    if (run.live && run.stop_requested)
      [this.stop.textContent, this.stop.disabled] = ['Stop requested', true];
    else if (run.live && !this.stop.disabled) this.stop.textContent = 'Stop with checkpoint';
    else if (!run.live) this.stop.disabled = false;
    this.table.replaceChildren(
      ...this.figures(run).map(([name, value]) =>
        make('tr', {}, make('th', { textContent: name }), make('td', { textContent: value })),
      ),
    );
    this.showWarnings(s.warnings ?? []);
    this.showPhases(s.phases_s ?? {});
  }

  /// phases: s of wall-clock time by name, means over the ranks.
  showPhases(phases) {
    const all = Object.entries(phases).sort(([, a], [, b]) => b - a);
    const sum = all.reduce((total, [, time]) => total + time, 0);
    this.phases.hidden = !(sum > 0);
    const bar = ([name, time]) =>
      make(
        'div',
        { className: 'phase', title: `${numberText(time, 3)} s` },
        make('span', { textContent: name }),
        make('i', { style: { width: `${(100 * time) / all[0][1]}px` } }),
        make('span', { textContent: `${numberText((100 * time) / sum, 2)} %` }),
      );
    this.phases.replaceChildren(
      make('h3', { textContent: 'wall-clock time by phase of the step' }),
      ...all.filter(([, time]) => time > 0.01 * sum).map(bar),
    );
  }

  leftText({ live, age_s: age, progress }, share, time, last) {
    const parts = [`${(100 * share).toFixed(1)} %`];
    if (time !== undefined && last > 0) parts.push(`${numberText(time)} of ${numberText(last)} s simulated`);
    if (live && progress.seconds_left !== undefined)
      parts.push(`${durationText(progress.seconds_left)} left`);
    if (live && age > 10) parts.push(`last line ${durationText(age)} ago`);
    return parts.join(' · ');
  }

  figures(run) {
    const { progress: p, summary: s } = run;
    const rows = [];
    const add = (name, value, unit = '') => {
      if (value !== undefined && value !== null && value !== '')
        rows.push([name, `${numberText(value)}${unit}`]);
    };
    const step = p.step ?? s.step;
    if (step !== undefined) rows.push(['step', countText(step)]);
    const limit = p.dt_limited_by || s.dt_limited_by;
    add('time step', p.dt_s ?? s.dt_s, limit ? ` s, limited by ${limit}` : ' s');
    if (p.substeps > 1) add('substeps', p.substeps);
    add('steps a second', p.steps_per_second);
    if (s.ranks) add('ranks', s.ranks);
    if (!run.live && s.wall_s > 0) rows.push(['wall-clock time', durationText(s.wall_s)]);
    for (const [key, name] of COUNTS) if (p[key] > 0) rows.push([name, countText(p[key])]);
    if (p.particles > 0 && p.liquid_fraction !== undefined) add('liquid', 100 * p.liquid_fraction, ' %');
    if (p.energy_scale_J > 0) {
      const share = numberText((100 * p.energy_residual_J) / p.energy_scale_J, 2);
      rows.push(['energy residual', `${numberText(p.energy_residual_J, 3)} J (${share} %)`]);
    }
    if (p.heat_in_J) add('heat in', p.heat_in_J, ' J');
    for (const name of ['density', 'divergence', 'viscosity'])
      add(`${name} iterations`, p[`${name}_iterations`]);
    return rows;
  }

  showWarnings(warnings) {
    this.warnings.hidden = this.warningsTitle.hidden = warnings.length === 0;
    if (JSON.stringify(warnings) === this.shown) return;
    this.shown = JSON.stringify(warnings);
    this.warnings.replaceChildren(...warnings.map((text) => make('li', { textContent: text })));
  }
}
