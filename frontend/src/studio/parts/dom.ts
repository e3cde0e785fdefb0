// Elements in one expression.

type Attribute = string | number | boolean | null | undefined | ((event: never) => void);
type Child = Node | string | null | undefined | false;

/** An HTML element; attributes that begin with "on" are listeners, null and false are left out. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, Attribute> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  return fill(document.createElement(tag), attributes, children);
}

/** An SVG element. */
export function s<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Record<string, Attribute> = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

function fill<E extends Element>(
  element: E,
  attributes: Record<string, Attribute>,
  children: Child[],
): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") {
      element.addEventListener(name.slice(2).toLowerCase(), value as EventListener);
    } else {
      setAttribute(element, name, value);
    }
  }
  for (const child of children) {
    if (child !== null && child !== undefined && child !== false) element.append(child);
  }
  return element;
}

export function setAttribute(element: Element, name: string, value: Attribute): void {
  if (value === null || value === undefined || value === false) element.removeAttribute(name);
  else element.setAttribute(name, value === true ? "" : String(value));
}

/** Change what may hold the focus: an element that is put in anew keeps it, or the one of its name that
 * takes its place. */
export function keepFocus(change: () => void): void {
  const held = document.activeElement as HTMLElement | null;
  change();
  if (!held || held === document.activeElement) return;
  const { testid } = held.dataset;
  const next = held.isConnected ? held : testid ? document.querySelector<HTMLElement>(`[data-testid="${testid}"]`) : null;
  next?.focus({ preventScroll: true });
}

/** A frame that keys reach where not all of its content has room. */
export function scrolledByKeys(frame: HTMLElement): HTMLElement {
  const observer = new ResizeObserver(() => {
    frame.tabIndex = frame.scrollHeight > frame.clientHeight ? 0 : -1;
  });
  for (const each of [frame, ...frame.children]) observer.observe(each);
  return frame;
}

let counter = 0;
/** An id that no other element of the page has. */
export function uniqueId(stem: string): string {
  return `${stem}-${++counter}`;
}

/** Hand a file to the browser's downloads. */
export function download(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  const link = h("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Ask for a file. */
export function pickFile(accept: string): Promise<File | null> {
  return new Promise((resolve) => {
    const input = h("input", { type: "file", accept, hidden: true });
    input.addEventListener("change", () => {
      resolve(input.files?.[0] ?? null);
      input.remove();
    });
    input.addEventListener("cancel", () => {
      resolve(null);
      input.remove();
    });
    document.body.append(input);
    input.click();
  });
}
