// How many requests may be under way: one where the server is near, several where the network takes
// most of their time, so that a drag is not as slow as that.

/** Requests under way at a time, at most. */
export const MOST = 4;
/** The network is slow if it takes longer than this (milliseconds), and longer than the server. */
const SLOW = 200;

export class Flights {
  /** Requests under way. */
  under = 0;
  private network = 0;
  private whole = 0;
  private last = -Infinity;

  /** Milliseconds until another may begin; infinite: not before one has ended. */
  wait(now: number): number {
    if (this.under === 0) return 0;
    const far = this.network > SLOW && this.network > this.whole / 2;
    if (!far || this.under >= MOST) return Infinity;
    return Math.max(0, this.last + this.whole / MOST - now);
  }

  begin(now: number): void {
    this.under++;
    this.last = now;
  }

  /** An answer has come: how long it took in all, and how much of that the server. */
  answered(whole: number, server: number): void {
    this.whole = whole;
    this.network = whole - server;
  }

  end(): void {
    this.under--;
  }
}
