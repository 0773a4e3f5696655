// SPDX-License-Identifier: BSD-3-Clause
// Milliseconds of each stage: lines over the last frames, and now and median as numbers.
import uPlot from 'uplot';
import { byId, make, setText } from '../look/dom';
import { brief } from '../look/format';
import type { Colours } from '../look/theme';
import { median } from '../model/sampling';
import { Pace, type Panel, type View } from '../model/view';
import { axis, fitPlot, hideCanvas } from './plot_look';

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
  private stages: string[] = [];
  private cells: StageRow[] = [];
  private plot: uPlot | null = null;
  private key = '';

  update(view: View, time: number): boolean {
    const stages = stagesOf(view);
    const painted = view.colours !== this.colours;
    this.colours = view.colours;
    if (stages.join() !== this.stages.join()) this.rebuild(stages);
    if (this.plot === null) return false;
    const resized = fitPlot(this.plot, this.root);
    if (painted && !resized) this.plot.redraw(false);
    const key = `${view.row} ${view.rows.count}`;
    if (key === this.key) return false;
    if (!this.pace.due(time)) return true;
    this.key = key;
    this.show(view, this.plot);
    return false;
  }

  private show({ rows, row }: View, plot: uPlot): void {
    const first = Math.max(0, row + 1 - kFrames);
    const columns = this.stages.map((stage) => rows.column(`${stage}_ms`));
    const frames = Array.from(rows.column('frame').subarray(first, row + 1));
    const lines = columns.map((column) =>
      Array.from(column.subarray(first, row + 1), (ms) => (ms >= 0 ? Math.max(ms, kLeast) : null)),
    );
    plot.setData([frames, ...lines]);
    columns.forEach((column, i) => {
      const cells = this.cells[i] as StageRow;
      setText(cells.now, brief(column[row] ?? NaN));
      setText(cells.median, brief(median(column, first, row + 1)));
    });
  }

  private rebuild(stages: string[]): void {
    this.stages = stages;
    this.plot?.destroy();
    this.cells = [];
    this.table.replaceChildren(...stages.map((stage) => this.makeRow(stage)));
    const colours = () => this.colours as Colours;
    const log = (_: uPlot, low: number, high: number): uPlot.Range.MinMax => [
      10 ** Math.floor(Math.log10(Math.max(low ?? 1, kLeast))),
      10 ** Math.ceil(Math.log10(Math.max(high ?? 1, 10 * kLeast))),
    ];
    this.plot = new uPlot(
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
        series: [{}, ...stages.map((stage) => this.series(stage))],
      },
      [[], ...stages.map(() => [])],
      this.root,
    );
    hideCanvas(this.plot);
  }

  private series(stage: string): uPlot.Series {
    const stroke = () => this.colours?.[kStageColours[stage] ?? 'sky'] ?? '#888';
    return { label: stage, stroke, width: 1.3, points: { show: false } };
  }

  private makeRow(stage: string): HTMLTableRowElement {
    const row = make('tr');
    const head = make('th', { scope: 'row' });
    const colour = `--swatch: var(--${kStageColours[stage] ?? 'sky'})`;
    head.append(make('i', { class: 'swatch', style: colour }), stage);
    const now = make('td', { 'data-testid': `${stage}-now` });
    const middle = make('td', { 'data-testid': `${stage}-median` });
    row.append(head, now, middle);
    this.cells.push({ now, median: middle });
    return row;
  }
}

function isDecade(tick: number): boolean {
  const power = Math.log10(tick);
  return Math.abs(power - Math.round(power)) < 1e-9;
}

function stagesOf({ info, rows }: View): string[] {
  return (info?.stages ?? []).filter((stage) => rows.names.includes(`${stage}_ms`));
}
