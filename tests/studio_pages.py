"""The studio's page in a real browser, for the tests that use it: open it, wait, drag, fold."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing, contextmanager
from typing import TYPE_CHECKING, Any

from viewer_pages import await_frames, listen, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, Page

SIZES: dict[str, dict[str, Any]] = {
    "laptop": {"width": 1280, "height": 720},
    "phone": {"width": 390, "height": 844, "has_touch": True, "is_mobile": True},
    "tablet": {"width": 820, "height": 1180, "has_touch": True},
    "desktop": {"width": 1920, "height": 1080},
}
"""Sizes at which the studio is tested, as arguments of :func:`opened`, unlike ones first."""
IDLE = "window.__orishell !== undefined && window.__orishell.idle"
DRAWN = "window.__orishell.store.freshness.value !== 'computing'"
READ = "window.__orishell.store.files.value === 0"

FREE = """(() => {
    const { shell3d } = window.__orishell, place = () => shell3d.camera.position.clone();
    for (let panel = 0; panel < shell3d.motion.panels; panel++) {
        const corner = (k) => shell3d.motion.at(4 * panel + k, place());
        const [x, y] = shell3d.onScreen(corner(0).add(corner(2)).multiplyScalar(0.5));
        const free = document.elementFromPoint(x, y) === shell3d.canvas;
        if (free && shell3d.under(x, y)?.panel === panel) return [x, y];
    }
})()"""
"""The middle of a panel that is seen, and lies under no control."""

TOUCHING = """() => {
    const store = window.__orishell.store, design = structuredClone(store.design.value);
    design.target = {
        f: { formula: "-0.3*x**2", range: [-1, 1] },
        g: { formula: ["4*cos(t)", "4*sin(t)"], range: [0, 2 * Math.PI] },
    };
    Object.assign(design.pattern, { columns: 30, xi_deg: 90 });
    store.change(design, "ring");
}"""
"""Opens a ring whose ends meet before it is closed (as in test_app.py)."""


@contextmanager
def opened(
    browser: Browser, address: str, *, width: int = 1280, height: int = 720, **options: Any
) -> Iterator[Page]:
    """The studio's page, its first shell drawn; the proof of that goes on.

    At the end it must have printed no error and asked no other machine. Its address is the one that
    the studio prints, with its key.
    """
    place = address.partition("?")[0]
    asked: list[str] = []
    with closing(browser.new_page(viewport={"width": width, "height": height}, **options)) as page:
        said = listen(page, "error", "warning")
        page.on("request", lambda request: asked.append(request.url))
        page.goto(address)
        wait_until(page, f"window.__orishell !== undefined && {READ} && {DRAWN}")
        yield page
    # A design that cannot be made is answered with status 422, which the browser prints.
    unexpected = [each for each in said if "status of 422" not in each]
    assert not unexpected, unexpected
    assert [url for url in asked if not url.startswith((place, "blob:", "data:"))] == []


def settle(page: Page) -> None:
    """Wait until all is known of the design, the proof too."""
    await_frames(page)  # what was typed or dragged has been taken up
    wait_until(page, IDLE)


def drawn(page: Page) -> None:
    """Wait until the shell of the design is drawn, or refused."""
    await_frames(page)
    wait_until(page, f"{READ} && {DRAWN}")
    await_frames(page)


def in_bar(page: Page, name: str) -> Locator:
    """A control of the toolbar, whose menu is opened if it stands in that: on a phone."""
    menu = page.get_by_test_id("toolbar-more")
    found = page.get_by_test_id(name)
    if menu.is_visible() and not found.is_visible():
        menu.click()
    return found


def choose(page: Page, family: str) -> None:
    in_bar(page, "examples").click()
    page.get_by_test_id(f"example-{family}").click()
    drawn(page)
    assert page.evaluate("window.__orishell.report.family") == family


def take_family(page: Page, family: str) -> None:
    """Choose another family for the design that is open."""
    card = page.locator(f"label:has([data-testid=family-{family}])")
    if not card.is_visible():
        page.get_by_test_id("families-more").click()
    card.click()


def all_formats(page: Page) -> None:
    """In the window of files: every format, whatever it is for."""
    page.locator("label:has([data-testid=task-all])").click()


def figures(page: Page) -> str:
    return page.get_by_test_id("figures").inner_text()


def drag(page: Page, test_id: str, right: float, down: float) -> None:
    box = page.get_by_test_id(test_id).bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for step in range(1, 11):
        page.mouse.move(x + right * step / 10, y + down * step / 10)
        await_frames(page)
    page.mouse.up()


DROP = """([name, text]) => {
  const data = new DataTransfer();
  data.items.add(new File([text], name));
  const options = { dataTransfer: data, bubbles: true, cancelable: true };
  for (const kind of ["dragenter", "dragover", "drop"])
    document.querySelector(".results").dispatchEvent(new DragEvent(kind, options));
  return document.documentElement.classList.contains("dropping-file");
}"""


def drop_file(page: Page, name: str, text: str) -> bool:
    """Drop a file beside the drawings; whether the page still waits for one then."""
    return bool(page.evaluate(DROP, [name, text]))


def fold(page: Page, share: float) -> None:
    slider = page.get_by_test_id("fold-slider")
    slider.evaluate(
        "(box, share) => { box.value = Number(box.min || 0)"
        " + share * (Number(box.max || 1) - Number(box.min || 0));"
        " box.dispatchEvent(new Event('input', { bubbles: true })); }",
        share,
    )
    wait_until(page, f"Math.abs(window.__orishell.fold - {share}) < 1e-3")
    await_frames(page)


def type_into(page: Page, test_id: str, text: str) -> None:
    """Fill a box, and wait for the proof of what it asks for."""
    page.get_by_test_id(test_id).fill(text)
    settle(page)
