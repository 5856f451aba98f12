// Looks at the page as it is laid out: what is cut, sticks out or lies over something else. Tells the page that holds
// it in a frame.
(async () => {
  const wrong = [], root = document.documentElement;
  for (let k = 0; k < 400 && !root.dataset.ready; ++k) await new Promise((go) => setTimeout(go, 20));
  const wide = root.clientWidth;
  const name = (e) => `${e.tagName.toLowerCase()}${e.id ? `#${e.id}` : ""} "${e.textContent.trim().slice(0, 30)}"`;
  const seen = (e) => e.checkVisibility({ visibilityProperty: true }) && e.getBoundingClientRect().width > 0;
  const inScroller = (e) => e && e !== document.body && (/auto|scroll|hidden/.test(getComputedStyle(e).overflowX) || inScroller(e.parentElement));

  if (root.scrollWidth > wide) wrong.push(`the page is ${root.scrollWidth} px wide`);
  for (const e of document.querySelectorAll("body *:not(script, style, svg *)")) {
    if (e.closest("dialog, .skip") || !seen(e)) continue;
    const box = e.getBoundingClientRect(), style = getComputedStyle(e);
    if ((box.right > wide + 1 || box.left < -1) && !inScroller(e.parentElement)) wrong.push(`${name(e)} sticks out`);
    if (e.scrollWidth <= e.clientWidth + 1) continue;
    if (style.overflowX === "hidden") wrong.push(`${name(e)} is cut`);
    // On a phone wide tables and drawings scroll by themselves, and so does the bar of contents.
    if (style.overflowX === "auto" && wide > 720) wrong.push(`${name(e)} scrolls sideways`);
  }

  const boxes = (list) => [...list].filter(seen).map((e) => [e, e.getBoundingClientRect()]);
  const overlaps = (list, slack, tell) => list.forEach(([e, a], i) => list.slice(0, i).forEach(([other, b]) => {
    const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
    if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 2 && high > slack * Math.min(a.height, b.height)) tell(e, other);
  }));
  for (const leader of document.querySelectorAll(".podium li"))
    overlaps(boxes(leader.children), 0.2, (a, b) => wrong.push(`${name(a)} lies over ${name(b)}`));
  const starts = new Set([...document.querySelectorAll(".podium .loadbar")].map((bar) => Math.round(bar.getBoundingClientRect().left)));
  if (starts.size > 1) wrong.push(`the leaders' bars begin at ${[...starts]}`);

  for (const drawing of document.querySelectorAll("svg")) {
    if (drawing.closest("dialog") || !seen(drawing)) continue;
    const frame = drawing.getBoundingClientRect(), where = drawing.closest("[id]")?.id;
    const words = boxes(drawing.querySelectorAll("text")).filter(([e]) => e.textContent.trim());
    for (const [e, box] of words)
      if (box.left < frame.left - 2 || box.right > frame.right + 2 || box.top < frame.top - 2 || box.bottom > frame.bottom + 2)
        wrong.push(`${where}: ${name(e)} leaves the drawing`);
    overlaps(words, 0.45, (a, b) => wrong.push(`${where}: ${name(a)} lies over ${name(b)}`)); // boxes are higher than letters
  }
  return wrong;
})().catch((error) => [`the layout was not looked at: ${error}`]).then((wrong) => parent.postMessage({ wide: innerWidth, wrong }, "*"));
