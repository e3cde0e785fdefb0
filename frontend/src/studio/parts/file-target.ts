// Parts of the page that files can be dropped onto.

/** Mark a part while files are dragged over it; one that `take` takes goes no further. */
export function listenForFiles(element: HTMLElement, take: (file: File) => boolean = () => false): void {
  element.addEventListener("dragover", (event) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    element.classList.add("dropping");
  });
  element.addEventListener("dragleave", (event) => {
    if (!element.contains(event.relatedTarget as Node | null)) element.classList.remove("dropping");
  });
  element.addEventListener("drop", (event) => {
    element.classList.remove("dropping");
    const file = event.dataTransfer?.files[0];
    if (!file || !take(file)) return;
    event.preventDefault();
    event.stopPropagation();
  });
}

/** Whether a file has one of the endings of a list: ".svg,.dxf". */
export function hasEnding(file: File, endings: string): boolean {
  return endings.split(",").some((ending) => file.name.toLowerCase().endsWith(ending));
}
