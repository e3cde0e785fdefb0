import { describe, expect, it } from "vitest";
import { Flights, MOST } from "../src/studio/server/flights.ts";

describe("requests under way", () => {
  it("are one at a time before anything is known, and with a server that is near", () => {
    const flights = new Flights();
    expect(flights.wait(0)).toBe(0);
    flights.begin(0);
    expect(flights.wait(10)).toBe(Infinity);
    flights.answered(60, 50);
    flights.end();
    flights.begin(70);
    expect(flights.wait(1000)).toBe(Infinity);
  });

  it("are one at a time where the server takes the time", () => {
    const flights = new Flights();
    flights.begin(0);
    flights.answered(900, 800);
    expect(flights.wait(2000)).toBe(Infinity);
  });

  it("are several in even steps where the network takes it, and no more than so many", () => {
    const flights = new Flights();
    flights.begin(0);
    flights.answered(800, 40);
    flights.end();
    for (let k = 0; k < MOST; k++) {
      expect(flights.wait(1000 + 200 * k)).toBe(0);
      flights.begin(1000 + 200 * k);
      expect(flights.wait(1050 + 200 * k)).toBe(k + 1 < MOST ? 150 : Infinity);
    }
    flights.end();
    expect(flights.wait(2000)).toBe(0);
  });
});
