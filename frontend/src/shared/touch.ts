// A view in a page that scrolls: a finger that begins on what is drawn turns it, and so do two; a
// vertical swipe elsewhere scrolls the page.

/** Room for a finger around what is drawn, in pixels. */
const FINGER = 18;
const AROUND = [[0, 0], [FINGER, 0], [-FINGER, 0], [0, FINGER], [0, -FINGER]] as const;

/** `drawnAt` says whether something is drawn at a place of the window. */
export function shareTouch(canvas: HTMLElement, drawnAt: (x: number, y: number) => boolean): void {
  canvas.style.touchAction = "pan-y";
  canvas.addEventListener("touchstart", (event) => {
    const page = document.scrollingElement;
    const scrolls = page !== null && page.scrollHeight > page.clientHeight + 1;
    const { clientX: x, clientY: y } = event.touches[0]!;
    const own = event.touches.length > 1 || !scrolls || AROUND.some(([dx, dy]) => drawnAt(x + dx, y + dy));
    // What is not prevented is the page's.
    if (own && event.cancelable) event.preventDefault();
  }, { passive: false });
}
