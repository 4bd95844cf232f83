// SPDX-License-Identifier: Apache-2.0
// Time slider, play, and following the newest frame.
import { pageData } from '../data/api.js';
import { make, setOptions } from '../dom.js';
import { timeText } from '../text.js';

const RATES = [2, 6, 12, 25, 50];

export class TimeBar {
  constructor(parent, settings) {
    this.settings = settings;
    this.times = [];
    this.play = make('button', { id: 'play', title: 'play (space)', onclick: () => this.togglePlay() });
    this.slider = make('input', {
      id: 'time',
      type: 'range',
      min: 0,
      max: 0,
      step: 1,
      value: 0,
      title: 'frame (left and right keys)',
      oninput: () => this.go(Number(this.slider.value)),
    });
    this.label = make('output', { id: 'time-label' });
    this.rate = make('select', {
      id: 'rate',
      title: 'frames a second',
      onchange: () => settings.change({ rate: Number(this.rate.value) }),
    });
    setOptions(
      this.rate,
      RATES.map((n) => [String(n), `${n}/s`]),
      String(settings.rate),
    );
    this.follow = make('input', {
      id: 'follow',
      type: 'checkbox',
      checked: settings.follow,
      onchange: () => this.setFollow(this.follow.checked),
    });
    parent.append(
      this.play,
      this.slider,
      this.label,
      this.rate,
      make(
        'label',
        { title: 'shows the newest frame of a running run', hidden: pageData !== null },
        this.follow,
        'follow',
      ),
    );
    document.addEventListener('keydown', (event) => this.key(event));
    settings.listen(() => this.update());
    this.update();
  }

  setTimes(times) {
    this.times = times;
    this.slider.max = Math.max(0, times.length - 1);
    this.update();
  }

  update() {
    const { frame, playing, follow } = this.settings;
    this.play.textContent = playing ? '❚❚' : '▶';
    this.follow.checked = follow;
    this.slider.value = Math.max(0, frame);
    const count = this.times.length,
      last = this.times[count - 1];
    const shown = frame >= 0 && frame < count;
    this.label.textContent = shown
      ? `${timeText(this.times[frame], last)} of ${timeText(last, last)} · frame ${frame + 1}/${count}`
      : 'no frame yet';
  }

  /// Shows a frame by its index. Only the newest one is followed.
  go(frame) {
    const newest = this.times.length - 1;
    this.settings.change({
      frame: Math.min(newest, Math.max(0, frame)),
      follow: this.settings.follow && frame >= newest,
      playing: false,
    });
  }

  setFollow(follow) {
    const newest = this.times.length - 1;
    this.settings.change(follow ? { follow, playing: false, frame: newest } : { follow });
  }

  togglePlay() {
    const { playing, frame } = this.settings,
      newest = this.times.length - 1;
    if (playing) this.settings.change({ playing: false });
    else this.settings.change({ playing: true, follow: false, frame: frame >= newest ? 0 : frame });
  }

  key(event) {
    if (['INPUT', 'SELECT', 'BUTTON'].includes(event.target.tagName) && event.target !== this.slider) return;
    if (event.key === ' ') this.togglePlay();
    else if (event.target !== this.slider && event.key === 'ArrowLeft') this.go(this.settings.frame - 1);
    else if (event.target !== this.slider && event.key === 'ArrowRight') this.go(this.settings.frame + 1);
    else return;
    event.preventDefault();
  }
}
