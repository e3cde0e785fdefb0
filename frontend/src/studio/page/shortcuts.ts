// Keys that work everywhere on the page.

export interface Shortcuts {
  undo(): void;
  redo(): void;
  open(): void;
  save(): void;
  help(): void;
  play(): void;
  fit(): void;
}

export function listenForShortcuts(act: Shortcuts): void {
  document.addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    const target = event.target as HTMLElement;
    const typing = target instanceof HTMLInputElement && target.type === "text";
    if (event.ctrlKey || event.metaKey) {
      if (key === "s") {
        settle();
        act.save();
      } else if (key === "o") act.open();
      else if (key === "z" && !typing) (event.shiftKey ? act.redo : act.undo)();
      else if (key === "y" && !typing) act.redo();
      else return;
      event.preventDefault();
      return;
    }
    if (event.altKey || target.closest("input, select, textarea, dialog[open], :popover-open")) return;
    if (key === "?") act.help();
    else if (key === "f") act.fit();
    else if (key === " " && !target.closest("button, summary, [role=button]")) act.play();
    else return;
    event.preventDefault();
  });
}

/** What is being typed is taken first: boxes that are read on change are left for that. */
function settle(): void {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement || field instanceof HTMLTextAreaElement)) return;
  field.blur();
  field.focus({ preventScroll: true });
}
