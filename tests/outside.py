"""That nothing of a page lies outside its box, whatever the width and the colours.

What is cut without a sign of it, what runs out of the box that it stands in, and what makes a page
scroll sideways are one fault: a part of the page that nobody sees.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from viewer_pages import await_frames

if TYPE_CHECKING:
    from playwright.sync_api import Page

WIDTHS = {1440: 900, 1024: 768, 820: 1180, 390: 844}
"""A desk, a small laptop, a tablet and a phone: width to height."""
SIDEWAYS = "pre, table, math, .table-wrapper, .math-wrapper, .sheet-paper"
"""What may be read by scrolling sideways: code, tables, formulas, and pages of a booklet, which are
no smaller than one can read; nothing else."""

DRAWERS = ".sidebar-drawer, .toc-drawer"
"""What the site keeps beside the window until it is called; what is drawn out is looked at."""

OUTSIDE = """([sideways, drawers]) => {
  const wrong = new Set(), NEAR = 1.5, root = document.documentElement;
  const styles = new Map(), boxes = new Map(), rooms = new Map(), hidden = new Map();
  const kept = (map, key, make) => map.get(key) ?? map.set(key, make(key)).get(key);
  const style = (each) => kept(styles, each, getComputedStyle);
  const box = (each) => kept(boxes, each, (it) => it.getBoundingClientRect());
  const up = (each) => each.parentElement ?? each.getRootNode().host ?? null;
  const isPage = (each) => each === root || each === document.body;
  const inline = (each) =>
    /^(inline|contents)$/.test(style(each).display) && each.localName !== "svg";
  const block = (each) => (inline(each) && up(each) ? block(up(each)) : each);
  const scrolls = (value) => value === "auto" || value === "scroll";
  const nameOf = (each) => {
    const name = each.dataset?.testid || each.getAttribute("aria-label") || each.id;
    return [each.localName, ...each.classList].join(".") + (name ? ` (${name})` : "");
  };
  // For readers of screens only, or faded out.
  const unseen = (each) => kept(hidden, each, () => {
    const { clipPath, clip, opacity } = style(each);
    if (clipPath.startsWith("inset(50%") || clip.startsWith("rect(")) return true;
    return opacity === "0" || (up(each) ? unseen(up(each)) : false);
  });
  // The rooms that cut or scroll what is inside a box, from the nearest to the page.
  const inner = (each) => kept(rooms, each, () => {
    const { overflowX, overflowY, textOverflow } = style(each);
    const around = outer(each);
    if (isPage(each) || inline(each)) return around;
    if (overflowX === "visible" && overflowY === "visible") return around;
    const left = box(each).left + each.clientLeft, top = box(each).top + each.clientTop;
    const [wide, high] = each.localName === "svg"
      ? [box(each).width, box(each).height] : [each.clientWidth, each.clientHeight];
    const over = each.scrollWidth - each.clientWidth;
    if (scrolls(overflowX) && over > NEAR && !each.matches(sideways)) {
      wrong.add(`${nameOf(each)} scrolls sideways, by ${over}`);
    }
    if (style(each).scrollbarWidth === "none" && each.scrollHeight > each.clientHeight + NEAR) {
      wrong.add(`${nameOf(each)} scrolls and does not show it`);
    }
    return { each, around, overflowX, overflowY, left, top, right: left + wide,
      bottom: top + high, dots: textOverflow === "ellipsis" };
  });
  const outer = (each) => {
    const { position } = style(each);
    if (position === "fixed" || !up(each)) return null;
    return inner((position === "absolute" && each.offsetParent) || up(each));
  };
  // A box or a line of text in the rooms around it; letters may reach a little out of their line.
  const cut = (what, room, said, letters) => {
    let { left, right, top, bottom } = what;
    for (let at = room; at; at = at.around) {
      const x = scrolls(at.overflowX), y = scrolls(at.overflowY);
      const first = at.left - (x ? at.each.scrollLeft : 0);
      const highest = at.top - (y ? at.each.scrollTop : 0);
      const name = nameOf(at.each);
      if (left < first - NEAR) wrong.add(`${said} is cut by ${name} on its left`);
      if (!x && !at.dots && right > at.right + NEAR) {
        wrong.add(`${said} is cut by ${name} on its right, by ${Math.round(right - at.right)}`);
      }
      if (top < highest - NEAR - letters) wrong.add(`${said} is cut by ${name} at its top`);
      if (!y && bottom > at.bottom + NEAR + letters) {
        wrong.add(`${said} is cut by ${name} at its foot, by ${Math.round(bottom - at.bottom)}`);
      }
      [left, right] = [Math.max(left, at.left), Math.min(right, at.right)];
      [top, bottom] = [Math.max(top, at.top), Math.min(bottom, at.bottom)];
      if (right - left < 0.5 || bottom - top < 0.5) return;
    }
    if (left < -NEAR || right > root.clientWidth + NEAR) {
      wrong.add(`${said} is outside the window: ${Math.round(left)} to ${Math.round(right)}`);
    }
  };
  // In the box that it stands in, whether that cuts or not.
  const within = (what, around, said, letters, left = 0, right = 0, foot = 0) => {
    if (isPage(around)) return;
    const room = box(around), { overflowX, overflowY, textOverflow } = style(around);
    if (!scrolls(overflowX) && !(textOverflow === "ellipsis" && overflowX !== "visible")) {
      const beyond = Math.max(what.right - room.right + right, room.left - what.left + left);
      if (beyond > NEAR) {
        wrong.add(`${said} runs out of ${nameOf(around)} sideways, by ${Math.round(beyond)}`);
      }
    }
    const below = what.bottom - room.bottom + foot - letters;
    if (!scrolls(overflowY) && below > NEAR) {
      wrong.add(`${said} runs out of ${nameOf(around)} below, by ${Math.round(below)}`);
    }
  };
  const LEFT_OUT = /^(script|style|noscript|template|option|optgroup|title|head|meta|link)$/;
  const look = (each) => {
    if (LEFT_OUT.test(each.localName) || each instanceof MathMLElement) return;
    if (each.ownerSVGElement && each.localName !== "text") return [...each.children].forEach(look);
    if (each.matches(drawers) && style(each).position === "fixed"
        && (box(each).right <= 0 || box(each).left >= root.clientWidth)) return;
    if (!each.checkVisibility({ visibilityProperty: true })) {
      if (style(each).display === "none") return;
    } else if (!isPage(each) && !unseen(each) && box(each).width > 0.5 && box(each).height > 0.5) {
      const { position, float, textOverflow, marginLeft, marginRight, marginBottom } = style(each);
      const letters = 0.3 * parseFloat(style(each).fontSize);
      if (!inline(each) || each.matches("img, canvas, svg, input, select, text")) {
        cut(box(each), outer(each), nameOf(each), 0);
        if (/^(static|relative)$/.test(position) && float === "none" && !each.ownerSVGElement) {
          const margins = [marginLeft, marginRight, marginBottom];
          const drawn = margins.map((margin) => Math.min(0, parseFloat(margin)));
          within(box(each), block(up(each)), nameOf(each), 0, ...drawn);
        }
      }
      if (each.matches("select, button") && each.scrollWidth > each.clientWidth + NEAR
          && textOverflow !== "ellipsis") wrong.add(`the text of ${nameOf(each)} is cut`);
      for (const node of each.ownerSVGElement ? [] : each.childNodes) {
        if (node.nodeType !== Node.TEXT_NODE || !node.data.trim()) continue;
        const said = `“${node.data.trim().replace(/\\s+/g, " ").slice(0, 40)}”`;
        const range = document.createRange();
        range.selectNodeContents(node);
        for (const line of range.getClientRects()) {
          if (line.width < 0.5) continue;
          cut(line, inner(each), said, letters);
          within(line, block(each), said, letters);
        }
      }
    }
    for (const child of [...(each.shadowRoot?.children ?? []), ...each.children]) look(child);
  };
  look(root);
  const over = root.scrollWidth - root.clientWidth;
  if (over > NEAR) wrong.add(`the page scrolls sideways, by ${over}`);
  return [...wrong];
}"""

THEME = """(theme) => {
  if (window.orishell?.theme) window.orishell.theme.set(theme);
  else for (const each of [document.documentElement, document.body]) each.dataset.theme = theme;
}"""

OPEN_ALL = "for (const each of document.querySelectorAll('details')) each.open = true;"
CLOSE = """(kept) => {
  for (const [k, each] of [...document.querySelectorAll("details")].entries()) each.open = kept[k];
}"""
STATES = "[...document.querySelectorAll('details')].map((each) => each.open)"


def outside(page: Page) -> list[str]:
    """What lies outside its box in a page as it stands."""
    found: list[str] = page.evaluate(OUTSIDE, [SIDEWAYS, DRAWERS])
    return found


def outside_anywhere(page: Page, *, opens: bool = False) -> dict[str, list[str]]:
    """What lies outside its box at every width, on light and on dark ground: by these.

    With ``opens`` also with all open that opens.
    """
    found = {}
    for width, height in WIDTHS.items():
        page.set_viewport_size({"width": width, "height": height})
        await_frames(page)
        for theme in ("light", "dark"):
            page.emulate_media(color_scheme=theme)
            page.evaluate(THEME, theme)
            found[f"{width}, {theme}"] = outside(page)
            if opens:
                kept = page.evaluate(STATES)
                page.evaluate(OPEN_ALL)
                found[f"{width}, {theme}, open"] = outside(page)
                page.evaluate(CLOSE, kept)
    return {at: wrong for at, wrong in found.items() if wrong}
