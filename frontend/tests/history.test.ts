import { beforeEach, describe, expect, test } from "vitest";

import { History } from "../src/studio/state/history.ts";

let history: History<number>;
beforeEach(() => {
  history = new History(0);
});

test("undo and redo go through the values and name the steps", () => {
  history.push(1, "one");
  history.push(2, "two");
  expect(history.undoable).toBe("two");
  expect(history.undo()).toBe(true);
  expect(history.value).toBe(1);
  expect(history.redoable).toBe("two");
  history.undo();
  expect(history.value).toBe(0);
  expect(history.undo()).toBe(false);
  history.redo();
  history.redo();
  expect(history.value).toBe(2);
  expect(history.redo()).toBe(false);
});

test("undo goes back to a value at once, and only to one that there was", () => {
  history.push(1, "one");
  history.push(2, "two");
  expect(history.undoTo(7)).toBe(false);
  expect(history.value).toBe(2);
  expect(history.undoTo(0)).toBe(true);
  expect(history.value).toBe(0);
  history.redo();
  history.redo();
  expect(history.value).toBe(2);
});

test("a new value after an undo ends what could be redone", () => {
  history.push(1, "one");
  history.undo();
  history.push(3, "three");
  expect(history.redoable).toBeNull();
  history.undo();
  expect(history.value).toBe(0);
});

describe("changes of one gesture are one step", () => {
  test("within a second of each other", () => {
    history.push(1, "typed", "type", 0);
    history.push(2, "typed", "type", 900);
    history.push(3, "typed", "type", 1800);
    history.undo();
    expect(history.value).toBe(0);
  });

  test("not after a pause, nor with another name", () => {
    history.push(1, "typed", "type", 0);
    history.push(2, "typed", "type", 1000);
    history.push(3, "turned", "turn", 1001);
    history.undo();
    expect(history.value).toBe(2);
    history.undo();
    expect(history.value).toBe(1);
  });

  test("however long a drag lasts, until it is let go", () => {
    history.push(1, "dragged", "drag!", 0);
    history.push(2, "dragged", "drag!", 60_000);
    history.rest();
    history.push(3, "dragged", "drag!", 60_001);
    history.undo();
    expect(history.value).toBe(2);
    history.undo();
    expect(history.value).toBe(0);
  });

  test("nor is what follows an undo part of the gesture before it", () => {
    history.push(1, "typed", "type", 0);
    history.push(2, "turned", "turn", 1);
    history.undo();
    history.push(3, "turned", "turn", 2);
    history.undo();
    expect(history.value).toBe(1);
  });
});

test("two hundred steps are kept", () => {
  for (let value = 1; value <= 250; value++) history.push(value, "step");
  let steps = 0;
  while (history.undo()) steps++;
  expect(steps).toBe(200);
  expect(history.value).toBe(50);
});
