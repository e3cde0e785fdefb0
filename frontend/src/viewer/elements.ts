// Elements of the page.

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K, name: string, attributes: Record<string, string> = {}, text = "",
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (name) made.className = name;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text) made.textContent = text;
  return made;
}

let groups = 0;

/** A radio button or check box drawn as its label. */
export function toggle(
  type: "radio" | "checkbox", text: string, checked: boolean, change: (on: boolean) => void, group: string, value: string,
): HTMLElement {
  const label = element("label", "toggle");
  const input = element("input", "", { type, name: `${group}-${groups}`, value });
  input.checked = checked;
  input.addEventListener("change", () => change(input.checked));
  label.append(input, element("span", "", {}, text));
  return label;
}

/** Radio buttons of another viewer on the page are another group. */
export function nextGroup(): void {
  groups++;
}
