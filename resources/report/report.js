'use strict';
// The contact sheet: filter, sort, and zoom; everything it shows stands in #data.
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const at = (id) => document.getElementById(id);
  const made = (tag, name, text) => {
    const element = document.createElement(tag);
    if (name) element.className = name;
    if (text !== undefined) element.textContent = text;
    return element;
  };
  const milliseconds = (ms) => (ms >= 1000 ? (ms / 1000).toFixed(2) + ' s' : ms.toFixed(0) + ' ms');
  const words = {
    done: 'done', same: 'same', changed: 'changed', 'new': 'not in the baseline', failed: 'failed', missing: 'not rendered',
  };

  for (const item of data.items) {
    const varied = item.result && item.result.varied ? item.result.varied : {};
    item.settings = Object.entries(varied).filter(([key]) => key !== 'scene').map(([key, value]) => `${key}=${value}`).join('  ');
    item.text = [item.name, item.settings, item.problem, item.result ? item.result.scene : '', words[item.status]]
      .join(' ').toLowerCase();
  }

  const rank = (item) => (item.status === 'failed' || item.status === 'missing' ? Infinity : item.flip ?? -1);
  const orders = {
    item: ['Order', (a, b) => a.item - b.item],
    name: ['Name', (a, b) => a.name.localeCompare(b.name, 'en', { numeric: true })],
    slow: ['Slowest', (a, b) => b.total_ms - a.total_ms],
    memory: ['Memory', (a, b) => (b.result ? b.result.peak_rss : 0) - (a.result ? a.result.peak_rss : 0)],
  };
  if (data.has_baseline) orders.flip = ['Most changed', (a, b) => (rank(b) - rank(a)) || 0];
  const states = [...new Set(data.items.map((item) => item.status))];
  const off = new Set();
  let listed = [];

  const card = (item, place) => {
    const button = made('button', 'card ' + item.status);
    const frame = made('span', 'frame');
    if (item.picture) {
      const image = made('img');
      image.src = item.picture;
      image.alt = item.name;
      image.loading = 'lazy';
      frame.append(image);
    } else {
      frame.append(made('p', '', item.problem));
    }
    const text = made('span', 'text');
    const slash = item.name.lastIndexOf('/') + 1;
    if (slash > 0) text.append(made('span', 'more', item.name.slice(0, slash)));
    text.append(made('span', 'name', item.name.slice(slash)));
    if (item.settings) text.append(made('span', 'more', item.settings));
    const more = made('span', 'more');
    more.append(made('span', 'badge ' + item.status, words[item.status]));
    if (item.total_ms > 0) more.append(' ', milliseconds(item.total_ms));
    if (item.flip !== null) more.append(` FLIP ${item.flip.toFixed(4)}`);
    text.append(more);
    button.append(frame, text);
    button.addEventListener('click', () => open(place));
    return button;
  };

  const list = () => {
    const wanted = at('search').value.toLowerCase().split(/\s+/).filter(Boolean);
    listed = data.items.filter((item) => !off.has(item.status) && wanted.every((word) => item.text.includes(word)));
    listed.sort(orders[at('sort').value][1]);
    at('sheet').replaceChildren(...listed.map(card));
    at('counts').textContent = counts();
  };

  const counts = () => {
    const parts = states.map((state) => `${data.items.filter((item) => item.status === state).length} ${words[state]}`);
    const total = data.items.reduce((sum, item) => sum + item.total_ms, 0);
    return `${data.items.length} items: ${parts.join(', ')}. ${milliseconds(total)} of work. ${listed.length} shown.`;
  };

  // The zoom.
  let current = 0;
  let view = 'picture';
  const rows = (item) => {
    const result = item.result || {};
    const out = [];
    if (item.problem) out.push(['problem', item.problem]);
    if (item.flip !== null) out.push(['FLIP', `${item.flip.toFixed(6)} (bound ${data.max_flip})`]);
    for (const [key, value] of Object.entries(result.varied || {})) if (key !== 'scene') out.push([key, value]);
    if (result.scene) out.push(['scene', result.scene]);
    if (result.ms) out.push(['time', Object.entries(result.ms).map(([key, ms]) => `${key} ${milliseconds(ms)}`).join(', ')]);
    if (result.exposure) out.push(['exposure', String(result.exposure)]);
    if (result.attempts > 1) out.push(['attempts', String(result.attempts)]);
    if (result.peak_rss) out.push(['peak memory', `${(result.peak_rss / 1e6).toFixed(0)} MB`]);
    for (const warning of result.warnings || []) {
      const place = [warning.path, warning.pointer].filter(Boolean).join(':');
      out.push(['warning', (place ? place + ': ' : '') + warning.message]);
    }
    if (result.sha256) out.push(['SHA-256', result.sha256]);
    return out;
  };

  const show = () => {
    const item = listed[current];
    const views = ['picture', 'baseline', 'heat'].filter((name) => item[name]);
    if (!views.includes(view)) view = 'picture';
    at('views').replaceChildren(...(views.length > 1 ? views : []).map((name) => {
      const button = made('button', '', { picture: 'Picture', baseline: 'Baseline', heat: 'Difference' }[name]);
      button.setAttribute('aria-pressed', String(name === view));
      button.addEventListener('click', () => { view = name; show(); });
      return button;
    }));
    at('zoom-name').textContent = item.name;
    at('file').href = item.link;
    const large = at('large');
    const link = { picture: item.link, baseline: item.baseline_link, heat: '' }[view];
    const full = item.shown && link && item[view];
    large.classList.toggle('small', !full);
    large.onerror = () => { large.onerror = null; large.classList.add('small'); large.src = item[view]; };
    large.hidden = !item[view];
    if (item[view]) large.src = full ? link : item[view];
    const table = made('table');
    for (const [key, value] of rows(item)) {
      const row = made('tr');
      row.append(made('td', '', key), made('td', '', value));
      table.append(row);
    }
    at('detail').replaceChildren(table, made('pre', '', item.command || ''));
  };
  const open = (place) => {
    current = place;
    show();
    if (!at('zoom').open) at('zoom').showModal();
  };
  const step = (by) => { if (listed.length > 0) open((current + by + listed.length) % listed.length); };
  at('previous').addEventListener('click', () => step(-1));
  at('next').addEventListener('click', () => step(1));
  at('close').addEventListener('click', () => at('zoom').close());
  at('zoom').addEventListener('click', (event) => { if (event.target === at('zoom')) at('zoom').close(); });
  at('large').addEventListener('click', () => at('stage').classList.toggle('actual'));
  at('zoom').addEventListener('keydown', (event) => {
    if (event.key === 'ArrowLeft') step(-1);
    if (event.key === 'ArrowRight') step(1);
    if (event.key === ' ' && event.target.tagName !== 'BUTTON') {
      event.preventDefault();
      view = view === 'baseline' ? 'picture' : 'baseline';
      show();
    }
  });

  // The tools.
  at('title').textContent = data.job;
  for (const [key, [text]] of Object.entries(orders)) {
    const option = made('option', '', text);
    option.value = key;
    at('sort').append(option);
  }
  if (data.has_baseline) at('sort').value = 'flip';
  for (const state of states.length > 1 ? states : []) {
    const button = made('button', '', words[state]);
    button.type = 'button';
    button.setAttribute('aria-pressed', 'true');
    button.addEventListener('click', () => {
      if (off.has(state)) off.delete(state); else off.add(state);
      button.setAttribute('aria-pressed', String(!off.has(state)));
      list();
    });
    at('states').append(button);
  }
  at('search').addEventListener('input', list);
  at('sort').addEventListener('change', list);
  at('size').addEventListener('input', () => document.documentElement.style.setProperty('--side', at('size').value + 'px'));
  for (const film of data.films) at('films').append(made('pre', '', film));
  at('films').hidden = data.films.length === 0;
  list();
})();
