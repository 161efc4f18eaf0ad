// The point that is chosen: one for the whole page.

export class Selection {
  #index = 0;
  #count;
  #listeners = [];

  constructor(count) {
    this.#count = count;
  }
  get index() {
    return this.#index;
  }
  /// Tells all listeners, those that are added later as well.
  choose(index) {
    const wanted = Math.max(0, Math.min(this.#count - 1, Math.round(index)));
    if (!Number.isFinite(wanted)) return;
    this.#index = wanted;
    for (const listener of this.#listeners) listener(wanted);
  }
  onChange(listener) {
    this.#listeners.push(listener);
    listener(this.#index);
  }
  /// Arrow keys, Page Up and Down, Home and End of an element that can have the focus.
  followKeys(node) {
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
    node.addEventListener("keydown", (event) => {
      const page = Math.max(1, Math.round(this.#count / 20));
      let to;
      if (event.key in steps) to = this.#index + steps[event.key];
      else if (event.key === "PageUp") to = this.#index + page;
      else if (event.key === "PageDown") to = this.#index - page;
      else if (event.key === "Home") to = 0;
      else if (event.key === "End") to = this.#count - 1;
      else return;
      event.preventDefault();
      this.choose(to);
    });
  }
}
