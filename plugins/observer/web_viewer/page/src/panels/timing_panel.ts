// SPDX-License-Identifier: BSD-3-Clause
// Wall time of each stage: lines over the last frames; at the shown frame, and the median.
import uPlot from 'uplot';
import { byId, make, setText } from '../look/dom';
import { brief } from '../look/format';
import type { Colours } from '../look/theme';
import { median } from '../model/sampling';
import { Pace, type Panel, type PageState } from '../model/page_state';
import { kColumns, type ColumnName } from '../wire/records';
import { axis, fitPlot, hideCanvas } from './plot_look';

const kDurations = kColumns.filter((column) => column.startsWith('duration.'));
const kFrames = 300;
const kLeast = 1e-3; // ms; a logarithmic axis has no zero

const kStageColours: Readonly<Record<string, keyof Colours>> = {
  source: 'grey', odometry: 'orange', place: 'purple', cells: 'green', map: 'blue',
};

interface StageRow {
  readonly now: HTMLElement;
  readonly median: HTMLElement;
}

export class TimingPanel implements Panel {
  private readonly root = byId('timing');
  private readonly table = byId('stages');
  private readonly pace = new Pace(150);
  private colours: Colours | null = null;
  private readonly rows: StageRow[];
  private plot: uPlot | null = null;
  private key = '';

  constructor() {
    this.rows = kDurations.map((column) => this.makeRow(stageOf(column)));
  }

  update(state: PageState, time: number): boolean {
    const painted = state.colours !== this.colours;
    this.colours = state.colours;
    const plot = (this.plot ??= this.makePlot());
    const resized = fitPlot(plot, this.root);
    if (painted && !resized) plot.redraw(false);
    const key = `${state.row} ${state.rows.count}`;
    if (key === this.key) return false;
    if (!this.pace.due(time)) return true;
    this.key = key;
    this.show(state, plot);
    return false;
  }

  private show({ rows, row }: PageState, plot: uPlot): void {
    const first = Math.max(0, row + 1 - kFrames);
    const columns = kDurations.map((column) => rows.column(column));
    const frames = Array.from(rows.column('frame.frame').subarray(first, row + 1));
    const lines = columns.map((column) =>
      Array.from(column.subarray(first, row + 1), (ms) => (ms >= 0 ? Math.max(ms, kLeast) : null)),
    );
    plot.setData([frames, ...lines]);
    columns.forEach((column, i) => {
      const cells = this.rows[i] as StageRow;
      setText(cells.now, brief(column[row] ?? NaN));
      setText(cells.median, brief(median(column, first, row + 1)));
    });
  }

  private makePlot(): uPlot {
    const colours = () => this.colours as Colours;
    const log = (_: uPlot, low: number, high: number): uPlot.Range.MinMax => [
      10 ** Math.floor(Math.log10(Math.max(low ?? 1, kLeast))),
      10 ** Math.ceil(Math.log10(Math.max(high ?? 1, 10 * kLeast))),
    ];
    const plot = new uPlot(
      {
        width: 200,
        height: 150,
        legend: { show: false },
        cursor: { show: false },
        scales: { x: { time: false }, y: { distr: 3, log: 10, range: log } },
        axes: [
          { ...axis('frame', 22, colours), space: 44 },
          { ...axis('ms', 34, colours), values: (_, ticks) => ticks.map((t) => (isDecade(t) ? String(+t.toPrecision(3)) : '')) },
        ],
        series: [{}, ...kDurations.map((column) => this.series(stageOf(column)))],
      },
      [[], ...kDurations.map(() => [])],
      this.root,
    );
    hideCanvas(plot);
    return plot;
  }

  private series(stage: string): uPlot.Series {
    const stroke = () => this.colours?.[kStageColours[stage] ?? 'sky'] ?? '#888';
    return { label: stage, stroke, width: 1.3, points: { show: false } };
  }

  private makeRow(stage: string): StageRow {
    const row = make('tr');
    const head = make('th', { scope: 'row' });
    const colour = `--swatch: var(--${kStageColours[stage] ?? 'sky'})`;
    head.append(make('i', { class: 'swatch', style: colour }), stage);
    const now = make('td', { 'data-testid': `${stage}-now` });
    const middle = make('td', { 'data-testid': `${stage}-median` });
    row.append(head, now, middle);
    this.table.append(row);
    return { now, median: middle };
  }
}

function stageOf(column: ColumnName): string {
  return column.slice('duration.'.length);
}

function isDecade(tick: number): boolean {
  const power = Math.log10(tick);
  return Math.abs(power - Math.round(power)) < 1e-9;
}

