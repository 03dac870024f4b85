// Looks at a report page from inside a browser and writes what is wrong with it
// into an element of the page. See browserFindings.m.
'use strict';
(function () {
  const findings = [];
  const say = (rule, what) => findings.push(rule + ': ' + String(what).slice(0, 90));
  const all = (selector, from) => Array.from((from || document).querySelectorAll(selector));

  // layout
  const excess = document.documentElement.scrollWidth - window.innerWidth;
  if (excess > 0) say('overflow', excess + ' px wider than the window');
  all('p, li, h1, h2, h3, dd, dt, figcaption, figure').forEach((e) => {
    const box = e.getBoundingClientRect();
    if (e.closest('.scroll, .wide, details:not([open])') || box.width === 0) return;
    if (box.right > window.innerWidth + 1) say('cut', e.textContent);
  });

  // figures
  const drawn = 'use, polygon, path[stroke*="--"]:not([stroke*="--axis"]):not([stroke*="--grid"])';
  all('figure svg').forEach((svg) => {
    const frame = svg.getBoundingClientRect();
    const name = svg.getAttribute('aria-label');
    if (!name || svg.getAttribute('role') !== 'img') say('name', 'a figure has none');
    if (svg.querySelectorAll(drawn).length === 0) say('empty', name);
    if (frame.width === 0) return;
    const boxes = all('text', svg).filter((t) => t.textContent.trim())
      .map((t) => ({ r: t.getBoundingClientRect(), s: t.textContent.trim() }));
    boxes.forEach((a, i) => {
      if (a.r.left < frame.left - 1 || a.r.right > frame.right + 1 ||
          a.r.top < frame.top - 1 || a.r.bottom > frame.bottom + 1) {
        say('cut text', name + ' | ' + a.s);
      }
      boxes.slice(i + 1).forEach((b) => {
        if (Math.min(a.r.right, b.r.right) - Math.max(a.r.left, b.r.left) > 1 &&
            Math.min(a.r.bottom, b.r.bottom) - Math.max(a.r.top, b.r.top) > 2) {
          say('overlap', name + ' | ' + a.s + ' | ' + b.s);
        }
      });
    });
  });

  // structure
  let level = 0;
  all('h1, h2, h3, h4').forEach((h) => {
    const own = Number(h.tagName[1]);
    if (own > level + 1) say('heading', 'h' + level + ' then ' + h.textContent);
    level = own;
  });
  if (all('h1').length !== 1) say('heading', 'not exactly one h1');
  ['header', 'nav', 'main', 'footer'].forEach((tag) => {
    if (all(tag).length !== 1) say('landmark', tag);
  });
  if (!document.documentElement.lang) say('language', 'none');
  if (!document.title.trim()) say('title', 'none');
  all('table').forEach((t) => {
    if (!t.caption || !t.caption.textContent.trim()) say('caption', 'a table has none');
    all('th', t).forEach((th) => { if (!th.scope) say('scope', th.textContent); });
    all('tbody tr', t).forEach((tr) => {
      if (!tr.querySelector('th')) say('row header', tr.textContent);
    });
  });
  const ids = all('[id]').map((e) => e.id);
  ids.forEach((id, i) => { if (ids.indexOf(id) !== i) say('id twice', id); });
  all('a[href^="#"], use').forEach((e) => {
    const to = e.getAttribute('href').slice(1);
    if (!document.getElementById(to)) say('broken link', to);
  });

  // contrast (WCAG 2, level AA)
  const parse = (c) => {
    const n = c.match(/[\d.]+/g).map(Number);
    return { rgb: n.slice(0, 3), a: n.length > 3 ? n[3] : 1 };
  };
  const light = (rgb) => {
    const f = rgb.map((v) => v / 255).map((v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
    return 0.2126 * f[0] + 0.7152 * f[1] + 0.0722 * f[2];
  };
  const behind = (e) => {
    for (let p = e; p; p = p.parentElement) {
      const c = parse(getComputedStyle(p).backgroundColor);
      if (c.a === 1) return c.rgb;
    }
    return [255, 255, 255];
  };
  const seen = new Set();
  all('p, li, td, th, h1, h2, h3, figcaption, dt, dd, summary, a, code, span, caption, text').forEach((e) => {
    if (!e.textContent.trim() || e.closest('.skip')) return;
    const style = getComputedStyle(e);
    const colour = e.tagName === 'text' ? style.fill : style.color;
    const a = light(parse(colour).rgb);
    const b = light(behind(e));
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const key = colour + behind(e);
    if (ratio < 4.5 && !seen.has(key)) {
      seen.add(key);
      say('contrast', ratio.toFixed(2) + ' ' + e.textContent.trim());
    }
  });

  const report = (violations) => {
    const out = document.createElement('pre');
    out.id = 'findings';
    out.textContent = JSON.stringify({
      width: window.innerWidth,
      dark: window.matchMedia('(prefers-color-scheme: dark)').matches,
      figures: all('figure svg').length,
      findings: findings,
      axe: violations,
    });
    window.parent.document.body.appendChild(out);
  };
  // axe-core, where it is installed: 'impact rule: first of n elements'
  if (!window.axe) {
    report(['not installed']);
    return;
  }
  window.axe.run(document, { resultTypes: ['violations'] }).then((r) => {
    report(r.violations.map((v) => v.impact + ' ' + v.id + ': ' + v.nodes.length +
      ' elements, ' + v.nodes[0].html.slice(0, 90)));
  }, (error) => report(['serious failure: ' + error]));
}());
