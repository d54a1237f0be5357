// What a careful reader would notice on a page. Every check is a function of the document that is shown: it returns a
// line for each thing that is wrong, none for a good page. What a check passes over is named here, with its reason.
window.looking = (() => {
  const WIDER = 1.3;
  const LEAST_TEXT = 9; // pixels
  const said = (text) => text.trim().replace(/\s+/g, " ").slice(0, 90);
  const named = (e) => {
    const name = e.tagName.toLowerCase() + (e.id ? `#${e.id}` : "") + [...e.classList].map((c) => `.${c}`).join("");
    return `${name} “${said(e.textContent)}”`;
  };
  const isShown = (e) => e.checkVisibility({ opacityProperty: true, visibilityProperty: true });

  // Read out, not shown: copies of formulas, one pixel wide, next to the formulas; words for icons.
  const SPOKEN = "mjx-assistive-mml, .katex-mathml, .visually-hidden";
  // Programs are shown as they are typed, dollars and calls with named arguments included.
  const TYPED = "script, style, template, textarea, .cell_input, :not(pre) > code, dt.sig, .highlight .gp, .highlight-python:not(.notranslate)";

  function* texts(skipped) {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const node = walker.currentNode;
      if (node.data.trim() && !node.parentElement.closest(skipped)) yield node;
    }
  }

  function formulaErrors() {
    const broken = document.querySelectorAll(".katex-error, mjx-merror, merror, [data-mml-node=merror], [data-mjx-error]");
    // an unknown command: written in red by MathJax and by KaTeX
    const unknown = document.querySelectorAll("mjx-container [data-mml-node=mtext][fill=red], .katex [style*='color:#cc0000']");
    const told = (e) => e.getAttribute("data-mjx-error") || e.getAttribute("title") || e.textContent;
    return [...broken, ...unknown].map((e) => `${e.tagName}: ${said(told(e))}`);
  }

  function texAsText() {
    const tex = /\$[^$]*[^$\s]\$|\\\(.+\\\)|\\\[.+\\\]|\\(displaystyle|frac|tfrac|left|right|begin|kappa|gamma|operatorname)\b/s;
    return [...texts(`${TYPED}, ${SPOKEN}`)].filter((n) => tex.test(n.data)).map((n) => said(n.data));
  }

  function machineReprs() {
    const repr = /<[^<>]*\bobject at 0x[0-9a-f]+>|\b[A-Z]\w*\(\w+=[^=]/;
    // objects as Python prints them in brackets: in a printed example, and in the output of a cell, where a list of them
    // is asked for, they are what is shown
    const bracketed = /<(?:[A-Z]\w*[a-z]\w*|formula|kind|claim)(?: (?:at|of|on)\b|[:.]| \w+[,:])[^<>]*>/;
    const PRINTED = ".highlight, .cell_output pre";
    const copy = document.body.cloneNode(true);
    copy.querySelectorAll(TYPED).forEach((e) => e.remove());
    copy.querySelectorAll("p, div, table, tr, td, th, li, dt, dd, pre, h1, h2, h3, h4, summary").forEach((e) => e.before("\n"));
    return copy.textContent
      .split("\n")
      .filter((line) => !/^\s*(>>>|\.\.\.)/.test(line)) // what is typed in an example
      .map((line) => line.match(repr))
      .filter(Boolean)
      .map((found) => said(found.input.slice(found.index)))
      .concat([...texts(`${TYPED}, ${SPOKEN}, ${PRINTED}`)].filter((n) => bracketed.test(n.data)).map((n) => said(n.data)));
  }

  function tooWide() {
    const found = [];
    for (const e of document.querySelectorAll("body, body *:not(svg *)")) {
      if (!e.clientWidth || e.closest(SPOKEN) || !isShown(e)) continue;
      // scrollWidth: with all that is clipped, scrolled, or stands out
      if (e.scrollWidth > WIDER * e.clientWidth) found.push(e);
    }
    const innermost = found.filter((e) => !found.some((other) => other !== e && e.contains(other)));
    return innermost.map((e) => `${e.scrollWidth} px in ${e.clientWidth}: ${named(e)}`);
  }

  // In a column that is too narrow words are broken inside.
  function brokenWords() {
    const found = new Map();
    const range = document.createRange();
    for (const cell of document.querySelectorAll("td, th")) {
      if (cell.clientWidth > 300 || !isShown(cell)) continue;
      const walker = document.createTreeWalker(cell, NodeFilter.SHOW_TEXT);
      while (walker.nextNode()) {
        const node = walker.currentNode;
        if (node.parentElement.closest(SPOKEN)) continue;
        for (const word of node.data.matchAll(/\p{L}{2,}/gu)) {
          if (word[0].length > 12) continue; // those are broken in books, too
          const around = /\S*$/.exec(node.data.slice(0, word.index))[0] + /^\S*/.exec(node.data.slice(word.index))[0];
          if (around.length > 12 && /[/_\d]/.test(around)) continue; // a digest, the path of a file: no word of prose
          range.setStart(node, word.index);
          range.setEnd(node, word.index + word[0].length);
          const lines = new Set([...range.getClientRects()].map((box) => Math.round(box.top)));
          if (lines.size > 1) found.set(word[0], `${word[0]} in ${cell.clientWidth} px: ${named(cell)}`);
        }
      }
    }
    return [...found.values()];
  }

  function horizontalScroll() {
    const { scrollWidth, clientWidth } = document.documentElement;
    return scrollWidth > clientWidth ? [`${scrollWidth} px in a window of ${clientWidth}`] : [];
  }

  // ---- colours

  const one = Object.assign(document.createElement("canvas"), { width: 1, height: 1 });
  const brush = one.getContext("2d", { willReadFrequently: true });
  const parsed = new Map();
  function colour(text) {
    if (!parsed.has(text)) {
      brush.clearRect(0, 0, 1, 1);
      brush.fillStyle = text;
      brush.fillRect(0, 0, 1, 1);
      const [r, g, b, a] = brush.getImageData(0, 0, 1, 1).data;
      parsed.set(text, [r, g, b, a / 255]);
    }
    return parsed.get(text);
  }
  const over = ([r, g, b, a], below) => [r, g, b].map((x, i) => a * x + (1 - a) * below[i]);
  // Relative luminance and contrast as the guidelines for accessible content define them (WCAG 2, sRGB).
  const linear = (x) => (x / 255 <= 0.04045 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  function contrast(a, b) {
    const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (light + 0.05) / (dark + 0.05);
  }
  // What an element has from those that it stands in: asked once of each while nothing changes.
  function inherited(found) {
    const known = new Map();
    const ask = (e) => known.get(e) ?? known.set(e, found(e, ask)).get(e);
    return ask;
  }
  const grounds = () => inherited((e, ground) => {
    if (!e) return colour(systemGround()).slice(0, 3);
    const above = colour(getComputedStyle(e).backgroundColor);
    return above[3] === 1 ? above.slice(0, 3) : over(above, ground(e.parentElement));
  });
  function systemGround() {
    const probe = document.documentElement.appendChild(document.createElement("i"));
    probe.style.backgroundColor = "Canvas"; // what the theme of the browser gives a page without a colour
    const found = getComputedStyle(probe).backgroundColor;
    probe.remove();
    return found;
  }
  const opacities = () => inherited((e, opacity) => (e ? Number(getComputedStyle(e).opacity) * opacity(e.parentElement) : 1));

  function poorContrast() {
    const seen = new Map();
    const [ground, opacity] = [grounds(), opacities()];
    const writers = new Set([...texts(`script, style, template, noscript, ${SPOKEN}`)].map((n) => n.parentElement));
    document.querySelectorAll("mjx-container").forEach((e) => writers.add(e)); // letters drawn as paths
    for (const e of writers) {
      if (!isShown(e) || e.closest(":disabled, svg defs")) continue; // the guidelines pass over what cannot be used
      const style = getComputedStyle(e);
      const inPicture = e.closest("svg") && !e.closest("mjx-container");
      const ink = colour(inPicture ? style.fill : style.color);
      const below = ground(e);
      const size = parseFloat(style.fontSize);
      const isLarge = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
      const reached = contrast(over([ink[0], ink[1], ink[2], ink[3] * opacity(e)], below), below);
      if (reached < (isLarge ? 3 : 4.5)) {
        const key = `${style.color} on ${below.map(Math.round)}: ${reached.toFixed(2)}`;
        if (!seen.has(key)) seen.set(key, `${key}, ${named(e)}`);
      }
    }
    return [...seen.values()];
  }

  function smallText() {
    const found = new Map();
    for (const n of texts(`script, style, template, noscript, ${SPOKEN}`)) {
      const e = n.parentElement;
      if (!isShown(e)) continue;
      const scale = e.getScreenCTM ? Math.hypot(e.getScreenCTM().a, e.getScreenCTM().b) : 1;
      const size = parseFloat(getComputedStyle(e).fontSize) * scale;
      // indices of indices are small in every book
      if (size < LEAST_TEXT && !e.closest("sub sub, sub sup, sup sub, sup sup, .katex, math")) found.set(Math.round(size), named(e));
    }
    return [...found].map(([size, e]) => `${size} px: ${e}`);
  }

  // ---- pictures

  function filters(e) {
    if (!e) return "";
    const own = getComputedStyle(e).filter;
    return `${own === "none" ? "" : own} ${filters(e.parentElement)}`.trim();
  }

  // A picture lies on its page like ink on paper: its border is as light or as dark as what is around it.
  function strangeGrounds() {
    const SIDE = 48;
    const ground = grounds();
    const canvas = Object.assign(document.createElement("canvas"), { width: SIDE, height: SIDE });
    const pen = canvas.getContext("2d", { willReadFrequently: true });
    const found = [];
    for (const e of document.querySelectorAll("img")) {
      if (!isShown(e) || !e.naturalWidth) continue;
      const around = ground(e.parentElement);
      pen.filter = "none";
      pen.fillStyle = getComputedStyle(e).backgroundColor;
      pen.clearRect(0, 0, SIDE, SIDE);
      pen.fillRect(0, 0, SIDE, SIDE);
      pen.filter = filters(e) || "none";
      pen.drawImage(e, 0, 0, SIDE, SIDE);
      const pixels = pen.getImageData(0, 0, SIDE, SIDE).data;
      const at = (x, y) => {
        const [r, g, b, a] = pixels.slice(4 * (y * SIDE + x), 4 * (y * SIDE + x) + 4);
        return over([r, g, b, a / 255], around);
      };
      const last = SIDE - 1;
      const border = [...Array(SIDE).keys()].flatMap((k) => [at(k, 0), at(k, last), at(0, k), at(last, k)]);
      const strange = border.filter((c) => contrast(c, around) > 1.6).length;
      if (strange > border.length / 2) found.push(`a border unlike the page: ${e.src.split("/").pop().slice(0, 60)}`);
    }
    for (const e of document.querySelectorAll("svg")) {
      const own = colour(getComputedStyle(e).backgroundColor);
      const around = ground(e.parentElement);
      if (isShown(e) && !filters(e) && own[3] && contrast(over(own, around), around) > 1.6) found.push(named(e));
    }
    return found;
  }

  function withoutAlternative() {
    const isFile = (text) => /\.(png|svg|jpe?g|gif)$/i.test(text);
    const label = (e) => e.getAttribute("aria-label") || e.querySelector?.(":scope > title")?.textContent || e.getAttribute("title") || "";
    const found = [...document.querySelectorAll("img, area, input[type=image]")].filter((e) => !e.alt.trim() || isFile(e.alt));
    // a drawing beside words in a button or a link is not read out; a formula is spoken by its own copy
    const drawn = "svg, canvas, iframe, object, embed";
    const passed = ":scope:is(mjx-container *, .katex *, button *, label *, a *, [aria-hidden=true], [aria-hidden=true] *, svg svg)";
    found.push(...[...document.querySelectorAll(drawn)].filter((e) => isShown(e) && !e.matches(passed.replace(":scope", "")) && !label(e).trim()));
    return found.map((e) => `${e.tagName.toLowerCase()} ${said(e.src ? e.src.split("/").pop() : e.outerHTML)}`);
  }

  function links() {
    return [...document.querySelectorAll("a[href], area[href]")].map((e) => e.href);
  }

  function anchors() {
    return [...document.querySelectorAll("[id], a[name]")].map((e) => e.id || e.name);
  }

  const frame = () => new Promise((drawn) => requestAnimationFrame(drawn));
  // What a page still does after it was opened, or after its window has another width.
  async function settled() {
    await frame().then(frame);
    await document.fonts.ready;
    await window.MathJax?.startup?.promise;
    await Promise.all([...document.images].map((image) => { image.loading = "eager"; return image.decode().catch(() => null); }));
    await frame().then(frame);
  }

  return {
    settled, links, anchors,
    checks: { formulaErrors, texAsText, machineReprs, tooWide, brokenWords, horizontalScroll, poorContrast, smallText, strangeGrounds, withoutAlternative },
  };
})();
